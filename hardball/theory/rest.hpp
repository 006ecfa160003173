// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "hardball/errors/export.hpp"
#include "hardball/world/totals.hpp"

namespace hardball {

/// Decides when spheres that gravity presses together are at rest.
///
/// Hard spheres bear a weight only by contacts and so never stand still. They count as at rest if their
/// kinetic energy is less than a hundredth of what lifts all of them by a diameter d, and none moves, or has
/// moved since its velocity last changed, at .63 sqrt(g d), which would lift it by a fifth of d.
class HARDBALL_EXPORT Rest {
 public:
  /// `totals`: of all spheres. Precondition: there are spheres, and `gravity` [L/T^2] is positive.
  Rest(const Totals& totals, std::size_t spheres, bool is_flat, double gravity);

  /// The first time after `now` at which to look [T]: a multiple of 2 sqrt(d / g).
  double next_look(double now) const;
  /// Whether `time` [T] is one at which to look; never at the start, where spheres may hang in the air.
  bool is_time_to_look(double time) const;
  /// Whether spheres with these totals are at rest.
  bool is_reached(const Totals& totals) const;

 private:
  double lift_ = 0;      // g d [L^2 T^-2]
  double interval_ = 0;  // [T]
};

}  // namespace hardball
