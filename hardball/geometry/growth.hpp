// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "hardball/geometry/time.hpp"

namespace hardball {

/// How the sizes of all spheres change during an epoch: each radius is the sphere's base radius times a scale
/// that is linear in time. By default sizes are constant.
///
/// Contacts are computed for one epoch at a time: those that would come after its end are of the next, whose
/// scale begins where this one ends.
struct Growth {
  using PlainNumber = double;  ///< To archives.

  Time begin;         ///< [T]
  Time end = kNever;  ///< Finite where the rate is not zero [T].
  double scale = 1;   ///< At the begin [1].
  double rate = 0;    ///< Rate of the scale; negative where spheres shrink [1/T].

  /// Whether radii differ from base radii, or change.
  bool is_present() const { return scale != 1 || rate != 0; }
  /// The scale at `moment` [1]. Precondition: `moment` is in the epoch.
  double scale_at(const Time& moment) const { return scale + rate * duration(begin, moment); }
  /// The greatest scale in the epoch [1], with room for the rounding of its end.
  double largest_scale() const {
    constexpr double kRounding = 1 + 0x1p-40;
    return rate == 0 ? scale : kRounding * std::max(scale, scale_at(end));
  }

  friend bool operator==(const Growth&, const Growth&) = default;
};

}  // namespace hardball
