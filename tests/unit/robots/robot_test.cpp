// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/robots/robot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "hardball/robots/kinematics.hpp"
#include "support/arm.hpp"
#include "support/refusal.hpp"

namespace hardball::robot_test {
namespace {

constexpr double kQuarter = 0x1.921fb54442d18p+0;

// An arm in a plane with a slide at its end, and a hand that is fixed to it.
Robot small_arm() {
  const std::vector<Link> links{{"base", {{{0, 0, 0}, 0.1}}},
                                {"upper", {{{1, 0, 0}, 0.1}}},
                                {"slider", {{{0, 0, 0}, 0.1}}},
                                {"hand", {{{0, 0.5, 0}, 0.1}}}};
  const std::vector<Joint> joints{
      {.name = "grip", .kind = JointKind::fixed, .parent = "slider", .child = "hand", .origin = {0.5, 0, 0}},
      {.name = "slide",
       .kind = JointKind::prismatic,
       .parent = "upper",
       .child = "slider",
       .origin = {2, 0, 0},
       .axis = {2, 0, 0}},
      {.name = "turn", .parent = "base", .child = "upper", .origin = {0, 0, 1}}};
  return Robot::from_spheres(links, joints);
}

TEST(Robot, PlacesItsSpheres) {
  const Robot robot = small_arm();
  ASSERT_EQ(robot.joint_count(), 2);
  EXPECT_EQ(robot.joint_names()[0], "slide") << "in the order of the joints";
  EXPECT_EQ(robot.link_of(3), 3);
  const std::vector<Vec3> straight = robot.centers(std::vector<double>{0.25, 0});
  EXPECT_EQ(straight[0], (Vec3{0, 0, 0}));
  EXPECT_EQ(straight[1], (Vec3{1, 0, 1}));
  EXPECT_EQ(straight[2], (Vec3{2.25, 0, 1}));
  EXPECT_EQ(straight[3], (Vec3{2.75, 0.5, 1}));
  const std::vector<Vec3> turned = robot.centers(std::vector<double>{0.25, kQuarter});
  EXPECT_LT(length(turned[3] - Vec3{-0.5, 2.75, 1}), 1e-15);
}

TEST(Robot, MeetsItselfWhereTwoJointsLieBetween) {
  const Robot robot = small_arm();
  ASSERT_EQ(robot.pairs().size(), 2) << "the base with the slider, and with the hand";
  EXPECT_EQ(robot.pairs()[0].first, 0);
  EXPECT_EQ(robot.pairs()[0].second, 2);
  EXPECT_EQ(robot.pairs()[0].ancestor, 0);
}

TEST(Robot, LocksJoints) {
  const std::vector<Link> links{{"base"}, {"upper", {{{1, 2, 3}, 0.1}}}, {"lower", {{{3, 2, 1}, 0.1}}}};
  std::vector<Joint> joints{{.name = "a", .parent = "base", .child = "upper", .axis = {1, 2, 3}},
                            {.name = "b",
                             .kind = JointKind::prismatic,
                             .parent = "upper",
                             .child = "lower",
                             .rotation = RotationMatrix::from_angles(1, 2, 3),
                             .axis = {0, 3, 4}}};
  const std::vector<Vec3> moved = Robot::from_spheres(links, joints).centers(std::vector<double>{0.7, 0.4});
  joints[0].locked = 0.7;
  const Robot half = Robot::from_spheres(links, joints);
  EXPECT_EQ(half.joint_count(), 1);
  EXPECT_LT(length(half.centers(std::vector<double>{0.4})[1] - moved[1]), 1e-14);
  joints[1].locked = 0.4;
  const Robot still = Robot::from_spheres(links, joints);
  EXPECT_EQ(still.joint_count(), 0);
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_LT(length(still.centers(std::vector<double>{})[k] - moved[k]), 1e-14);
}

TEST(Robot, HasLinksThatOnlyJointsName) {
  const Robot robot = Robot::from_spheres({{"hand", {{{1, 0, 0}, 0.1}}}},
                                          {{.name = "turn", .parent = "base", .child = "hand"}});
  ASSERT_EQ(robot.link_names().size(), 2);
  EXPECT_EQ(robot.link_names()[1], "base");
  EXPECT_EQ(robot.centers(std::vector<double>{0})[0], (Vec3{1, 0, 0}));
}

TEST(Robot, RefusesWhatIsNoTree) {
  const std::vector<Link> links{{"a"}, {"b"}, {"c"}};
  const Joint ab{.name = "ab", .parent = "a", .child = "b"};
  const Joint bc{.name = "bc", .parent = "b", .child = "c"};
  const auto problem = [](const std::vector<Link>& all, const std::vector<Joint>& joints) {
    return support::problem_of([&] { Robot::from_spheres(all, joints); });
  };
  EXPECT_EQ(problem(links, {ab, bc}), "");
  EXPECT_EQ(problem({}, {}), "there are no links");
  EXPECT_EQ(problem({{"a"}, {"a"}}, {}), "there are two links of one name");
  EXPECT_EQ(problem(links, {ab}), "it is not connected with the link 'a'");
  EXPECT_EQ(problem(links, {ab, bc, {.name = "ca", .parent = "c", .child = "a"}}), "the links form a circle");
  EXPECT_EQ(problem(links, {ab, bc, {.name = "ac", .parent = "a", .child = "c"}}),
            "it carries the link 'c', as the joint 'bc' does");
  EXPECT_EQ(problem(links, {ab, bc, {.name = "ab", .parent = "a", .child = "c"}}),
            "there are two joints of one name");
  EXPECT_EQ(problem(links, {ab, {.name = "x", .parent = "d", .child = "c"}}),
            "it is not connected with the link 'a'");
  Joint without_axis = bc;
  without_axis.axis = {};
  EXPECT_EQ(problem(links, {ab, without_axis}), "the axis is a vector of length zero");
  Joint sheared = bc;
  sheared.rotation.x = {1, 0.1, 0};
  EXPECT_EQ(problem(links, {ab, sheared}), "the rotation is none");
  Joint infinite = bc;
  infinite.origin.x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(problem(links, {ab, infinite}), "the origin is inf");
  EXPECT_EQ(problem({{"a", {{{}, 0}}}}, {}), "a radius is 0");
  EXPECT_EQ(support::problem_of([&] {
              Robot::from_spheres(links, {ab, bc}, {{"a", "e"}});
            }),
            "there is no link 'e'");
  EXPECT_EQ(support::problem_of([] { small_arm().centers(std::vector<double>{1}); }),
            "there are 1 coordinates");
}

// A robot whose joints turn and slide, in two branches.
Robot branched() {
  const std::vector<Link> links{{"base", {{{0.1, 0, 0}, 0.1}}},
                                {"trunk", {{{0.3, 0.2, 0.1}, 0.1}}},
                                {"left", {{{0.1, 0.2, 0.3}, 0.1}}},
                                {"right", {{{-0.3, 0.1, 0.2}, 0.1}}},
                                {"finger", {{{0.2, 0.1, -0.3}, 0.1}}}};
  const std::vector<Joint> joints{
      {.name = "a",
       .parent = "base",
       .child = "trunk",
       .origin = {0.1, 0.2, 0.5},
       .rotation = RotationMatrix::from_angles(0.3, 0.2, 0.1),
       .axis = {1, 2, 3}},
      {.name = "b",
       .kind = JointKind::prismatic,
       .parent = "trunk",
       .child = "left",
       .origin = {0.4, 0, 0.3},
       .axis = {1, 1, 0}},
      {.name = "c", .parent = "trunk", .child = "right", .origin = {-0.4, 0.1, 0.3}, .axis = {0, 1, 1}},
      {.name = "d", .parent = "left", .child = "finger", .origin = {0, 0.2, 0.3}, .axis = {1, 0, 0}}};
  return Robot::from_spheres(links, joints);
}

// The k-th derivative of a vector in time, by differences of the derivative before it.
Vec3 difference_of(const std::function<Vec3(double)>& function, double time) {
  constexpr double kStep = 1e-5;
  return (0.5 / kStep) * (function(time + kStep) - function(time - kStep));
}

TEST(Kinematics, DerivativesAreThoseOfPositions) {
  Random random(1);
  const Robot robot = branched();
  const JointTrajectory trajectory = support::random_trajectory(random, 4, 4, 2);
  Kinematics kinematics(robot, trajectory);
  kinematics.enter_piece(1);
  for (const Robot::BodySphere& sphere : robot.spheres()) {
    for (std::size_t ancestor = sphere.body;; ancestor = robot.bodies()[ancestor].parent) {
      for (double time = 0.1; time < 1; time += 0.2) {
        const CenterMotion motion = kinematics.motion_of(sphere, ancestor, time);
        const Vec3 velocity =
            difference_of([&](double t) { return kinematics.motion_of(sphere, ancestor, t).position; }, time);
        const Vec3 acceleration =
            difference_of([&](double t) { return kinematics.motion_of(sphere, ancestor, t).velocity; }, time);
        EXPECT_LT(length(motion.velocity - velocity), 1e-7);
        EXPECT_LT(length(motion.acceleration - acceleration), 1e-6);
      }
      if (ancestor == 0) break;
    }
  }
}

TEST(Kinematics, FramesAreThoseOfCenters) {
  Random random(2);
  const Robot robot = branched();
  const JointTrajectory trajectory = support::random_trajectory(random, 4, 4, 2);
  Kinematics kinematics(robot, trajectory);
  kinematics.enter_piece(2);
  for (double begin = 0; begin < 0.9; begin += 0.1) {
    kinematics.enter_window(begin, begin + 0.2);
    const std::vector<Vec3> centers = robot.centers(trajectory.coordinates_at(2 + (begin + 0.1)));
    for (std::size_t k = 0; k < robot.sphere_count(); ++k) {
      const CenterMotion motion = kinematics.motion_of(robot.spheres()[k], 0, begin + 0.1);
      Vec3 position;
      Vec3 velocity;
      kinematics.state_of(robot.spheres()[k], position, velocity);
      EXPECT_LT(length(position - motion.position), 1e-14);
      EXPECT_LT(length(velocity - motion.velocity), 1e-13);
      EXPECT_LT(length(position - centers[k]), 1e-14);
    }
  }
}

TEST(Kinematics, BoundsAreNotExceeded) {
  Random random(3);
  const Robot robot = branched();
  double closest = 0;
  for (int i = 0; i < 100; ++i) {
    const JointTrajectory trajectory = support::random_trajectory(random, 4, 3, 3);
    Kinematics kinematics(robot, trajectory);
    kinematics.enter_piece(0);
    const double begin = random.uniform();
    const double end = begin + (1 - begin) * random.uniform();
    kinematics.enter_window(begin, end);
    for (const Robot::BodySphere& sphere : robot.spheres()) {
      for (std::size_t ancestor = sphere.body;; ancestor = robot.bodies()[ancestor].parent) {
        const MotionBounds bounds = kinematics.bounds_of(sphere, ancestor);
        for (int k = 0; k <= 10; ++k) {
          const double time = begin + 0.1 * k * (end - begin);
          const CenterMotion motion = kinematics.motion_of(sphere, ancestor, time);
          const Vec3 jerk = difference_of(
              [&](double t) { return kinematics.motion_of(sphere, ancestor, t).acceleration; }, time);
          EXPECT_LE(length(motion.velocity), bounds.speed * (1 + 1e-12) + 1e-15);
          EXPECT_LE(length(motion.acceleration), bounds.acceleration * (1 + 1e-12) + 1e-15);
          if (k > 0 && k < 10) {
            EXPECT_LE(length(jerk), bounds.jerk * (1 + 1e-4) + 1e-5);
          }
          if (bounds.jerk > 0) closest = std::max(closest, length(jerk) / bounds.jerk);
        }
        if (ancestor == 0) break;
      }
    }
  }
  EXPECT_GT(closest, 0.5) << "they are not idle";
}

}  // namespace
}  // namespace hardball::robot_test
