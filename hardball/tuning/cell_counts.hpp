// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/geometry/vec3.hpp"
#include "hardball/theory/gas_statistics.hpp"

namespace hardball {

/// The work of a CellGrid in a gas, as predicted by kinetic theory.
///
/// Contacts with all candidates of a sphere are predicted after each of its contacts, and when its planned
/// contact turns out stale. Source: docs/theory.md.
struct CellCounts {
  // Rates per sphere [1/T].
  double collision = 0;
  double wall = 0;
  double enter = 0;
  double stale = 0;

  // Numbers of pairs predicted [1].
  double candidates_after_collision = 0;
  double candidates_after_wall = 0;
  double candidates_when_stale = 0;
  double candidates_after_enter = 0;
  double candidates_at_any_time = 0;

  // The cells that a sphere touches, and those that it enters at a crossing [1].
  double cells = 0;
  double cells_entered = 0;

  bool are_images_listed = false;  // whether the box has so few cells that candidates come with their images

  /// Predictions per sphere and time [1/T].
  double predictions() const {
    return collision * candidates_after_collision + wall * candidates_after_wall +
           stale * candidates_when_stale + enter * candidates_after_enter;
  }
};

/// The counts expected for a wanted edge of `edge` [L], see Subdivision. Cost: O(1), about ten microseconds.
/// Error: the edge is not positive and finite.
CellCounts expected_counts(const GasStatistics& statistics, double edge);

}  // namespace hardball
