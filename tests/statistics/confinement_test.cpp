// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Gravity, walls and obstacles against exact results.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "support/interacting.hpp"

namespace hardball::confinement_test {
namespace {

const Box kOpen = Box::open();

World dropped_ball(double height, double gravity) {
  World world(kOpen, {0, 0, -gravity}, {Surface(Plane({0, 0, 1}), {})});
  world.add({{0, 0, 0.5 + height}, {0.25, 0, 0}, 0.5, 1});
  return world;
}

// Bounce k of a ball dropped from height h is at t_1 + 2 t_1 e (1 - e^(k - 1)) / (1 - e).
TEST(BouncingBall, BouncesAtTheTimesOfTheGeometricSeries) {
  constexpr double kHeight = 1.25;
  constexpr double kGravity = 9.5;
  constexpr double kRestitution = 0.75;
  Simulation simulation(support::interacting(dropped_ball(kHeight, kGravity), Restitution(kRestitution)));
  const double first = std::sqrt(2 * kHeight / kGravity);
  std::vector<Contact> bounces;
  simulation.on_contact([&](const Contact& contact) { bounces.push_back(contact); });
  simulation.run_contacts(60);
  ASSERT_EQ(bounces.size(), 60U);
  double power = 1;  // e^(k - 1)
  for (const Contact& bounce : bounces) {
    const double time = first + 2 * first * kRestitution * (1 - power) / (1 - kRestitution);
    EXPECT_NEAR(bounce.time.value(), time, 1e-12);
    EXPECT_NEAR(bounce.impact_speed(), power * kGravity * first, 1e-12);
    EXPECT_EQ(bounce.after.first.x, 0.25) << "it keeps sliding";
    power *= kRestitution;
  }
}

// Without a rule for rest the end of the bounces, t_1 (1 + e) / (1 - e), is reported by name.
TEST(BouncingBall, EndsAtTheLimitOfTheSeries) {
  Simulation simulation(support::interacting(dropped_ball(2, 1), Restitution(0.5)));
  try {
    simulation.run_until(100);
    FAIL() << "the ball bounces infinitely often";
  } catch (const RunFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("inelastic collapse: sphere 0"), std::string::npos);
    EXPECT_NEAR(simulation.time(), 2 * (1 + 0.5) / (1 - 0.5), 1e-12);
  }
}

TEST(BouncingBall, KeepsBouncingInvisiblyIfSlowImpactsAreElastic) {
  constexpr double kSlow = 1e-3;
  Simulation simulation(support::interacting(dropped_ball(2, 1), Restitution(0.5, kSlow)));
  simulation.run_until(20);
  const Vec3 velocity = simulation.velocity(0);
  EXPECT_LE(std::fabs(velocity.z), kSlow);
  EXPECT_LE(simulation.position(0).z, 0.5 + kSlow * kSlow / 2 * (1 + 1e-9));
  EXPECT_GE(simulation.position(0).z, 0.5 - 1e-12);
  EXPECT_NEAR(simulation.position(0).x, 0.25 * 20, 1e-10) << "it slides on";
}

TEST(Resting, OnAFloorIsReportedOrKeptByTheRule) {
  World world(kOpen, {0, 0, -1}, {Surface(Plane({0, 0, 1}), {})});
  world.add({{0, 0, 0.5}, {}, 0.5, 1});
  EXPECT_THROW(Simulation(world).run_until(1), RunFailure);
  Simulation simulation(support::interacting(world, Restitution(1, 1e-2)));
  simulation.run_until(10);
  EXPECT_NEAR(simulation.position(0).z, 0.5, 1e-6);
  EXPECT_LE(std::fabs(simulation.velocity(0).z), 1e-3 * (1 + 1e-9)) << "a tenth of the threshold";
}

// Spheres dropped symmetrically around an axis stay symmetric, to the last bit.
TEST(SymmetricDrop, StaysSymmetric) {
  World world(kOpen, {0, 0, -1}, {Surface(HollowSphere(10), {})});
  for (const double x : {-3.0, 3.0}) {
    for (const double y : {-3.0, 3.0}) world.add({{x, y, 1}, {}, 0.5, 1});
  }
  Simulation simulation(world);
  simulation.run_contacts(200);
  const Vec3 first = simulation.position(3);
  EXPECT_EQ(simulation.position(0), (Vec3{-first.x, -first.y, first.z}));
  EXPECT_EQ(simulation.position(1), (Vec3{-first.x, first.y, first.z}));
  EXPECT_EQ(simulation.position(2), (Vec3{first.x, -first.y, first.z}));
}

// The angle of incidence is the same at every bounce.
void expect_constant_angle(const Box& box, const std::vector<Surface>& surfaces, const Vec3& velocity) {
  World world(box, {}, surfaces);
  world.add({{0.3, -0.2, 0.1}, velocity, 0.25, 1});
  Simulation simulation(world);
  std::uint64_t bounces = 0;
  double first = 0;
  double farthest = 0;
  simulation.on_contact([&](const Contact& contact) {
    if (contact.second != kFaces) return;
    const double cosine = contact.impact_speed() / length(contact.before.first);
    if (++bounces == 1) first = cosine;
    farthest = std::max(farthest, std::fabs(cosine - first));
  });
  const double energy = dot(velocity, velocity);
  simulation.run_contacts(1'000'000);
  EXPECT_GT(bounces, 400'000U);
  EXPECT_LT(farthest, 1e-9);
  EXPECT_NEAR(dot(simulation.velocity(0), simulation.velocity(0)) / energy, 1, 1e-12);
  EXPECT_LT(simulation.tally().max_overlap(), 1e-12);
}

TEST(Billiard, InASphereKeepsItsAngle) {
  expect_constant_angle(kOpen, {Surface(HollowSphere(3), {})}, {0.8, 0.5, -0.3});
}

TEST(Billiard, InAPeriodicCylinderKeepsItsAngle) {
  const Box box({Boundary::open, Boundary::open, Boundary::periodic}, {0, 0, 4});
  expect_constant_angle(box, {Surface(Cylinder({0, 0, 1}, 3), {})}, {0.8, 0.5, -0.3});
}

TEST(Billiard, InAnObliqueCylinderWithEndsKeepsItsAngle) {
  const double third = 1.0 / 3;
  const Vec3 axis{2 * third, -2 * third, third};
  expect_constant_angle(
      kOpen,
      {Surface(Cylinder(axis, 3), {}), Surface(Plane(axis), -2 * axis), Surface(Plane(-axis), 2 * axis)},
      {0.8, 0.5, -0.3});
}

// A piston does the work that the spheres gain, contact by contact.
TEST(MovingWall, DoesTheWorkThatSpheresGain) {
  for (const bool oscillates : {false, true}) {
    const Box box({Boundary::wall, Boundary::periodic, Boundary::periodic}, {20, 8, 8});
    const Shape shape =
        oscillates ? Shape(OscillatingPlane({-1, 0, 0}, 0.5, 0.375)) : Shape(Plane({-1, 0, 0}));
    World world(box, {}, {Surface(shape, {16, 0, 0}, oscillates ? Vec3{} : Vec3{-0.01, 0, 0})});
    Random random(5);
    for (int x = 0; x < 4; ++x) {
      for (int y = 0; y < 3; ++y) {
        for (int z = 0; z < 3; ++z) {
          world.add({{1.5 + 3.0 * x, 1 + 2.5 * y, 1 + 2.5 * z}, random.direction(), 0.5, 1});
        }
      }
    }
    Simulation simulation(world);
    simulation.run_contacts(20'000);
    const WallTally piston = simulation.tally().wall(kFaces);
    const double gained = energy(simulation.world(), simulation.now()) - simulation.tally().initial_energy();
    EXPECT_GT(piston.contacts, 1000U);
    EXPECT_NEAR(piston.work, gained, 1e-10 * std::fabs(gained));
    EXPECT_NEAR(piston.heat, 0, 1e-10 * std::fabs(gained));
    EXPECT_GT(gained, 0);
    EXPECT_EQ(simulation.tally().wall(face_of(0, false)).work, 0);
  }
}

// A sphere whose motion toward the floor has nearly died away.
TEST(MovingWall, MayMeetASphereInAges) {
  World world(Box::open(), {}, {Surface(OscillatingPlane({0, 0, 1}, 0.1, 0.3), {})});
  world.add({{0, 0, 3}, {0, 0, -1e-14}, 0.5, 1});
  Simulation simulation(world);
  simulation.run_until(1000);
  EXPECT_EQ(simulation.tally().wall(kFaces).contacts, 0U);
  simulation.run_until(2.3e14);
  EXPECT_EQ(simulation.tally().wall(kFaces).contacts, 0U);
  simulation.run_until(2.5e14);
  EXPECT_EQ(simulation.tally().wall(kFaces).contacts, 1U);
  EXPECT_GT(simulation.velocity(0).z, 0);
  EXPECT_LT(simulation.tally().max_overlap(), 1e-12);
}

TEST(Gravity, KeepsTheEnergyOfAGasBetweenWalls) {
  World world(Box::walls({12, 12, 12}), {0.5, 0, -2}, {Surface(Obstacle(2), {6, 6, 6})});
  Random random(11);
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 5; ++y) world.add({{1.5 + 2.0 * x, 1.5 + 2.0 * y, 10}, random.direction(), 0.5, 1.5});
  }
  const double energy = hardball::energy(world, Time(0));
  Simulation simulation(world);
  simulation.run_contacts(100'000);
  EXPECT_NEAR(hardball::energy(simulation.world(), simulation.now()), energy, 1e-10 * std::fabs(energy));
  simulation.validate();
}

}  // namespace
}  // namespace hardball::confinement_test
