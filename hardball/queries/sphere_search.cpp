// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/queries/sphere_search.hpp"

#include <algorithm>
#include <tuple>

namespace hardball {

bool is_scan_cheaper(const SphereSearch::Part& part, const Extent& extent) {
  const Subdivision* const cells = part.phase ? part.phase->search_cells() : nullptr;
  if (!cells) return true;
  double count = 1;
  bool are_all = true;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double along = (extent.high[axis] - extent.low[axis]) / cells->edge(axis) + 1;
    const std::int32_t all = cells->shape()[axis];
    are_all = are_all && all > 0 && along >= all;
    count *= all > 0 ? std::min<double>(along, all) : along;
  }
  return are_all || part.cell_cost * count >= static_cast<double>(part.world->size());
}

CellRange cells_of(const Subdivision& cells, const Extent& extent) {
  CellRange range;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    double middle = 0.5 * (extent.low[axis] + extent.high[axis]);
    const double period = cells.period(axis) * cells.edge(axis);
    if (period > 0) middle -= period * std::floor(middle / period);
    std::tie(range.low[axis], range.high[axis]) =
        cells.range_along(axis, middle, 0.5 * (extent.high[axis] - extent.low[axis]));
  }
  return range;
}

}  // namespace hardball
