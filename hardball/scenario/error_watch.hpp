// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hardball/describe/field.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/statistics/measurement.hpp"

namespace hardball {

/// Watches whether what a run measures is known as well as its scenario wants, so that it may end.
///
/// It looks when a thousandth of the time from the begin of measuring to `until` has passed, and then
/// whenever that time has grown by a fifth. So a run goes on for at most a fifth longer than it must, and is
/// seldom ended by an error that happens to be estimated too low. What is seen depends on the state at these
/// times alone, and so is the same in a resumed run.
class HARDBALL_EXPORT ErrorWatch {
 public:
  /// Watches nothing.
  ErrorWatch() = default;
  /// Watches nothing if the scenario has no `until_error`. Precondition: the scenario has an end.
  explicit ErrorWatch(const Scenario& scenario);

  /// When to look next, after `now` [T]; infinity if that is of no use.
  double next_look(double now) const;
  /// Whether `now` [T] is a time to look.
  bool is_time_to_look(double now) const;
  /// Looks at what has been measured up to `now` [T]. Error: a quantity is not measured.
  void look(double now, std::span<const Measurement> measurements);
  /// When all errors were small enough [T].
  const std::optional<double>& reached() const { return reached_; }
  /// The quantities whose errors are not small enough, a sentence each. Error: as for look().
  std::vector<std::string> failures(std::span<const Measurement> measurements) const;

 private:
  NamedNumbers wanted_;
  std::string where_;          // for messages
  std::vector<double> looks_;  // in ascending order [T]
  std::optional<double> reached_;
};

}  // namespace hardball
