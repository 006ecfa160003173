// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/world/box.hpp"

namespace hardball {

/// Whether two boxes have the same edges and boundaries.
inline bool is_same_box(const Box& a, const Box& b) {
  bool is_same = a.size() == b.size();
  for (std::size_t axis = 0; axis < kAxes; ++axis) is_same &= a.boundary(axis) == b.boundary(axis);
  return is_same;
}

}  // namespace hardball
