// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/interaction/contact.hpp"

namespace hardball {

/// Spheres that become one when they touch, with the mass, momentum, angular momentum and volume of both.
struct Merging {
  bool decide(Contact& contact) const {
    contact.outcome = ContactOutcome::merge;
    return false;
  }
  Outcome operator()(const Contact& contact) const { return outcome_of(*this, contact); }

  static void persist(auto& /*archive*/, auto& /*self*/) {}
};

static_assert(Response<Merging>);

}  // namespace hardball
