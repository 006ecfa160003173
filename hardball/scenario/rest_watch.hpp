// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <optional>

#include "hardball/scenario/scenario.hpp"
#include "hardball/theory/rest.hpp"

namespace hardball {

/// Watches whether the spheres of a run have come to rest, from when on nothing more happens. What it sees
/// depends on the state at its times alone, and so is the same in a resumed run.
class RestWatch {
 public:
  /// Watches nothing.
  RestWatch() = default;
  /// `totals`: of all `spheres` at any time. Watches nothing unless the scenario settles.
  RestWatch(const Scenario& scenario, const Totals& totals, std::size_t spheres) {
    if (scenario.settles && spheres > 0)
      rest_.emplace(totals, spheres, scenario.dimensions() == 2, length(scenario.gravity));
  }

  /// When to look next, after `now` [T]; infinity if that is of no use.
  double next_look(double now) const {
    return rest_ && !since_ ? rest_->next_look(now) : std::numeric_limits<double>::infinity();
  }
  /// Looks, if `now` [T] is a time to do so; totals() returns those of now.
  template <class TotalsNow>
  void look(double now, TotalsNow&& totals) {
    if (rest_ && !since_ && rest_->is_time_to_look(now) && rest_->is_reached(totals())) since_ = now;
  }
  /// Since when they are at rest [T].
  const std::optional<double>& since() const { return since_; }

 private:
  std::optional<Rest> rest_;
  std::optional<double> since_;
};

}  // namespace hardball
