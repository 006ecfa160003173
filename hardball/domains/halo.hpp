// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

namespace hardball {

/// What a domain holds around its block.
struct Halo {
  double depth = 0;    ///< Width of the halo: spheres with centers this near the block are held, too [L].
  double slack = 0;    ///< A sphere is held until its center is farther away by this much more [L].
  double contact = 0;  ///< The largest distance of two centers at a contact [L].

  /// Beyond this distance from the block, an own sphere may meet one that is not held [L].
  double farthest() const { return depth - contact; }
  /// Beyond this distance from the block, nothing is held [L].
  double outer() const { return depth + slack; }
  /// The distance within which blocks may concern one another [L].
  double neighborhood() const { return 2 * depth; }
};

}  // namespace hardball
