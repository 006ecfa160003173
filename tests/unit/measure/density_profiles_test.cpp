// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/density_profiles.hpp"
#include "hardball/world/totals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "support/crystal.hpp"
#include "support/measurement.hpp"

namespace hardball::density_profiles_test {
namespace {

Measurement profiles_of(const World& world, double bin_width) {
  DensityProfiles measure({world, Time(0)}, bin_width);
  measure.sample({world, Time(0)});
  return measure.result({world, Time(0)});
}

// A sphere of radius 1 across the upper end of one periodic axis and the lower end of another, in slabs 0.5
// thick.
TEST(DensityProfiles, SliceASphereExactly) {
  World world(Box::periodic({6, 4, 5}));
  world.add({.position = {5.75, 0.5, 2.25}, .radius = 1});
  const Measurement found = profiles_of(world, 0.5);
  EXPECT_EQ(support::column(found, "position").values.size(), 12U);
  const std::vector<double>& along_x = support::column(found, "packing_fraction_x").values;
  const std::vector<double>& number_x = support::column(found, "number_density_x").values;
  // Of the unit ball between planes a and b from its center: pi ((b - b^3 / 3) - (a - a^3 / 3)).
  const auto slice = [](double a, double b) {
    return std::numbers::pi * ((b - b * b * b / 3) - (a - a * a * a / 3));
  };
  const double slab = 0.5 * 4 * 5;
  EXPECT_NEAR(along_x[11], slice(-0.25, 0.25) / slab, 1e-12);
  EXPECT_NEAR(along_x[10], slice(-0.75, -0.25) / slab, 1e-12);
  EXPECT_NEAR(along_x[9], slice(-1, -0.75) / slab, 1e-12);
  EXPECT_NEAR(along_x[8], 0, 1e-12);
  EXPECT_NEAR(along_x[0], slice(0.25, 0.75) / slab, 1e-12);
  EXPECT_NEAR(along_x[1], slice(0.75, 1) / slab, 1e-12);
  EXPECT_NEAR(number_x[11], 1 / slab, 1e-12);
  EXPECT_EQ(number_x[10], 0);
  // The shorter axes have fewer slabs.
  const std::vector<double>& along_y = support::column(found, "packing_fraction_y").values;
  EXPECT_NEAR(along_y[0], slice(-0.5, 0) / (0.5 * 30), 1e-12);
  EXPECT_NEAR(along_y[7], slice(-1, -0.5) / (0.5 * 30), 1e-12);
  EXPECT_TRUE(std::isnan(along_y[8]));
}

TEST(DensityProfiles, AddUpToTheSpheres) {
  const std::vector<double> radii(50, 0.7);
  const World world = support::make_ideal_gas(
      Box({Boundary::wall, Boundary::periodic, Boundary::wall}, {7.1, 9.3, 8.2}), radii, 55);
  const Measurement found = profiles_of(world, 0.13);
  const std::vector<double>& position = support::column(found, "position").values;
  const double width = position[1] - position[0];
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::string name = axis == 0 ? "x" : axis == 1 ? "y" : "z";
    const double size = world.box().size()[axis];
    const double area = world.box().volume() / size;
    double spheres = 0;
    double volume = 0;
    for (std::size_t bin = 0; bin < position.size(); ++bin) {
      const double low = static_cast<double>(bin) * width;
      if (low >= size * (1 - 1e-9)) continue;
      const double slab = std::min(width, size - low) * area;
      spheres += support::column(found, "number_density_" + name).values[bin] * slab;
      volume += support::column(found, "packing_fraction_" + name).values[bin] * slab;
    }
    EXPECT_NEAR(spheres, 50, 1e-9) << name;
    EXPECT_NEAR(volume, sphere_volume(world, Time(0)), 1e-9) << name;
  }
}

// Centers uniform over the space they can reach touch the walls as densely as they fill it.
TEST(DensityProfiles, KnowTheDensityAtTheWalls) {
  const Box box({Boundary::wall, Boundary::periodic, Boundary::wall}, {7, 9, 8});
  std::vector<double> radii(300, 0.25);
  radii.resize(600, 0.5);
  const World first = support::make_ideal_gas(box, radii, 0);
  DensityProfiles measure({first, Time(0)});
  for (std::uint64_t sample = 0; sample < 640; ++sample) {
    measure.sample({support::make_ideal_gas(box, radii, sample), Time(0)});
  }
  const Measurement found = measure.result({first, Time(0)});
  const Quantity& density = support::quantity(found, "density_at_walls");
  // Along x, the free lengths of centers are 6.5 and 6; along z, 7.5 and 7. Walls are weighted by area.
  const double across_x = 300 / (9 * 8.0) * (1 / 6.5 + 1 / 6.0);
  const double across_z = 300 / (9 * 7.0) * (1 / 7.5 + 1 / 7.0);
  EXPECT_NEAR(density.value, (8 * across_x + 7 * across_z) / 15, 4 * density.error);
  EXPECT_LT(density.error, 0.04 * density.value);
}

TEST(DensityProfiles, TurnItIntoAPressureByTheSpeedTowardsTheWalls) {
  World world(Box({Boundary::wall, Boundary::periodic, Boundary::periodic}, {6, 6, 6}));
  world.add({.position = {1, 2, 2}, .velocity = {3, 50, 0}, .radius = 1, .mass = 2});
  const Measurement found = profiles_of(world, 0.1);
  const double density = support::quantity(found, "density_at_walls").value;
  EXPECT_GT(density, 0);
  EXPECT_DOUBLE_EQ(support::quantity(found, "pressure_at_walls").value, density * 2 * 9);
}

TEST(DensityProfiles, HaveNoMeaningInOpenSpace) {
  World world(Box({Boundary::wall, Boundary::periodic, Boundary::open}, {6, 6, 0}));
  world.add({.position = {1, 2, 2}});
  EXPECT_TRUE(profiles_of(world, 0.1).columns.empty());
  EXPECT_TRUE(profiles_of(world, 0.1).quantities.empty());
}

}  // namespace
}  // namespace hardball::density_profiles_test
