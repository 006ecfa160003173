// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/temperature.hpp"

#include <gtest/gtest.h>

#include "support/measurement.hpp"

namespace hardball::temperature_test {
namespace {

using support::column;
using support::has_quantity;
using support::quantity;

// Two light and two heavy spheres, which drift together.
World mixture(const Vec3& drift, const Box& box) {
  World world(box);
  world.add({{2, 2, 2}, drift + Vec3{2, 0, 0}, 0.5, 1});
  world.add({{4, 4, 4}, drift + Vec3{-2, 0, 0}, 0.5, 1});
  world.add({{6, 6, 6}, drift + Vec3{0, 1, 0}, 1, 3});
  world.add({{8, 8, 8}, drift + Vec3{0, -1, 0}, 1, 3});
  return world;
}

TEST(Temperature, CountsMotionRelativeToTheDriftInAPeriodicBox) {
  const World world = mixture({5, -7, 1}, Box::periodic({10, 10, 10}));
  Temperature temperature({world, Time(3)});
  temperature.sample({world, Time(4)});
  const Measurement found = temperature.result({world, Time(4)});
  // Twice the energy is 8 + 6, and there are 3 * 4 - 3 degrees of freedom.
  EXPECT_NEAR(quantity(found, "temperature").value, 14.0 / 9, 1e-12);
  EXPECT_NEAR(quantity(found, "temperature_along_x").value, 8.0 / 3, 1e-12);
  EXPECT_NEAR(quantity(found, "temperature_along_y").value, 6.0 / 3, 1e-12);
  EXPECT_NEAR(quantity(found, "temperature_along_z").value, 0, 1e-12);
  // Of the motion of the center of mass the light pair has a quarter.
  EXPECT_NEAR(quantity(found, "temperature_of_species_1").value, 8 / (6 - 3 * 0.25), 1e-12);
  EXPECT_NEAR(quantity(found, "temperature_of_species_2").value, 6 / (6 - 3 * 0.75), 1e-12);
  EXPECT_EQ(column(found, "time").values, std::vector<double>{4});
  EXPECT_EQ(column(found, "temperature_along_x").values.size(), 1U);
}

TEST(Temperature, CountsAllMotionBetweenWalls) {
  const World world = mixture({1, 0, 0}, Box::walls({10, 10, 10}));
  Temperature temperature({world, Time(0)});
  temperature.sample({world, Time(0)});
  const Measurement found = temperature.result({world, Time(0)});
  // Twice the energy is 9 + 1 of the light, 3 (1 + 1) each of the heavy.
  EXPECT_NEAR(quantity(found, "temperature").value, 22.0 / 12, 1e-12);
  EXPECT_NEAR(quantity(found, "temperature_of_species_2").value, 12.0 / 6, 1e-12);
}

TEST(Temperature, OfOneKindHasNoSpecies) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{2, 2, 2}, {2, 0, 0}, 0.5});
  world.add({{4, 4, 4}, {-2, 0, 0}, 0.5});
  EXPECT_FALSE(
      has_quantity(Temperature({world, Time(0)}).result({world, Time(0)}), "temperature_of_species_1"));
}

// A spin of w about each axis has I w^2 = k T in equilibrium.
TEST(Temperature, CountsSpins) {
  World world(Box::walls({10, 10, 10}));
  world.add({.position = {2, 2, 2}, .radius = 0.5, .mass = 2, .spin = {1, 2, 3}});
  world.add(
      {.position = {5, 5, 5}, .velocity = {1, 0, 0}, .radius = 1, .spin = {0, 0, 1}, .inertia_factor = 0.5});
  Temperature temperature({world, Time(0)});
  temperature.sample({world, Time(0)});
  const Measurement found = temperature.result({world, Time(0)});
  EXPECT_NEAR(quantity(found, "rotational_temperature").value, (0.4 * 2 * 0.25 * 14 + 0.5 * 1) / 6, 1e-15);
  EXPECT_NEAR(quantity(found, "temperature").value, 1.0 / 6, 1e-15);
  const World still = mixture({}, Box::walls({10, 10, 10}));
  EXPECT_FALSE(
      has_quantity(Temperature({still, Time(0)}).result({still, Time(0)}), "rotational_temperature"));
}

TEST(Temperature, OfDiscsCountsSpinsAboutOneAxis) {
  World world(Box::flat_walls(10, 10));
  world.add({.position = {2, 2, 0},
             .velocity = {1, 0, 0},
             .radius = 0.5,
             .spin = {0, 0, 3},
             .inertia_factor = 0.5});
  Temperature temperature({world, Time(0)});
  temperature.sample({world, Time(0)});
  EXPECT_NEAR(quantity(temperature.result({world, Time(0)}), "rotational_temperature").value, 0.125 * 9,
              1e-15);
}

TEST(Temperature, TellsSpeciesApartThatDifferInNothingElse) {
  World world(Box::walls({10, 10, 10}));
  world.add({.position = {2, 2, 2}, .velocity = {1, 0, 0}, .radius = 0.5});
  world.add({.position = {5, 5, 5}, .velocity = {2, 0, 0}, .radius = 0.5, .species = 4});
  Temperature temperature({world, Time(0)});
  temperature.sample({world, Time(0)});
  EXPECT_NEAR(quantity(temperature.result({world, Time(0)}), "temperature_of_species_2").value, 4.0 / 3,
              1e-15);
}

}  // namespace
}  // namespace hardball::temperature_test
