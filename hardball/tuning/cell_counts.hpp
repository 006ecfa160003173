// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/geometry/vec3.hpp"
#include "hardball/tuning/moments.hpp"

namespace hardball {

/// How much a cell grid has to do in a gas, as kinetic theory expects it.
///
/// A sphere looks at all its candidates after each contact, and when a contact it waited for has become
/// stale. Source: docs/theory.md.
struct CellCounts {
  // How often it happens to one sphere [1/T].
  double collision = 0;
  double wall = 0;
  double enter = 0;
  double stale = 0;

  // How many pairs are predicted [1].
  double candidates_after_collision = 0;
  double candidates_after_wall = 0;
  double candidates_when_stale = 0;
  double candidates_after_enter = 0;
  double candidates_at_any_time = 0;

  // How many cells a sphere touches, and how many of them it has just entered [1].
  double cells = 0;
  double cells_entered = 0;

  bool is_hashed = false;  // whether cells are found through a hash table, as in open space

  /// Predictions of one sphere per time [1/T].
  double predictions() const {
    return collision * candidates_after_collision + wall * candidates_after_wall +
           stale * candidates_when_stale + enter * candidates_after_enter;
  }
};

/// What to expect with cells of wanted edge `edge` [L], see Subdivision. Cost: O(1), some ten microseconds.
/// Error: the edge is not positive and finite.
CellCounts expected_counts(const Moments& moments, double edge);

}  // namespace hardball
