// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/robots/robot_queries.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/arm.hpp"
#include "support/effort.hpp"
#include "support/refusal.hpp"

namespace hardball::robot_queries_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A sphere that slides along x.
Robot piston(double radius) {
  return Robot::from_spheres({{"base"}, {"piston", {{{}, radius}}}}, {{.name = "slide",
                                                                       .kind = JointKind::prismatic,
                                                                       .parent = "base",
                                                                       .child = "piston",
                                                                       .axis = {1, 0, 0}}});
}

// One that turns about z at a distance of one, and starts on the axis x.
Robot rotor(double radius) {
  return Robot::from_spheres({{"base"}, {"rotor", {{{1, 0, 0}, radius}}}},
                             {{.name = "turn", .parent = "base", .child = "rotor"}});
}

JointTrajectory one_piece(double end, const JointTrajectory::Cubic& cubic) {
  return JointTrajectory::from_pieces({0, end}, {{cubic}});
}

TEST(FirstContact, OfAPistonIsExact) {
  Obstacles obstacles;
  obstacles.add_sphere({2.728, 0, 0}, 0.5);
  const auto contact = first_contact(piston(0.5), one_piece(2, {0, 0, 0, 1}), obstacles);
  ASSERT_TRUE(contact);
  EXPECT_NEAR(contact->time, 1.2, 4 * 0x1p-52);
  EXPECT_EQ(contact->sphere, 0);
  EXPECT_EQ(contact->obstacle, 0);
  EXPECT_FALSE(contact->other_sphere);
  EXPECT_NEAR(contact->point.x, 2.228, 1e-15);
  EXPECT_LT(length(contact->normal - Vec3{-1, 0, 0}), 1e-15);
  EXPECT_FALSE(first_contact(piston(0.5), one_piece(1.1999, {0, 0, 0, 1}), obstacles));
  // With clearance, x = 1.628.
  const auto early = first_contact(piston(0.5), one_piece(2, {0, 0, 0, 1}), obstacles, 0.1);
  ASSERT_TRUE(early);
  EXPECT_NEAR(early->time, std::cbrt(1.628), 1e-15);
  EXPECT_NEAR(early->distance, 0.1, 1e-15);
}

TEST(FirstContact, WithEachShapeIsExact) {
  // The piston reaches x = 1 at t = 2; each shape is touched there by a radius of .25.
  const JointTrajectory trajectory = JointTrajectory::linear({1, 4}, {{0}, {3}});
  std::vector<Obstacles> all(5);
  all[0].add_box({1.75, 0, 0}, {1, 1, 1});
  all[1].add_capsule({1.5, -1, 0}, {1.5, 1, 0}, 0.25);
  all[2].add_plane({1.25, 0, 0}, {-1, 0, 0});
  const std::vector<Vec3> corners{{1.25, -1, -1}, {1.25, 1, -1}, {1.25, 0, 1}};
  const std::vector<std::array<std::uint32_t, 3>> faces{{0, 1, 2}};
  all[3].add_mesh(corners, faces);
  // It comes from the right, and is at 1.5 at t = 2.
  all[4].add_sphere({3.5, 0, 0}, 0.25, {-1, 0, 0}, 0);
  for (const Obstacles& obstacles : all) {
    const auto contact = first_contact(piston(0.25), trajectory, obstacles);
    ASSERT_TRUE(contact);
    EXPECT_NEAR(contact->time, 2, 1e-15);
    EXPECT_NEAR(contact->distance, 0, 1e-15);
    EXPECT_LT(length(contact->point - Vec3{1.25, 0, 0}), 1e-15);
    EXPECT_LT(length(contact->normal - Vec3{-1, 0, 0}), 1e-15);
  }
}

TEST(FirstContact, WithItselfIsFound) {
  // Two spheres at the distance one, on arms of one joint each, which turn toward each other.
  const Robot robot = Robot::from_spheres(
      {{"base"}, {"left", {{{1, 0, 0}, 0.25}}}, {"right", {{{-1, 0, 0}, 0.25}}}},
      {{.name = "a", .parent = "base", .child = "left"}, {.name = "b", .parent = "base", .child = "right"}});
  const JointTrajectory trajectory = JointTrajectory::linear({0, 3}, {{0, 0}, {1.5, -1.5}});
  const auto contact = first_contact(robot, trajectory, Obstacles());
  ASSERT_TRUE(contact);
  EXPECT_EQ(contact->sphere, 0);
  EXPECT_EQ(contact->other_sphere, 1);
  EXPECT_FALSE(contact->obstacle);
  // Their distance is 2 cos(t / 2).
  EXPECT_NEAR(contact->time, 2 * std::acos(0.25), 1e-15);
  EXPECT_NEAR(contact->point.x, 0, 1e-15);
  EXPECT_LT(length(contact->normal - Vec3{1, 0, 0}), 1e-15);
  const Robot ignoring = Robot::from_spheres(
      {{"base"}, {"left", {{{1, 0, 0}, 0.25}}}, {"right", {{{-1, 0, 0}, 0.25}}}},
      {{.name = "a", .parent = "base", .child = "left"}, {.name = "b", .parent = "base", .child = "right"}},
      {{"right", "left"}});
  EXPECT_FALSE(first_contact(ignoring, trajectory, Obstacles()));
}

TEST(FirstContact, GrazesAreDecided) {
  // At its nearest, the rotor is at a distance of one from the obstacle's center.
  const JointTrajectory trajectory = JointTrajectory::linear({0, 1}, {{-1}, {2}});
  for (const double depth : {1e-2, 1e-6, 1e-12, 1e-14}) {
    Obstacles hit;
    hit.add_sphere({2, 0, 0}, 0.5 + depth);
    const auto contact = first_contact(rotor(0.5), trajectory, hit);
    ASSERT_TRUE(contact) << depth;
    EXPECT_LT(contact->time, 1.0 / 3);
    EXPECT_LT(std::fabs(contact->distance), 1e-15);
    Obstacles missed;
    missed.add_sphere({2, 0, 0}, 0.5 - depth);
    EXPECT_FALSE(first_contact(rotor(0.5), trajectory, missed)) << depth;
  }
}

TEST(FirstContact, OrbitsAtAConstantDistanceEnd) {
  const JointTrajectory trajectory = JointTrajectory::linear({0, 100}, {{0}, {628}});
  Obstacles inner;
  inner.add_sphere({}, 0.5 - 1e-9);
  inner.add_plane({0, 0, -0.5 - 1e-9}, {0, 0, 1});
  EXPECT_FALSE(first_contact(rotor(0.5), trajectory, inner));
}

TEST(FirstContact, AtTheBeginIsAnOverlap) {
  Obstacles obstacles;
  obstacles.add_box({0, 0, 0}, {1, 1, 1});
  const auto contact = first_contact(piston(0.1), JointTrajectory::linear({2, 3}, {{0}, {5}}), obstacles);
  ASSERT_TRUE(contact);
  EXPECT_EQ(contact->time, 2);
  EXPECT_EQ(contact->normal, Vec3{}) << "the center is within";
  // A clearance below zero lets a robot leave what it touches.
  Obstacles touched;
  touched.add_plane({-0.1, 0, 0}, {1, 0, 0});
  const JointTrajectory away = JointTrajectory::linear({2, 3}, {{0}, {5}});
  EXPECT_TRUE(first_contact(piston(0.1), away, touched));
  EXPECT_FALSE(first_contact(piston(0.1), away, touched, -1e-9));
}

TEST(FirstContact, OfSimultaneousOnesTheLowestNumbersComeFirst) {
  const Robot robot =
      Robot::from_spheres({{"base"}, {"piston", {{{0, 1, 0}, 0.25}, {{0, 0, 0}, 0.25}, {{0, 2, 0}, 0.25}}}},
                          {{.name = "slide",
                            .kind = JointKind::prismatic,
                            .parent = "base",
                            .child = "piston",
                            .axis = {1, 0, 0}}});
  Obstacles obstacles;
  obstacles.add_sphere({5, 2, 0}, 0.25);
  obstacles.add_sphere({5, 0, 0}, 0.25);
  obstacles.add_plane({4.75, 0, 0}, {-1, 0, 0});
  obstacles.add_sphere({5, 1, 0}, 0.25);
  const auto contact = first_contact(robot, JointTrajectory::linear({0, 8}, {{0}, {8}}), obstacles);
  ASSERT_TRUE(contact);
  EXPECT_EQ(contact->time, 4.5);
  EXPECT_EQ(contact->sphere, 0);
  EXPECT_EQ(contact->obstacle, 2);
}

TEST(FirstContact, LeavesOutWhatDoesNotMove) {
  const Robot robot = Robot::from_spheres({{"base", {{{}, 0.5}}}, {"rotor", {{{3, 0, 0}, 0.5}}}},
                                          {{.name = "turn", .parent = "base", .child = "rotor"}});
  const JointTrajectory trajectory = JointTrajectory::linear({0, 10}, {{0}, {1}});
  Obstacles obstacles;
  obstacles.add_box({0, 0, -0.4}, {1, 1, 1});
  obstacles.add_sphere({0, 0, 0}, 1);
  EXPECT_FALSE(first_contact(robot, trajectory, obstacles)) << "the base stands in them";
  obstacles.add_sphere({0, 0, 5}, 0.5, {0, 0, -1});
  const auto contact = first_contact(robot, trajectory, obstacles);
  ASSERT_TRUE(contact);
  EXPECT_NEAR(contact->time, 4, 1e-15);
  EXPECT_EQ(contact->sphere, 0);
  EXPECT_EQ(contact->obstacle, 2);
}

// A random question, with all kinds of obstacles.
struct Question {
  Robot robot;
  JointTrajectory trajectory;
  Obstacles obstacles;
};

Question random_question(Random& random, bool meets_itself) {
  Robot robot = support::arm(random, 40, meets_itself);
  JointTrajectory trajectory =
      support::random_trajectory(random, robot.joint_count(), 5, meets_itself ? 2.8 : 1.5);
  Obstacles obstacles =
      support::random_obstacles(random, 3 + random.bits() % 20, 0.02 + 0.1 * random.uniform(), 0.5, false);
  for (std::size_t k = 0; k < random.bits() % 4; ++k)
    obstacles.add_sphere(2 * random.direction(), 0.1, random.direction(), random.uniform());
  if (random.bits() % 2 == 0) obstacles.add_plane({0, 0, -0.6 - random.uniform()}, {0.1, 0, 1});
  return {std::move(robot), std::move(trajectory), std::move(obstacles)};
}

// The least distance at one time, by all pairs.
double least_distance_at(const Question& question, double time) {
  const auto& [robot, trajectory, obstacles] = question;
  const std::vector<Vec3> centers = robot.centers(trajectory.coordinates_at(time));
  double least = kInfinity;
  for (std::size_t k = 0; k < centers.size(); ++k) {
    for (std::size_t item = 0; item < obstacles.size(); ++item)
      least = std::min(least,
                       nearest_of(obstacles.item(item).shape, centers[k], time).distance - robot.radius(k));
  }
  for (const Robot::SpherePair& pair : robot.pairs()) {
    const double distance = length(centers[pair.first] - centers[pair.second]);
    least = std::min(least, distance - robot.radius(pair.first) - robot.radius(pair.second));
  }
  return least;
}

TEST(FirstContact, ComesBeforeAllThatSamplesSee) {
  constexpr double kRounding = 1e-14;
  constexpr int kPoses = 200;
  Random random(11);
  std::size_t hits = 0;
  std::size_t own = 0;
  std::size_t late = 0;
  const std::uint64_t count = support::cases(200);
  for (std::uint64_t n = 0; n < count; ++n) {
    const Question question = random_question(random, n % 2 == 0);
    const auto contact = first_contact(question.robot, question.trajectory, question.obstacles);
    const double end = contact ? contact->time : question.trajectory.end();
    for (int k = 0; k < kPoses; ++k) {
      const double time = question.trajectory.end() * random.uniform();
      if (time < end) {
        ASSERT_GT(least_distance_at(question, time), -kRounding) << n << " at " << time;
      }
    }
    if (!contact) continue;
    ++hits;
    if (contact->other_sphere) ++own;
    if (contact->time > 1) ++late;
    const double least = least_distance_at(question, contact->time);
    if (contact->time > 0) {
      EXPECT_LT(std::fabs(contact->distance), 5e-15);
      EXPECT_LT(std::fabs(least), kRounding);
    }
    EXPECT_NEAR(contact->distance, least, contact->time > 0 ? kRounding : 1);
  }
  EXPECT_GT(hits, count / 4);
  EXPECT_LT(hits, count);
  if (count > 100) {
    EXPECT_GT(own, 0);
  }
  EXPECT_GT(late, count / 10);
}

TEST(FirstContact, DoesNotDependOnWhatIsNotTouched) {
  Random random(12);
  for (std::uint64_t n = 0; n < support::cases(100); ++n) {
    Question question = random_question(random, n % 2 == 0);
    const auto contact = first_contact(question.robot, question.trajectory, question.obstacles);
    // Near misses among them.
    for (int k = 0; k < 20; ++k) {
      Obstacles more = question.obstacles;
      more.add_sphere(1.2 * random.uniform() * random.direction(), 0.01);
      const auto again = first_contact(question.robot, question.trajectory, more);
      if (again && again->obstacle == more.size() - 1) continue;
      EXPECT_EQ(again, contact);
    }
  }
}

TEST(FirstContact, IsTheSameInThreads) {
  Random random(13);
  const Question question = random_question(random, true);
  std::vector<JointTrajectory> trajectories;
  for (int k = 0; k < 30; ++k)
    trajectories.push_back(support::random_trajectory(random, question.robot.joint_count(), 4, 1));
  const auto contacts = first_contacts(question.robot, trajectories, question.obstacles, 0.01, 3);
  EXPECT_EQ(contacts, first_contacts(question.robot, trajectories, question.obstacles, 0.01, 1));
  const auto nearest = least_clearances(question.robot, trajectories, question.obstacles, 1e-6, 3);
  for (std::size_t k = 0; k < trajectories.size(); ++k) {
    EXPECT_EQ(contacts[k], first_contact(question.robot, trajectories[k], question.obstacles, 0.01));
    EXPECT_EQ(nearest[k], least_clearance(question.robot, trajectories[k], question.obstacles, 1e-6));
  }
}

TEST(LeastClearance, IsExactWhereItIsKnown) {
  Obstacles obstacles;
  obstacles.add_sphere({2.5, 0, 0}, 0.5);
  obstacles.add_sphere({0, 0, 4}, 0.5);
  const auto nearest =
      least_clearance(rotor(0.25), JointTrajectory::linear({0, 2}, {{-1}, {1.5}}), obstacles, 1e-12);
  ASSERT_TRUE(nearest);
  EXPECT_NEAR(nearest->distance, 0.75, 1e-12);
  EXPECT_NEAR(nearest->time, 0.8, 1e-5);
  EXPECT_EQ(nearest->obstacle, 0);
  EXPECT_LT(length(nearest->normal - Vec3{-1, 0, 0}), 1e-5);
  EXPECT_FALSE(least_clearance(rotor(0.25), JointTrajectory::linear({0, 2}, {{-1}, {1.5}}), Obstacles()));
  // At the end of the trajectory.
  const auto last = least_clearance(piston(0.5), JointTrajectory::linear({0, 1}, {{0}, {1}}), obstacles);
  ASSERT_TRUE(last);
  EXPECT_NEAR(last->distance, 0.5, 1e-9);
  EXPECT_NEAR(last->time, 1, 1e-8);
}

TEST(LeastClearance, IsLessThanWhatSamplesSee) {
  constexpr double kTolerance = 1e-7;
  Random random(14);
  for (std::uint64_t n = 0; n < support::cases(100); ++n) {
    const Question question = random_question(random, n % 2 == 0);
    const auto nearest = least_clearance(question.robot, question.trajectory, question.obstacles, kTolerance);
    ASSERT_TRUE(nearest);
    EXPECT_NEAR(least_distance_at(question, nearest->time), nearest->distance, 1e-14);
    for (int k = 0; k < 200; ++k) {
      const double time = question.trajectory.end() * random.uniform();
      EXPECT_GE(least_distance_at(question, time), nearest->distance - kTolerance);
    }
    // Both queries agree; at the begin, an overlap is a contact.
    if (nearest->distance < -0.015) continue;
    EXPECT_TRUE(first_contact(question.robot, question.trajectory, question.obstacles, nearest->distance));
    EXPECT_FALSE(first_contact(question.robot, question.trajectory, question.obstacles,
                               nearest->distance - 2 * kTolerance));
  }
}

TEST(RobotQueries, RefuseWhatDoesNotFit) {
  const Robot robot = piston(0.5);
  const JointTrajectory trajectory = JointTrajectory::linear({0, 1}, {{0}, {1}});
  const JointTrajectory other = JointTrajectory::linear({0, 1}, {{0, 1}, {1, 0}});
  const auto problem = [](auto&& act) { return support::problem_of(act); };
  EXPECT_EQ(problem([&] { first_contact(robot, other, Obstacles()); }), "the trajectory is of 2 joints");
  EXPECT_EQ(problem([&] { first_contact(robot, trajectory, Obstacles(), kInfinity); }),
            "the clearance is inf");
  EXPECT_EQ(problem([&] { first_contact(robot, trajectory, Obstacles(), -0.5); }), "the clearance is -0.5");
  EXPECT_EQ(problem([&] { least_clearance(robot, trajectory, Obstacles(), 0); }), "the tolerance is 0");
}

}  // namespace
}  // namespace hardball::robot_queries_test
