// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Coordination and the gaps of nearest neighbors, on states that can be counted by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "hardball/measure/coordination.hpp"
#include "hardball/measure/nearest_neighbor.hpp"
#include "support/crystal.hpp"
#include "support/measurement.hpp"

namespace hardball::neighbors_test {
namespace {

template <class Measure>
Measurement measured(const World& world) {
  Measure measure({world, Time(0)});
  measure.sample({world, Time(0)});
  return measure.result({world, Time(0)});
}

TEST(Coordination, OfCrystalsIsThatOfTheirLattices) {
  const auto neighbors = [](const support::Lattice& lattice) {
    const Measurement found = measured<Coordination>(support::make_crystal(lattice, 4, 1.1));
    const double mean = support::quantity(found, "mean_neighbors").value;
    const std::vector<double>& fraction = support::column(found, "fraction").values;
    EXPECT_EQ(fraction.back(), 1);
    EXPECT_EQ(support::column(found, "neighbors").values.back(), mean);
    return mean;
  };
  EXPECT_EQ(neighbors(support::simple_cubic()), 6);
  EXPECT_EQ(neighbors(support::body_centered_cubic()), 8);
  EXPECT_EQ(neighbors(support::face_centered_cubic()), 12);
  EXPECT_EQ(neighbors(support::hexagonal_close_packing()), 12);
}

TEST(Coordination, ScalesWithTheRadiiOfBothSpheres) {
  World world;
  world.add({.position = {0, 0, 0}, .radius = 1});
  world.add({.position = {4.7, 0, 0}, .radius = 3});   // 1.175 times the sum of radii
  world.add({.position = {0, 2.45, 0}, .radius = 1});  // 1.225 times
  const Measurement found = measured<Coordination>(world);
  const std::vector<double>& fraction = support::column(found, "fraction").values;
  ASSERT_EQ(fraction.size(), 2U);
  EXPECT_DOUBLE_EQ(fraction[0], 1.0 / 3);
  EXPECT_DOUBLE_EQ(fraction[1], 2.0 / 3);
  EXPECT_DOUBLE_EQ(support::quantity(found, "mean_neighbors").value, 2.0 / 3);
}

TEST(NearestNeighbor, OfACrystalIsItsSpacing) {
  const Measurement found =
      measured<NearestNeighbor>(support::make_crystal(support::face_centered_cubic(), 4, 1.1));
  EXPECT_NEAR(support::quantity(found, "mean_gap").value, 0.1, 1e-12);
  const std::vector<double>& gap = support::column(found, "gap").values;
  const std::vector<double>& density = support::column(found, "probability_density").values;
  const double width = gap[1] - gap[0];
  for (std::size_t i = 0; i < gap.size(); ++i) {
    const bool holds_it = std::fabs(gap[i] - 0.1) < width / 2;
    EXPECT_NEAR(density[i], holds_it ? 1 / width : 0, 1e-9);
  }
}

TEST(NearestNeighbor, IsTheOneWhoseSurfaceIsNearest) {
  World world(Box::periodic({20, 20, 20}));
  world.add({.position = {19, 1, 1}, .radius = 0.5});
  world.add({.position = {2, 1, 1}, .radius = 0.5});   // gaps of 2 to the first, across the boundary,
  world.add({.position = {2, 6, 1}, .radius = 3.75});  // and of 0.75 to the second
  const Measurement found = measured<NearestNeighbor>(world);
  const double diagonal = std::sqrt(9.0 + 25) - 4.25;
  EXPECT_NEAR(support::quantity(found, "mean_gap").value, (diagonal + 0.75 + 0.75) / 3, 1e-12);
}

TEST(NearestNeighbor, OfOneSphereIsNobody) {
  World world;
  EXPECT_TRUE(measured<NearestNeighbor>(world).columns.empty());
  world.add({});
  EXPECT_TRUE(measured<NearestNeighbor>(world).columns.empty());
}

}  // namespace
}  // namespace hardball::neighbors_test
