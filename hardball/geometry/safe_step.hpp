// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

/// Steps from below: a search for the first time at which a gap closes, in steps that cannot pass it.
///
/// The distance from a point that moves as x(t), with |x''| <= a, to a convex set grows at least as fast as
/// its tangent less a t^2 / 2, and so does a gap of squares whose second derivative is bounded. Each step
/// ends where that bound reaches zero: near a contact it is a step of Newton's method from below, and a gap
/// that only opens needs none. No contact deeper than the rounding of the gap itself is passed.
namespace hardball {

/// A gap between two bodies at one time [L], or a difference of squares that has its sign [L^2].
struct Gap {
  double width = 0;      ///< Not positive where the bodies touch.
  double speed = 0;      ///< How fast it opens; negative if it closes.
  double curvature = 0;  ///< The second derivative is no less than minus this until the next step ends.
};

/// A time in which a gap does not close [T]: if it is open, as long as its curvature bound lasts; if it is
/// closed and opens, until it turns; infinite if it only opens.
inline double safe_step(const Gap& gap) {
  constexpr double kForever = std::numeric_limits<double>::infinity();
  if (gap.width <= 0) return gap.curvature > 0 ? gap.speed / gap.curvature : kForever;
  if (!(gap.curvature > 0)) return gap.speed < 0 ? gap.width / -gap.speed : kForever;
  const double root = std::sqrt(gap.speed * gap.speed + 2 * gap.curvature * gap.width);
  return gap.speed < 0 ? 2 * gap.width / (root - gap.speed) : (root + gap.speed) / gap.curvature;
}

/// A safe step of a smooth gap whose second derivative is `second` now, is never below -`most`, and changes
/// no faster than `third`: where it is small or positive, longer than by the bound alone. Steps are not
/// prolonged beyond `longest` [T].
inline double safe_step_of_smooth_gap(double width, double speed, double second, double most, double third,
                                      double longest) {
  constexpr double kRounding = 0x1p-40;
  double step = safe_step({width, speed, most});
  while (step < longest) {
    const double window = 2 * step;
    const double least = second - third * window - kRounding * most;
    const double longer = safe_step({width, speed, -least});
    if (!(longer > window)) return (1 - kRounding) * std::max(step, longer);
    step = window;
  }
  return (1 - kRounding) * step;
}

}  // namespace hardball
