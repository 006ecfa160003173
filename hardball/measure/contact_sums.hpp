// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/measure/event_log_hash.hpp"
#include "hardball/measure/tally.hpp"

namespace hardball {

/// Sums over all contacts of a run, in whatever order they are added.
struct ContactSums {
  EventLogHash hash;
  Tally tally;

  void record(const Contact& contact) {
    tally.record(contact);
    hash.record(contact);
  }
  /// Empty sums, for contacts that are added elsewhere.
  ContactSums part() const { return {{}, tally.part()}; }
  /// Adds the sums of a part.
  void add(const ContactSums& part) {
    tally.add(part.tally);
    hash.add(part.hash);
  }
};

}  // namespace hardball
