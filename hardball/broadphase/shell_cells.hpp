// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "hardball/broadphase/subdivision.hpp"

namespace hardball {

/// Calls visit(cell) for each cell, folded into the box, that has a point within `outer` [L] of a center
/// inside the box and is not all within `inner` of it. Cells at the ends of the box or of open space reach on
/// for ever. Cost: O(cells), and a few square roots for each column of cells along the last axis.
template <class Visit>
void for_each_cell_of_shell(const Subdivision& cells, const Vec3& center, double inner, double outer,
                            Visit&& visit) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto index_at = [&](std::size_t axis, double coordinate) {
    const double index =
        std::clamp<double>(coordinate / cells.edge(axis), cells.first(axis), cells.last(axis));
    return static_cast<std::int32_t>(std::floor(index));
  };
  const bool is_periodic[] = {cells.period(0) > 0, cells.period(1) > 0, cells.period(2) > 0};
  // The distances of the nearest and of the farthest point of a row of cells along an axis.
  struct Distances {
    double near;
    double far;
  };
  const auto distances = [&](std::size_t axis, std::int32_t index) {
    const bool has_below = is_periodic[axis] || index > cells.first(axis);
    const bool has_above = is_periodic[axis] || index < cells.last(axis);
    const double low = has_below ? cells.edge(axis) * index - center[axis] : -kInfinity;
    const double high = has_above ? cells.edge(axis) * (index + 1) - center[axis] : kInfinity;
    return Distances{std::max({low, -high, 0.0}), std::max(-low, high)};
  };
  const auto square = [](double number) { return number * number; };
  CellIndex low;
  CellIndex high;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    low[axis] = index_at(axis, center[axis] - outer);
    high[axis] = index_at(axis, center[axis] + outer);
  }
  for (std::int32_t x = low[0]; x <= high[0]; ++x) {
    const Distances in_x = distances(0, x);
    const std::int32_t folded_x = cells.folded(0, x);
    for (std::int32_t y = low[1]; y <= high[1]; ++y) {
      const Distances in_y = distances(1, y);
      const double room = outer * outer - (square(in_x.near) + square(in_y.near));
      if (room < 0) continue;
      const double height = std::sqrt(room);
      const std::int32_t folded_y = cells.folded(1, y);
      const std::int32_t begin = index_at(2, center.z - height);
      const std::int32_t end = index_at(2, center.z + height) + 1;
      std::int32_t hole_begin = end;
      std::int32_t hole_end = end;
      const double hidden = inner * inner - (square(in_x.far) + square(in_y.far));
      if (hidden > 0) {
        const double half = std::sqrt(hidden);
        hole_begin = std::max(begin, index_at(2, center.z - half) + 1);
        hole_end = std::min(end, index_at(2, center.z + half));
        if (hole_begin >= hole_end) hole_begin = hole_end = end;
      }
      for (std::int32_t z = begin; z < hole_begin; ++z) {
        visit(CellIndex{folded_x, folded_y, cells.folded(2, z)});
      }
      for (std::int32_t z = hole_end; z < end; ++z) {
        visit(CellIndex{folded_x, folded_y, cells.folded(2, z)});
      }
    }
  }
}

}  // namespace hardball
