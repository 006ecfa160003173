// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>

#include "hardball/errors/export.hpp"

namespace hardball {

/// When snapshots are taken. The next one follows from its index alone, so that a run can be taken up at any.
class HARDBALL_EXPORT SnapshotSchedule {
 public:
  static constexpr double kNoTime = std::numeric_limits<double>::infinity();
  static constexpr std::uint64_t kNoContacts = std::numeric_limits<std::uint64_t>::max();

  /// Never.
  SnapshotSchedule() = default;
  /// At the multiples of `interval` [T], beginning with zero.
  static SnapshotSchedule every(double interval);
  /// At zero, at `first` [T], and from there on `per_decade` times while the time grows tenfold, evenly in
  /// its logarithm. Precondition: per_decade > 0.
  static SnapshotSchedule logarithmic(double first, std::uint64_t per_decade);
  /// At the start, and whenever another `count` contacts have happened. Precondition: count > 0.
  static SnapshotSchedule every_contacts(std::uint64_t count);

  /// The time of a snapshot [T]; kNoTime if it depends on contacts, or there is none. One that is past
  /// `until` [T] only because of rounding is at `until`.
  double time(std::uint64_t index, double until = kNoTime) const;
  /// How many contacts have happened at a snapshot; kNoContacts if it depends on the time, or there is none.
  std::uint64_t contacts(std::uint64_t index) const;

  bool is_never() const { return kind_ == Kind::never; }

 private:
  enum class Kind { never, linear, logarithmic, contacts };

  Kind kind_ = Kind::never;
  double interval_ = 0;  // or the first time after zero
  double ratio_ = 1;     // of two times
  std::uint64_t count_ = 0;
};

}  // namespace hardball
