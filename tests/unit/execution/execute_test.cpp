// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/execution/execute.hpp"

#include <gtest/gtest.h>
#include <algorithm>

#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/interaction/restitution.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/world/pair_event.hpp"
#include "hardball/world/walls.hpp"
#include "support/refusal.hpp"

namespace hardball::execute_test {
namespace {

double approach_after(const Contact& contact) {
  return approach(contact.separation, contact.after);
}

TEST(ContactAt, DescribesACollisionThroughTheEdgeOfAPeriodicBox) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{5, 5, 5}, {}, 1, 1});
  world.remove(0);
  world.add({{3, 5, 5}, {-1, 0, 0}, 1, 2});
  world.add({{6, 5, 5}, {1, 0, 0}, 0.5, 3});
  const Event event = make_collision(contact_time(world, 0, 1, {{-1, 0, 0}}), 1, 2, {{-1, 0, 0}});
  ASSERT_EQ(event.time, Time(2.75));
  Executed done;
  contact_at(world, event, participants_of(world, event), done);
  const Contact& contact = done.contact;
  EXPECT_EQ(contact.first, 1U) << "an id, not a slot";
  EXPECT_EQ(contact.second, 2U);
  EXPECT_EQ(contact.position, (Vec3{0.25, 5, 5}));
  EXPECT_EQ(contact.separation, (Vec3{-1.5, 0, 0}));
  EXPECT_EQ(contact.normal(), (Vec3{-1, 0, 0}));
  EXPECT_EQ(contact.point(), (Vec3{-0.75, 5, 5}));
  EXPECT_EQ(contact.reach, 1.5);
  EXPECT_EQ(contact.overlap(), 0);
  EXPECT_EQ(contact.first_mass, 2);
  EXPECT_EQ(contact.second_mass, 3);
  EXPECT_EQ(contact.impact_speed(), 2);
  EXPECT_EQ(contact.image, (Image{{-1, 0, 0}}));
  EXPECT_EQ(done.folded[0], Image{});
  EXPECT_EQ(done.folded[1], Image{});
  EXPECT_EQ(contact.after, contact.before);
}

TEST(ParticipantsOf, AreTheSlotsOfTheIdsThatAnEventNames) {
  World world(Box::walls({10, 10, 10}));
  for (const double x : {2.0, 4.0, 6.0, 8.0}) world.add({{x, 5, 5}, {1, 0, 0}, 0.5, 1});
  world.remove(1);
  world.reorder(std::array<Slot, 3>{2, 0, 1});
  const Participants collision = participants_of(world, make_collision(Time(1), 3, 2, {}));
  EXPECT_EQ(collision.first, 0U) << "the sphere with the lower id";
  EXPECT_EQ(collision.second, 2U);
  // Face 1 is not a slot.
  EXPECT_EQ(participants_of(world, {Time(1), EventKind::wall, 3, 1, {}}).first, 2U);
  EXPECT_THROW(participants_of(world, make_collision(Time(1), 1, 2, {})), Error) << "it has been removed";
}

TEST(Contact, NormalPointsAlongTheSeparationOrTowardsTheWall) {
  Contact contact;
  contact.separation = {0, -8, 0};
  EXPECT_EQ(contact.normal(), (Vec3{0, -1, 0}));
  contact.kind = EventKind::wall;
  contact.wall_normal = {0, 0, 1};
  // Whatever rounding has done to the distance, even if it has changed its sign.
  contact.separation = {0, 0, -1e-17};
  EXPECT_EQ(contact.normal(), (Vec3{0, 0, 1}));
}

TEST(ContactAt, CountsTheImageBetweenFoldedCenters) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{9, 5, 5}, {2, 0, 0}, 0.5, 1});
  world.add({{4, 5, 5}, {0, 0, 0}, 0.5, 1});
  // The first flies on to the second's next image, across the edge of the box: from 9 to 13.
  const Event event = make_collision(contact_time(world, 0, 1, {{1, 0, 0}}), 0, 1, {{1, 0, 0}});
  ASSERT_EQ(event.time, Time(2));
  Executed done;
  contact_at(world, event, participants_of(world, event), done);
  const Contact& contact = done.contact;
  EXPECT_EQ(contact.position, (Vec3{3, 5, 5}));
  EXPECT_EQ(contact.image, Image{});
  EXPECT_EQ(contact.separation, (Vec3{1, 0, 0}));
  EXPECT_EQ(done.folded[0], (Image{{1, 0, 0}}));
}

TEST(ContactAt, FindsTheNearestImageByItself) {
  World world(Box::periodic({10, 10, 10}));
  // One leaves the box along y, the other along x; along z they meet through its edge.
  world.add({{9, 0.5, 0.25}, {0, -1, 0}, 0.5, 1});
  world.add({{1, 9.5, 9.75}, {-1, 0, 0}, 0.5, 1});
  const Event event = make_collision(Time(1.5), 0, 1, {{1, -1, -1}});
  Executed given;
  contact_at(world, event, {0, 1}, given);
  EXPECT_EQ(given.contact.image, (Image{{0, 0, -1}}));
  EXPECT_EQ(given.contact.separation, (Vec3{0.5, 0.5, -0.5}));
  Executed found;
  contact_at(world, make_collision(Time(1.5), 0, 1, {}), {0, 1, true}, found);
  EXPECT_EQ(found.contact.image, given.contact.image);
  EXPECT_EQ(found.contact.separation, given.contact.separation);
  contact_at(world, make_collision(Time(1.5), 0, 1, {}), {1, 0, true}, found);
  EXPECT_EQ(found.contact.image, -given.contact.image);
  EXPECT_EQ(found.contact.separation, -given.contact.separation);
}

TEST(ContactAt, DescribesAWall) {
  World world(Box::walls({10, 10, 10}));
  world.add({{5, 5, 5}, {1, 2, 0}, 1, 4});
  Executed done;
  const Event event = next_wall_event(world, 0, Time(0));
  contact_at(world, event, participants_of(world, event), done);
  const Contact& contact = done.contact;
  EXPECT_FALSE(contact.is_collision());
  EXPECT_EQ(contact.second, face_of(1, true));
  EXPECT_EQ(contact.separation, (Vec3{0, 1, 0}));
  EXPECT_EQ(contact.normal(), (Vec3{0, 1, 0}));
  EXPECT_EQ(contact.point(), (Vec3{7, 10, 5}));
  EXPECT_EQ(contact.reach, 1);
  EXPECT_EQ(contact.impact_speed(), 2);
  EXPECT_EQ(contact.second_mass, std::numeric_limits<double>::infinity());
}

TEST(Execute, WritesBothPathsAndNothingElse) {
  World world;
  world.add({{0, 0, 0}, {1, 0, 0}, 1, 1});
  world.add({{4, 0, 0}, {0, 0, 0}, 1, 1});
  world.add({{0, 9, 0}, {1, 0, 0}, 1, 1});
  const Path bystander = world.path(2);
  CollapseGuard guard;
  const Event event = make_collision(contact_time(world, 0, 1, {}), 0, 1, {});
  Executed done;
  execute(world, guard, event, {0, 1}, done);
  EXPECT_EQ(world.path(0), (Path{{2, 0, 0}, {0, 0, 0}, Time(2)}));
  EXPECT_EQ(world.path(1), (Path{{4, 0, 0}, {1, 0, 0}, Time(2)}));
  EXPECT_EQ(world.path(2), bystander);
  EXPECT_EQ(done.contact.after.second, (Vec3{1, 0, 0}));
  EXPECT_EQ(done.contact.impulse(), (Vec3{-1, 0, 0}));
}

TEST(Execute, ChangesNothingIfTheResponseThrows) {
  World world;
  world.add({{0, 0, 0}, {1, 0, 0}, 1, 1});
  world.add({{4, 0, 0}, {0, 0, 0}, 1, 1});
  const std::vector<Path> before(world.paths().begin(), world.paths().end());
  CollapseGuard guard;
  const Event event = make_collision(contact_time(world, 0, 1, {}), 0, 1, {});
  Interactions interactions;
  interactions.set_function([](const Contact&) -> Outcome { throw std::runtime_error("no"); });
  world.set_interactions(interactions);
  Executed done;
  EXPECT_THROW(execute(world, guard, event, {0, 1}, done), std::runtime_error);
  interactions.set_function([](const Contact& contact) { return Outcome(contact, contact.before); });
  world.set_interactions(interactions);
  EXPECT_THROW(execute(world, guard, event, {0, 1}, done), Error) << "they still approach";
  EXPECT_TRUE(std::equal(before.begin(), before.end(), world.paths().begin()));
}

TEST(Settle, UndoesAnApproachThatRoundingLeft) {
  Random random(3);
  int settled = 0;
  for (int i = 0; i < 100000; ++i) {
    Contact contact;
    contact.separation = random.direction();
    contact.first_mass = 1;
    contact.second_mass = 1 + 100 * random.uniform();
    // Perfectly inelastic: both move on with one velocity, up to rounding.
    const Vec3 common{random.normal(), random.normal(), random.normal()};
    const auto rounding = [&random] { return 1e-16 * random.direction(); };
    contact.before = {common + 1e-8 * contact.separation, common};
    contact.after = {common + rounding(), common + rounding()};
    const Velocities wanted = contact.after;
    settled += approach_after(contact) < 0;
    settle(World(), contact, {});
    ASSERT_GE(approach_after(contact), 0) << "no contact may repeat itself";
    ASSERT_LT(length(contact.after.first - wanted.first), 1e-14 * (1 + length(common)));
    ASSERT_LT(length(contact.after.second - wanted.second), 1e-14 * (1 + length(common)));
  }
  EXPECT_GT(settled, 10000);
}

TEST(Settle, LeavesSeparatingBodiesAlone) {
  Contact contact;
  contact.separation = {0, 2, 0};
  contact.first_mass = contact.second_mass = 1;
  contact.before = {{0, 1, 0}, {0, -1, 0}};
  contact.after = {{3, -1, 0}, {0, -1, 4}};
  const Velocities after = contact.after;
  settle(World(), contact, {});
  EXPECT_EQ(contact.after, after);
}

TEST(Settle, RefusesAnApproachBeyondRounding) {
  Contact contact;
  contact.separation = {1, 0, 0};
  contact.first_mass = contact.second_mass = 1;
  contact.before = {{1, 0, 0}, {-1, 0, 0}};
  contact.after = {{1e-9, 0, 0}, {0, 0, 0}};
  EXPECT_THROW(settle(World(), contact, {}), Error);
  Contact wall;
  wall.kind = EventKind::wall;
  wall.second = face_of(2, false);
  wall.before.first = {0, 0, -1};
  wall.after.first = {0, 0, -1e-9};
  EXPECT_THROW(settle(World(), wall, {}), Error);
  wall.after.first = {5, 5, -1e-15};
  settle(World(), wall, {});
  EXPECT_EQ(wall.after.first, (Vec3{5, 5, 0}));
}

TEST(Execute, RefusesVelocitiesThatAreNotFiniteOrOutOfRange) {
  World world(Box::walls({10, 10, 10}));
  world.add({{2, 5, 5}, {1, 0, 0}, 1, 1});
  world.add({{6, 5, 5}, {-1, 0, 0}, 1, 1});
  const Event collision = make_collision(contact_time(world, 0, 1, {}), 0, 1, {});
  const Event wall = next_wall_event(world, 0, Time(0));
  const std::vector<Path> paths(world.paths().begin(), world.paths().end());
  CollapseGuard guard;
  const auto refused = [&](const Event& event, const Velocities& after) -> std::string {
    Executed done;
    Interactions interactions;
    interactions.set_function([&](const Contact& contact) { return Outcome(contact, after); });
    world.set_interactions(interactions);
    return support::refusal_of([&] { execute(world, guard, event, participants_of(world, event), done); });
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity, 1e300, -1.1e60}) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      Velocities after{{-1, 0, 0}, {1, 0, 0}};
      after.first[axis] = bad;
      EXPECT_NE(refused(collision, after), "");
      EXPECT_NE(refused(wall, after), "");
      std::swap(after.first, after.second);
      EXPECT_NE(refused(collision, after), "");
    }
  }
  EXPECT_EQ(refused(collision, {{-1, 0, 0}, {1, kInfinity, 0}}),
            "response to sphere 0 and sphere 1: the velocities (-1, 0, 0) and (1, inf, 0) are returned at "
            "the contact "
            "at time 1; return finite velocities of magnitude at most 1e60");
  EXPECT_EQ(std::vector<Path>(world.paths().begin(), world.paths().end()), paths) << "nothing has changed";
  EXPECT_EQ(refused(wall, {{-1, 0, 0}, {kInfinity, 0, 0}}), "") << "a wall has no velocity";
}

// Symmetric collapses end with velocities so small that they have no digits left.
TEST(Settle, UndoesApproachesBelowTheOperatingRange) {
  Contact contact;
  contact.separation = {1, 0, 0};
  contact.first_mass = contact.second_mass = 1;
  contact.before = {{3e-323, 0, 0}, {-1.5e-323, 0, 0}};
  contact.after = {{1e-323, 0, 0}, {5e-324, 0, 0}};
  ASSERT_NO_THROW(settle(World(), contact, {}));
  EXPECT_GE(approach_after(contact), 0);
}

}  // namespace
}  // namespace hardball::execute_test
