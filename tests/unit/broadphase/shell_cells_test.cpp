// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/shell_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "hardball/numbers/random.hpp"

namespace hardball::shell_cells_test {
namespace {

constexpr double kSize = 12;

// Whether a cell that is `shift` cells beyond `folded` has a point within `outer`, and one beyond `inner`.
bool is_in_shell(const Subdivision& cells, const CellIndex& cell, const Vec3& center, double inner,
                 double outer) {
  double near = 0;
  double far = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double low = cells.edge(axis) * cell[axis] - center[axis];
    const double high = low + cells.edge(axis);
    // The outermost cells reach on for ever.
    const bool is_first = cells.period(axis) == 0 && cell[axis] == cells.first(axis);
    const bool is_last = cells.period(axis) == 0 && cell[axis] == cells.last(axis);
    const double nearest = std::max({is_first ? 0.0 : low, is_last ? 0.0 : -high, 0.0});
    near += nearest * nearest;
    far += is_first || is_last ? HUGE_VAL : std::pow(std::max(-low, high), 2);
  }
  return near <= outer * outer && far >= inner * inner;
}

TEST(ShellCells, AreThoseNearTheSurface) {
  Random random(7);
  for (const Boundary boundary : {Boundary::periodic, Boundary::wall}) {
    const Box box({boundary, boundary, boundary}, {kSize, kSize, kSize});
    const Subdivision cells(box, 1);
    for (int i = 0; i < 100; ++i) {
      const Vec3 center{kSize * random.uniform(), kSize * random.uniform(), kSize * random.uniform()};
      const double outer = 0.4 * kSize * random.uniform();
      const double inner = std::max(0.0, outer - 2 * random.uniform());
      std::multiset<CellIndex> found;
      for_each_cell_of_shell(cells, center, inner, outer, [&](const CellIndex& cell) { found.insert(cell); });
      std::multiset<CellIndex> expected;
      const std::int32_t beyond = boundary == Boundary::periodic ? 12 : 0;
      const CellRange all{{-beyond, -beyond, -beyond}, {11 + beyond, 11 + beyond, 11 + beyond}};
      all.for_each([&](const CellIndex& cell) {
        if (is_in_shell(cells, cell, center, inner, outer)) expected.insert(cells.folded(cell));
      });
      EXPECT_EQ(found, expected);
      EXPECT_FALSE(found.empty());
    }
  }
}

TEST(ShellCells, OfAFullSphereHaveNoHole) {
  const Subdivision cells(Box::periodic({kSize, kSize, kSize}), 1);
  std::set<CellIndex> found;
  for_each_cell_of_shell(cells, {6.5, 6.5, 6.5}, 0, 3, [&](const CellIndex& cell) { found.insert(cell); });
  EXPECT_TRUE(found.contains({6, 6, 6}));
  found.clear();
  for_each_cell_of_shell(cells, {6.5, 6.5, 6.5}, 2.5, 3, [&](const CellIndex& cell) { found.insert(cell); });
  EXPECT_FALSE(found.contains({6, 6, 6}));
  EXPECT_TRUE(found.contains({6, 6, 3}));
}

}  // namespace
}  // namespace hardball::shell_cells_test
