// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/collision_rate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/measurement.hpp"

namespace hardball::collision_rate_test {
namespace {

using support::has_quantity;
using support::quantity;

Contact collision(double time, SphereId first, SphereId second) {
  Contact contact;
  contact.time = Time(time);
  contact.first = first;
  contact.second = second;
  contact.first_mass = 1;
  contact.second_mass = 1;
  contact.separation = {1, 0, 0};
  return contact;
}

Contact wall_contact(double time, SphereId sphere) {
  Contact contact = collision(time, sphere, face_of(0, true));
  contact.kind = EventKind::wall;
  return contact;
}

TEST(CollisionRate, CountsEachSphereAndPairOfSpecies) {
  World world(Box::walls({10, 10, 10}));
  world.add({{2, 2, 2}, {2, 0, 0}, 0.5});
  world.add({{4, 4, 4}, {4, 0, 0}, 1});
  world.add({{8, 8, 8}, {0, 0, 0}, 1});
  CollisionRate rate({world, Time(10)});
  rate.sample({world, Time(10)});
  rate.note(collision(11, 0, 1));
  rate.note(collision(12, 1, 2));
  rate.note(collision(13, 1, 2));
  rate.note(wall_contact(14, 0));
  const Measurement found = rate.result({world, Time(14)});
  EXPECT_EQ(quantity(found, "collisions").value, 3);
  EXPECT_EQ(quantity(found, "wall_contacts").value, 1);
  // Two spheres collide at each collision, of three, in 4 units of time.
  EXPECT_DOUBLE_EQ(quantity(found, "collision_rate").value, 6.0 / 12);
  EXPECT_DOUBLE_EQ(quantity(found, "mean_free_time").value, 2);
  EXPECT_DOUBLE_EQ(quantity(found, "mean_free_path").value, 2 * 2);
  EXPECT_DOUBLE_EQ(quantity(found, "wall_rate").value, 1.0 / 12);
  EXPECT_EQ(quantity(found, "collision_rate_1_1").value, 0);
  EXPECT_DOUBLE_EQ(quantity(found, "collision_rate_1_2").value, 1.0 / 4);
  // The two large ones meet twice, each of them.
  EXPECT_DOUBLE_EQ(quantity(found, "collision_rate_2_2").value, 2 * 2.0 / (2 * 4));
  EXPECT_TRUE(std::isnan(quantity(found, "collision_rate").theory)) << "there are walls";
}

TEST(CollisionRate, HasNoFreeTimeWithoutCollisions) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{2, 2, 2}, {2, 0, 0}, 0.5});
  const Measurement found = CollisionRate({world, Time(0)}).result({world, Time(5)});
  EXPECT_EQ(quantity(found, "collision_rate").value, 0);
  EXPECT_TRUE(std::isnan(quantity(found, "mean_free_time").value));
  EXPECT_FALSE(has_quantity(found, "wall_rate"));
}

// Nearly points: pi d^2 n sqrt(16 kT / pi m) for one kind, and the same with the reduced mass for two.
TEST(CollisionRate, HasTheTheoryOfADiluteGas) {
  constexpr double kRadius = 0.005;
  World world(Box::periodic({10, 10, 10}));
  for (int i = 0; i < 8; ++i) {
    const double x = 1 + i;
    const double v = i % 2 == 0 ? 1 : -1;
    world.add({{x, x, x}, {v, v, v}, kRadius, i < 4 ? 1.0 : 4.0});
  }
  const Measurement found = CollisionRate({world, Time(0)}).result({world, Time(1)});
  const double temperature = (4 * 3 + 4 * 12) / (3.0 * 7);
  const double area = std::numbers::pi * 4 * kRadius * kRadius;
  // Seven others rather than eight, and the mean of a motion of fixed energy in 21 degrees of freedom.
  const double few = 7.0 / 8 * mean_over_normal(21);
  const auto expected = [&](double reduced_mass) {
    return few * area * 4 / 1000 * std::sqrt(8 * temperature / (std::numbers::pi * reduced_mass));
  };
  EXPECT_NEAR(quantity(found, "collision_rate_1_1").theory / expected(0.5), 1, 1e-4);
  EXPECT_NEAR(quantity(found, "collision_rate_1_2").theory / expected(0.8), 1, 1e-4);
  EXPECT_NEAR(quantity(found, "collision_rate_2_2").theory / expected(2), 1, 1e-4);
}

}  // namespace
}  // namespace hardball::collision_rate_test
