// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/velocity_distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/gas.hpp"
#include "support/measurement.hpp"

namespace hardball::velocity_distribution_test {
namespace {

using support::column;
using support::quantity;

// Equal speeds of 3 along the axes, and a drift that does not count; half the spheres are nine times as heavy
// and three times as slow.
World equal_speeds() {
  World world(Box::periodic({100, 100, 100}));
  for (int i = 0; i < 12; ++i) {
    Vec3 velocity;
    velocity[static_cast<std::size_t>(i) / 2 % 3] = (i % 2 == 0 ? 3 : -3) / (i < 6 ? 1.0 : 3.0);
    const double x = 5.0 * (i + 1);
    world.add({{x, x, x}, velocity + Vec3{4, 0, 0}, 0.5, i < 6 ? 1.0 : 9.0});
  }
  return world;
}

TEST(VelocityDistribution, IsOfVelocitiesInUnitsOfTheThermalOne) {
  const World world = equal_speeds();
  VelocityDistribution velocities({world, Time(0)});
  velocities.sample({world, Time(0)});
  const Measurement found = velocities.result({world, Time(0)});
  EXPECT_NEAR(quantity(found, "speed_kurtosis").value, 1, 1e-12);
  EXPECT_NEAR(quantity(found, "mean_speed").value, 2, 1e-12);
  EXPECT_NEAR(quantity(found, "speed_kurtosis").theory, 5.0 / 3 * 33 / 35, 1e-12);
  // m v^2 = 9 = kT (3 * 12 - 3) / 12 for all.
  const double temperature = 9 * 12.0 / 33;
  const double c = 3 / std::sqrt(temperature);
  const Column& argument = column(found, "reduced_velocity");
  for (std::size_t i = 0; i < argument.values.size(); ++i) {
    const double middle = argument.values[i];
    const auto holds = [&](double value) { return std::fabs(value - middle) < 0.05; };
    const double of_components = holds(0.05) ? 2.0 / 3 : holds(c) || holds(-c) ? 1.0 / 6 : 0;
    EXPECT_NEAR(column(found, "component_density").values[i] * 0.1, of_components, 1e-12) << middle;
    if (middle < 0) {
      EXPECT_TRUE(std::isnan(column(found, "speed_density").values[i]));
    } else {
      EXPECT_NEAR(column(found, "speed_density").values[i] * 0.1, holds(c) ? 1 : 0, 1e-12) << middle;
    }
  }
  // The mean of sqrt(8 kT / pi m), at fixed energy in 33 degrees of freedom and without what spheres of mass
  // 1 and 9, of 60 in all, have of the motion of the center of mass.
  const double of_light = std::sqrt(1 - 1.0 / 60);
  const double of_heavy = std::sqrt(1 - 9.0 / 60) / 3;
  const double expected =
      std::sqrt(8 * temperature / std::numbers::pi) * mean_over_normal(33) * (of_light + of_heavy) / 2;
  EXPECT_NEAR(quantity(found, "mean_speed").theory, expected, 1e-12);
}

TEST(VelocityDistribution, HasMaxwellsAsTheory) {
  const World world = equal_speeds();
  const Measurement found = VelocityDistribution({world, Time(0)}).result({world, Time(0)});
  const Column& argument = column(found, "reduced_velocity");
  double components = 0;
  double speeds = 0;
  for (std::size_t i = 0; i < argument.values.size(); ++i) {
    const double c = argument.values[i];
    const double gauss = std::exp(-c * c / 2) / std::sqrt(2 * std::numbers::pi);
    EXPECT_NEAR(column(found, "component_density_theory").values[i], gauss, 5e-4);
    components += gauss * 0.1;
    if (c < 0) continue;
    EXPECT_NEAR(column(found, "speed_density_theory").values[i], 2 * c * c * gauss, 1e-3);
    speeds += column(found, "speed_density_theory").values[i] * 0.1;
  }
  EXPECT_NEAR(components, 1, 1e-4);
  EXPECT_NEAR(speeds, 1, 1e-4);
}

TEST(VelocityDistribution, OfSpheresAtRestIsEmpty) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{2, 2, 2}, {}, 0.5});
  world.add({{4, 4, 4}, {}, 0.5});
  VelocityDistribution velocities({world, Time(0)});
  velocities.sample({world, Time(0)});
  EXPECT_TRUE(std::isnan(quantity(velocities.result({world, Time(0)}), "speed_kurtosis").value));
}

}  // namespace
}  // namespace hardball::velocity_distribution_test
