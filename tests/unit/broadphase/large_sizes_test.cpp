// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/large_sizes.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <optional>
#include <vector>

namespace hardball::large_sizes_test {
namespace {

TEST(LargeSizes, CountTheCellsOfSurfacesOfAnyRadius) {
  constexpr double kThickness = 2 * LargeSizes::kSkin + 0.75;
  for (const double radius : {1e3, 1e6, 1e12, 1e20}) {
    const double ring = LargeSizes::cells_of_surface(radius, 2) / radius;
    const double shell = LargeSizes::cells_of_surface(radius, 3) / (radius * radius);
    EXPECT_NEAR(ring, 4 + 2 * std::numbers::pi * kThickness, 0.02) << radius;
    EXPECT_NEAR(shell, 3 * std::numbers::pi + 4 * std::numbers::pi * kThickness, 0.05) << radius;
  }
}

// One sphere of each of these radii among so many of radius .1.
std::optional<LargeSizes> sizes_in(double box, const std::vector<double>& radii, std::size_t others) {
  World world(Box::periodic({box, box, box}));
  for (const double radius : radii) world.add({{1, 1, 1}, {}, radius, 1});
  for (std::size_t i = 0; i < others; ++i) world.add({{2, 2, 2}, {}, 0.1, 1});
  return LargeSizes::in(world, Subdivision(world.box(), 1));
}

TEST(LargeSizes, AreOfAllThatDoNotFitIfTheseAreFew) {
  const std::optional<LargeSizes> sizes = sizes_in(40, {0.45, 0.7, 3, 2}, 5000);
  ASSERT_TRUE(sizes);
  EXPECT_EQ(sizes->largest_in_grid, 0.45);
  EXPECT_EQ(sizes->largest, 3);
  EXPECT_EQ(sizes->second_largest, 2);
  EXPECT_EQ(sizes->skin, LargeSizes::kSkin);
  EXPECT_EQ(sizes->surfaces, LargeSizes::cells_of_surface(3, 3) + LargeSizes::cells_of_surface(2, 3) +
                                 LargeSizes::cells_of_surface(0.7, 3));
  EXPECT_GT(sizes->farthest, 3 + 2 + 2 * sizes->skin);
}

TEST(LargeSizes, AreOfTheLargestIfManyDoNotFit) {
  const std::optional<LargeSizes> sizes = sizes_in(40, {0.45, 0.7, 3, 2}, 100);
  ASSERT_TRUE(sizes);
  EXPECT_EQ(sizes->largest_in_grid, 0.7);
  EXPECT_EQ(sizes->surfaces, LargeSizes::cells_of_surface(3, 3) + LargeSizes::cells_of_surface(2, 3));
}

TEST(LargeSizes, DoNotExistWhereNoSphereIsLargeOrTheBoxIsSmall) {
  EXPECT_FALSE(sizes_in(40, {}, 100));
  EXPECT_FALSE(sizes_in(40, {0.45}, 5000));
  EXPECT_TRUE(sizes_in(40, {0.7}, 5000));
  EXPECT_FALSE(sizes_in(40, {0.7}, 10)) << "not much larger than a cell, and not few";
  EXPECT_FALSE(sizes_in(40, {3, 3}, 1)) << "more are large than not";
  EXPECT_FALSE(sizes_in(10, {3, 3}, 5000)) << "candidates may be half a box apart";
}

// A part of a world may have none of its large spheres, or nothing else.
TEST(LargeSizes, AreOfAnyPartOfAWorldThatTheCellsSuit) {
  const Subdivision cells(Box::periodic({40, 40, 40}), 1);
  const auto sizes_of_part = [&](const std::vector<double>& radii) {
    World part(Box::periodic({40, 40, 40}));
    for (const double radius : radii) part.add({{1, 1, 1}, {}, radius, 1});
    return LargeSizes::in_part(part, cells);
  };
  EXPECT_EQ(sizes_of_part({0.45, 3, 0.1, 0.1, 0.1}).value().largest, 3);
  EXPECT_EQ(sizes_of_part({3, 3}).value().second_largest, 3);
  EXPECT_EQ(sizes_of_part({0.45, 0.1}).value().largest_in_grid, 0.45);
  EXPECT_EQ(sizes_of_part({0.1, 0.1}).value().largest, 0);
  EXPECT_TRUE(sizes_of_part({}));
  EXPECT_FALSE(sizes_of_part({15, 15})) << "candidates may be half a box apart";
}

TEST(LargeSizes, LeaveLessSkinInASmallBox) {
  const std::optional<LargeSizes> sizes = sizes_in(20, {4.9, 4.9}, 5000);
  ASSERT_TRUE(sizes);
  EXPECT_DOUBLE_EQ(sizes->skin, (0.495 * 20 - 2 * 4.9) / 4);
}

}  // namespace
}  // namespace hardball::large_sizes_test
