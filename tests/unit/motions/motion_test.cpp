// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Curves, their chords, and tables of knots.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/motions/driven_motion.hpp"
#include "hardball/motions/keyframes.hpp"
#include "hardball/motions/prescribed_motion.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/effort.hpp"
#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::motion_test {
namespace {

using namespace support;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using LongVector = std::array<long double, kAxes>;

// Where a body that began at `from` is after a time.
LongVector on_curve(const Rotation& rotation, const Vec3& from, long double time) {
  const long double angle = 2 * std::numbers::pi_v<long double> * rotation.frequency() * time;
  const Vec3& n = rotation.axis();
  const LongVector arm{static_cast<long double>(from.x) - rotation.point().x,
                       static_cast<long double>(from.y) - rotation.point().y,
                       static_cast<long double>(from.z) - rotation.point().z};
  const LongVector across{n.y * arm[2] - n.z * arm[1], n.z * arm[0] - n.x * arm[2],
                          n.x * arm[1] - n.y * arm[0]};
  const long double along = n.x * arm[0] + n.y * arm[1] + n.z * arm[2];
  LongVector place{};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    place[axis] = rotation.point()[axis] + along * n[axis] + std::cos(angle) * (arm[axis] - along * n[axis]) +
                  std::sin(angle) * across[axis];
  }
  return place;
}

long double distance(const LongVector& a, const Vec3& b) {
  long double sum = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
  return std::sqrt(sum);
}

Sphere kinematic_at(const Vec3& position) {
  return {.position = position, .radius = 0.1, .mass = kInfinity};
}

Simulation driven(const Vec3& from, const Vec3& gravity, const PrescribedMotion& motion) {
  World world(Box::open(), gravity);
  world.add(kinematic_at(from));
  Simulation simulation(world);
  simulation.drive(DrivenMotion("arm", motion, {0}));
  return simulation;
}

TEST(Rotation, IsFollowedWithinItsTolerance) {
  Random random(3);
  for (std::uint64_t k = 0; k < cases(200); ++k) {
    const Vec3 axis = random.normal_vector(kAxes);
    const Vec3 point = random.normal_vector(kAxes);
    const Vec3 from = point + 2 * random.normal_vector(kAxes);
    const double tolerance = std::pow(10.0, -1 - 5 * random.uniform());
    const double frequency = random.normal();
    const Vec3 gravity = k % 2 == 0 ? Vec3{} : 3 * random.normal_vector(kAxes);
    const auto motion = PrescribedMotion::rotation(point, axis, frequency, tolerance);
    Simulation simulation = driven(from, gravity, motion);
    double time = 0;
    double farthest = 0;
    for (int step = 0; step < 40; ++step) {
      time += random.uniform() * 3 * simulation.motions().front().chord();
      simulation.run_until(time);
      const LongVector exact = on_curve(std::get<Rotation>(motion.kind()), from, time);
      farthest = std::max(farthest, static_cast<double>(distance(exact, simulation.position(0))));
    }
    EXPECT_LE(farthest, tolerance * (1 + 1e-9) + 1e-13);
    EXPECT_GT(farthest, 0);
  }
}

TEST(Rotation, DoesNotAddUpRounding) {
  const Vec3 from{3, 0.5, 0.25};
  const auto motion = PrescribedMotion::rotation({1, 0, 0}, {0, 0, 2}, 0.7, 0.05);
  Simulation simulation = driven(from, {}, motion);
  simulation.run_until(1000);
  const double knot = simulation.motions().front().next();
  simulation.run_until(knot);
  const LongVector exact = on_curve(std::get<Rotation>(motion.kind()), from, knot);
  EXPECT_LT(distance(exact, simulation.position(0)), 2e-15);
  EXPECT_EQ(simulation.world().path(0).time, Time(knot));
}

TEST(Oscillation, ReachesItsEnds) {
  Simulation simulation = driven({1, 2, 3}, {}, PrescribedMotion::oscillation({0, 3, 0}, 0.5, 0.25, 0.01));
  simulation.run_until(1);
  EXPECT_EQ(simulation.position(0), (Vec3{1, 2.5, 3}));
  simulation.run_until(3);
  EXPECT_EQ(simulation.position(0), (Vec3{1, 1.5, 3}));
  simulation.run_until(4004);
  EXPECT_EQ(simulation.position(0), (Vec3{1, 2, 3}));
}

TEST(Keyframes, AreStraightLines) {
  const std::vector<Keyframe> rows{{1, {5, 5, 5}}, {2, {6, 5, 5}}, {4, {6, 5, 9}}};
  Simulation simulation = driven({0, 1, 2}, {}, PrescribedMotion::keyframes(rows));
  const auto expect = [&](double time, const Vec3& position) {
    simulation.run_until(time);
    EXPECT_EQ(simulation.position(0), position) << time;
  };
  expect(0.5, {0, 1, 2});
  expect(1, {0, 1, 2});
  expect(1.25, {0.25, 1, 2});
  expect(2, {1, 1, 2});
  expect(3, {1, 1, 4});
  expect(4, {1, 1, 6});
  EXPECT_EQ(simulation.velocity(0), (Vec3{}));
  EXPECT_EQ(simulation.motions().front().next(), kInfinity);
  expect(40, {1, 1, 6});
}

TEST(Keyframes, RepeatForEver) {
  const std::vector<Keyframe> rows{{0, {}}, {1, {2, 0, 0}}, {3, {2, 4, 0}}, {4, {1e-13, 0, 0}}};
  Simulation simulation = driven({7, 7, 7}, {}, PrescribedMotion::keyframes(rows, true));
  simulation.run_until(401);
  EXPECT_EQ(simulation.position(0), (Vec3{9, 7, 7}));
  EXPECT_EQ(simulation.velocity(0), (Vec3{0, 2, 0}));
  simulation.run_until(4000);
  EXPECT_EQ(simulation.position(0), (Vec3{7, 7, 7}));
}

TEST(Keyframes, StayWithinTheToleranceUnderGravity) {
  const std::vector<Keyframe> rows{{0.5, {}}, {1, {2, 0, 0}}, {3, {2, 4, 1}}};
  constexpr double kTolerance = 1e-3;
  Simulation simulation =
      driven({1, 1, 1}, {0, 0, -10}, PrescribedMotion::keyframes(rows, false, kTolerance));
  const auto at = [](double time) {
    if (time < 0.5) return Vec3{1, 1, 1};
    if (time < 1) return Vec3{1, 1, 1} + (2 * (time - 0.5)) * Vec3{2, 0, 0};
    return Vec3{3, 1, 1} + (std::min(2.0, time - 1) / 2) * Vec3{0, 4, 1};
  };
  double farthest = 0;
  for (double time = 0; time < 6; time += 0.0123) {
    simulation.run_until(time);
    farthest = std::max(farthest, length(simulation.position(0) - at(time)));
  }
  EXPECT_LE(farthest, kTolerance * (1 + 1e-9));
  EXPECT_GT(farthest, 0.9 * kTolerance) << "chords are no shorter than they must be";
}

TEST(SampledMotion, FollowsAFunction) {
  const auto curve = [](double t) { return Vec3{t * t, 0, t}; };
  Simulation simulation = driven({}, {}, PrescribedMotion::sampled(curve, 3, 2, 1e-4));
  double farthest = 0;
  for (double time = 0; time < 3; time += 0.001) {
    simulation.run_until(time);
    farthest = std::max(farthest, length(simulation.position(0) - curve(time)));
  }
  EXPECT_LE(farthest, 1e-4 * (1 + 1e-9));
  EXPECT_GT(farthest, 0.9e-4);
}

TEST(Motions, AreRefused) {
  const auto expect = [](const std::string& refusal, const std::string& what) {
    EXPECT_NE(refusal.find(what), std::string::npos) << refusal;
  };
  const auto keyframes = [&](const std::vector<Keyframe>& rows, bool repeats = false) {
    return refusal_of([&] { Keyframes(rows, repeats); });
  };
  expect(keyframes({}), "0 knots");
  expect(keyframes({{-1, {}}}), "knot 0 (t = -1) is before the motion begins");
  expect(keyframes({{0, {}}, {1, {}}, {1, {}}}), "knot 2 (t = 1) is not later than knot 1 (t = 1)");
  expect(keyframes({{0, {}}, {1, {0, 0, 2e-12}}}, true), "knot 1 (t = 1) is 2e-12 away");
  expect(keyframes({{0, {}}}, true), "one knot");
  EXPECT_EQ(keyframes({{0, {}}, {1, {0, 0, 1e-12}}}, true), "");
  expect(refusal_of([] { Rotation({}, {}, 1); }), "axis");
  expect(refusal_of([] { Rotation({}, {1, 0, 0}, 0); }), "frequency");
  expect(refusal_of([] { PrescribedMotion::rotation({}, {1, 0, 0}, 1, 0); }), "tolerance");
  const auto still = PrescribedMotion::keyframes({{0, {}}, {1, {1, 0, 0}}});
  const auto refused = [&](const DrivenMotion& motion, const Vec3& gravity = {}) {
    World world(Box::open(), gravity, {Surface(Plane({0, 0, 1}), {})});
    world.add(kinematic_at({0, 0, 4}));
    world.add({.position = {1, 0, 4}, .radius = 0.1});
    return refusal_of([&] {
      Simulation simulation(world);
      simulation.drive(DrivenMotion("a", PrescribedMotion::oscillation({1, 0, 0}, 1, 1, 0.1), {0}));
      simulation.drive(motion);
    });
  };
  expect(refused(DrivenMotion("b", still, {0})), "two motions drive sphere 0");
  expect(refused(DrivenMotion("b", still, {1})), "sphere 1 is not kinematic");
  expect(refused(DrivenMotion("b", still, {2})), "there is no sphere 2");
  expect(refused(DrivenMotion("b", still, {})), "drives nothing");
  expect(refused(DrivenMotion("b", still, {}, {7})), "no surface 7");
  expect(refused(DrivenMotion("b", PrescribedMotion::rotation({}, {0, 0, 1}, 1, 1), {}, {6})),
         "a plane does not rotate");
  EXPECT_EQ(refused(DrivenMotion("b", still, {}, {6})), "");
  DrivenMotion pressed("b", still, {}, {6});
  expect(refusal_of([&] { pressed.stop_at_pressure(0, 1); }), "pressure");
  expect(refusal_of([&] { pressed.stop_at_pressure(1, -1); }), "interval");
  pressed.stop_at_pressure(1, 1);
  expect(refused(pressed), "planes across axes of the box");  // which has no faces
}

TEST(Motions, AreNeededUnderGravity) {
  World world(Box::open(), {0, 0, -1});
  world.add(kinematic_at({}));
  Simulation simulation(world);
  EXPECT_NE(refusal_of([&] { simulation.run_until(1); }).find("does not fall"), std::string::npos);
  EXPECT_NE(refusal_of([&] { simulation.next_contact(1); }).find("does not fall"), std::string::npos);
  const std::string untold = refusal_of([&] {
    simulation.drive(DrivenMotion("a", PrescribedMotion::keyframes({{0, {}}}), {0}));
  });
  EXPECT_NE(untold.find("tolerance"), std::string::npos) << untold;
  simulation.drive(DrivenMotion("a", PrescribedMotion::keyframes({{0, {}}}, false, 0.01), {0}));
  simulation.run_until(1);
  EXPECT_NEAR(simulation.position(0).z, 0, 0.01);
  simulation.stop_driving();
  EXPECT_NE(refusal_of([&] { simulation.run_until(2); }), "");
}

TEST(Motions, EndWhereAWallReflectsTheirSpheres) {
  World world(Box::walls({4, 4, 4}));
  world.add(kinematic_at({2, 2, 2}));
  Simulation simulation(world);
  simulation.drive(DrivenMotion("a", PrescribedMotion::oscillation({1, 0, 0}, 3, 1, 0.01), {0}));
  try {
    simulation.run_until(1);
    FAIL();
  } catch (const RunFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("a wall has reflected it"), std::string::npos);
  }
}

TEST(KeyframeFiles, AreRead) {
  const std::vector<Keyframe> expected{{0, {1, 2, 3}}, {0.5, {-1, 2e-3, 4}}};
  for (const std::string text :
       {"0,1,2,3\n0.5,-1,2e-3,4\n", "t,x,y,z\n0, 1, 2, 3\n\n# a remark\n0.5; -1; 0.002; 4",
        "0 1 2 3\n0.5\t-1 .002 4\r\n"})
    EXPECT_EQ(parse_keyframes(text, "knots.csv"), expected) << text;
  EXPECT_EQ(parse_keyframes("0,1,2\n", "knots.csv", 2), (std::vector<Keyframe>{{0, {1, 2, 0}}}));
  const ScratchFolder folder;
  const auto file = folder.path() / "knots.csv";
  std::ofstream(file) << "0,1,2,3\n0.5,-1,2e-3,4\n";
  EXPECT_EQ(read_keyframes(file), expected);
}

TEST(KeyframeFiles, AreRefusedWithTheirLine) {
  const auto expect = [](const std::string& text, const std::string& where, const std::string& what) {
    const Error error = error_of([&] { parse_keyframes(text, "knots.csv"); });
    EXPECT_EQ(error.where().find(where), 0U) << error.where();
    EXPECT_NE(error.problem().find(what), std::string::npos) << error.problem();
  };
  expect("", "knots.csv", "no rows");
  expect("t,x,y,z\n", "knots.csv", "no rows");
  expect("0,1,2\n", "knots.csv:1", "3 values");
  expect("0,1,2,3,4\n", "knots.csv:1", "5 values");
  expect("0,1,2,3\n1,1,x,3\n", "knots.csv:2", "y");
  expect("0,1,2,3\n1,1,nan,3\n", "knots.csv:2", "y");
  expect("0,1,2,3\n1,1,2,3\n1,1,2,3\n", "knots.csv:3", "knot 2 (t = 1) is not later than knot 1");
  EXPECT_NE(refusal_of([] { read_keyframes("/nowhere/knots.csv"); }), "");
}

}  // namespace
}  // namespace hardball::motion_test
