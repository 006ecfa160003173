// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/impact_speeds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "support/gas.hpp"
#include "support/measurement.hpp"

namespace hardball::impact_speeds_test {
namespace {

using support::column;
using support::quantity;

Contact collision_at(double speed) {
  Contact contact;
  contact.separation = {1, 0, 0};
  contact.first = 0;
  contact.second = 1;
  contact.first_mass = 1;
  contact.second_mass = 1;
  contact.before = {{speed, 7, 0}, {0, 0, 0}};
  contact.after = {{0, 7, 0}, {speed, 0, 0}};
  return contact;
}

TEST(ImpactSpeeds, AreThoseAlongTheLineOfCenters) {
  const World world = support::make_gas({.count = 1000, .seed = 3});
  ImpactSpeeds speeds({world, Time(0)});
  for (const double speed : {1.0, 2.0, 2.0, 3.0}) speeds.note(collision_at(speed));
  const Measurement found = speeds.result({world, Time(1)});
  EXPECT_EQ(quantity(found, "mean_impact_speed").value, 2);
  EXPECT_EQ(quantity(found, "mean_square_impact_speed").value, 4.5);
  const Column& speed = column(found, "impact_speed");
  const Column& density = column(found, "probability_density");
  const double width = speed.values[1] - speed.values[0];
  double sum = 0;
  double at_two = 0;
  for (std::size_t i = 0; i < density.values.size(); ++i) {
    sum += density.values[i] * width;
    if (std::fabs(speed.values[i] - 2) < width / 2) at_two = density.values[i] * width;
  }
  EXPECT_NEAR(sum, 1, 1e-12);
  EXPECT_NEAR(at_two, 0.5, 1e-12);
}

TEST(ImpactSpeeds, HaveRayleighsDistributionForManySpheres) {
  // kT = 3 n / (3 n - 3) for gases of the support library.
  constexpr double kSpheres = 4000;
  const double temperature = kSpheres / (kSpheres - 1);
  const World world = support::make_gas({.count = 4000, .seed = 3});
  ImpactSpeeds speeds({world, Time(0)});
  speeds.note(collision_at(1));
  const Measurement found = speeds.result({world, Time(1)});
  EXPECT_NEAR(quantity(found, "mean_impact_speed").theory, std::sqrt(std::numbers::pi * temperature), 2e-4);
  EXPECT_NEAR(quantity(found, "mean_square_impact_speed").theory, 4 * temperature, 1e-3);
  const Column& speed = column(found, "impact_speed");
  const Column& theory = column(found, "probability_density_theory");
  for (std::size_t i = 0; i < speed.values.size(); ++i) {
    const double u = speed.values[i];
    EXPECT_NEAR(theory.values[i], u / (2 * temperature) * std::exp(-u * u / (4 * temperature)), 1e-3) << u;
  }
}

// With two spheres in a periodic box there is one relative velocity, of fixed size s, in a random direction:
// colliding pairs have the mean |cos| = 2/3 and the mean cos^2 = 1/2.
TEST(ImpactSpeeds, AreExactForTwoSpheres) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{2, 2, 2}, {1, 0, 0}, 0.5});
  world.add({{4, 4, 4}, {-1, 0, 0}, 0.5});
  ImpactSpeeds speeds({world, Time(0)});
  speeds.note(collision_at(1));
  const Measurement found = speeds.result({world, Time(1)});
  EXPECT_NEAR(quantity(found, "mean_impact_speed").theory, 2 * 2.0 / 3, 1e-12);
  EXPECT_NEAR(quantity(found, "mean_square_impact_speed").theory, 4 * 0.5, 1e-12);
}

TEST(ImpactSpeeds, HaveNoTheoryOutOfEquilibrium) {
  World open;
  open.add({{2, 2, 2}, {1, 0, 0}, 0.5});
  open.add({{4, 4, 4}, {-1, 0, 0}, 0.5});
  ImpactSpeeds speeds({open, Time(0)});
  speeds.note(collision_at(1));
  EXPECT_TRUE(std::isnan(quantity(speeds.result({open, Time(1)}), "mean_impact_speed").theory));
}

}  // namespace
}  // namespace hardball::impact_speeds_test
