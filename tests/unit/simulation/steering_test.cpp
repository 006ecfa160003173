// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Edits, handles and queries, case by case; tests/oracle compares them with slow twins on random worlds.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/simulation/user_data.hpp"
#include "hardball/world/pair_event.hpp"
#include "support/gas.hpp"
#include "support/history.hpp"
#include "support/interacting.hpp"

namespace hardball::steering_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

World head_on_pair() {
  World world(Box::walls({20, 10, 10}));
  world.add({{5, 5, 5}, {1, 0, 0}, 1, 1});
  world.add({{15, 5, 5}, {-1, 0, 0}, 1, 1});
  return world;
}

World small_gas() {
  return support::make_gas({.count = 300, .packing_fraction = 0.1});
}

// Every other sphere turns round, the last first.
std::vector<VelocityEdit> turns(const Simulation& simulation, std::size_t count) {
  std::vector<VelocityEdit> changes;
  for (std::size_t i = count; i-- > 0;) {
    const auto id = static_cast<SphereId>(i);
    changes.push_back({id, -0.5 * simulation.velocity(id)});
  }
  return changes;
}

TEST(ChangeVelocities, GiveTheHistoryOfSingleChangesInTheOrderOfIds) {
  for (const EngineKind engine :
       {EngineKind::cells, EngineKind::neighbors, EngineKind::all_pairs, EngineKind::paper}) {
    // Few are changed one by one, many with a rebuild.
    for (const std::size_t count : {0U, 1U, 20U, 300U}) {
      Simulation at_once(small_gas(), {.engine = engine});
      at_once.run_contacts(100);
      Simulation singly = at_once;
      const std::vector<VelocityEdit> changes = turns(at_once, count);
      at_once.change_velocities(changes);
      for (std::size_t i = changes.size(); i-- > 0;) {
        singly.change_velocity(changes[i].id, changes[i].velocity);
      }
      const RunLimits limits{.contacts = 500};
      EXPECT_EQ(difference(support::run_on(at_once, limits), support::run_on(singly, limits)), "");
      EXPECT_EQ(at_once.tally().compressibility(at_once.now()), singly.tally().compressibility(singly.now()));
      at_once.validate();
    }
  }
}

TEST(ChangeVelocities, ChangeAllOrNothing) {
  const VelocityEdit good{0, {0, 1, 0}};
  for (const VelocityEdit& bad :
       {VelocityEdit{2, {}}, VelocityEdit{1, {kNan, 0, 0}}, VelocityEdit{1, {0, kInfinity, 0}},
        VelocityEdit{1, {0, 1e-70, 0}}, VelocityEdit{0, {0, 2, 0}}}) {
    Simulation simulation(head_on_pair());
    EXPECT_THROW(simulation.change_velocities(std::vector{good, bad}), Error);
    EXPECT_EQ(simulation.velocity(0), (Vec3{1, 0, 0}));
    simulation.run_contacts(1);
    EXPECT_EQ(simulation.time(), 4);
    EXPECT_EQ(simulation.counters().rebuilds, 0U);
  }
}

TEST(ChangeVelocities, WorkFromAListener) {
  Simulation between(small_gas());
  Simulation within(small_gas());
  within.on_contact([&](const Contact&) {
    if (within.counters().contacts() == 100) within.change_velocities(turns(within, 300));
    if (within.counters().contacts() == 200) within.change_velocities(turns(within, 30));
  });
  const support::History history = support::run_on(within, {.contacts = 400});
  between.run_contacts(100);
  between.change_velocities(turns(between, 300));
  between.run_contacts(100);
  between.change_velocities(turns(between, 30));
  EXPECT_EQ(difference(history, support::run_on(between, {.contacts = 200})), "");
  EXPECT_EQ(within.event_log_hash(), between.event_log_hash());
}

// The engine continues from where it is, whatever has been run or asked before.
TEST(ChangeVelocity, NeedsNoRebuild) {
  for (const EngineKind engine :
       {EngineKind::cells, EngineKind::neighbors, EngineKind::all_pairs, EngineKind::paper}) {
    Simulation simulation(small_gas(), {.engine = engine, .cell_edge = 2});
    const auto change = [&] {
      simulation.change_velocity(7, -simulation.velocity(7));
      simulation.change_velocities(turns(simulation, 10));
    };
    simulation.run_until(0.01);
    change();
    simulation.run({.steps = 3});
    change();
    simulation.run_contacts(5);
    change();
    simulation.on_contact([&](const Contact&) { change(); });
    simulation.run_contacts(5);
    simulation.on_contact(nullptr);
    static_cast<void>(simulation.contacts_within(0.01));
    change();
    simulation.run_contacts(5);
    EXPECT_EQ(simulation.counters().rebuilds, 0U);
    // Only the first time that an edit follows a look ahead.
    for (int i = 0; i < 5; ++i) {
      EXPECT_TRUE(simulation.next_contact());
      change();
      simulation.run_contacts(1);
    }
    EXPECT_LE(simulation.counters().rebuilds, 1U);
    simulation.validate();
  }
}

TEST(Handles, ReadAndChangeOneSphere) {
  Simulation simulation(head_on_pair());
  const SphereHandle sphere = simulation.sphere(1);
  EXPECT_EQ(sphere.id(), 1U);
  EXPECT_EQ(sphere.position(), (Vec3{15, 5, 5}));
  EXPECT_EQ(sphere.velocity(), (Vec3{-1, 0, 0}));
  EXPECT_EQ(sphere.radius(), 1);
  EXPECT_EQ(sphere.mass(), 1);
  sphere.change_velocity({1, 0, 0});
  EXPECT_EQ(simulation.velocity(1), (Vec3{1, 0, 0}));
  sphere.set_user_data(42);
  EXPECT_EQ(simulation.user_data(1), 42U);
  EXPECT_TRUE(sphere.exists());
  EXPECT_TRUE(simulation.contains(1));
  simulation.remove(1);
  EXPECT_FALSE(sphere.exists());
  EXPECT_FALSE(simulation.contains(1));
  EXPECT_FALSE(simulation.contains(2));
  EXPECT_THROW(sphere.position(), Error);
  EXPECT_THROW(sphere.mass(), Error);
  EXPECT_THROW(sphere.set_user_data(1), Error);
  EXPECT_THROW(simulation.sphere(1), Error);
  EXPECT_EQ(simulation.add({{10, 2, 2}, {}, 1, 1}), 2U);
  EXPECT_FALSE(sphere.exists()) << "ids are never used again";
  EXPECT_EQ(simulation.sphere(2).user_data(), 0U);
}

TEST(UserDataOfSpheres, StaysThroughCopiesEditsAndReordering) {
  // So many are put in another order for the engine.
  Simulation simulation(support::make_gas({.count = 12000, .packing_fraction = 0.01}));
  EXPECT_EQ(simulation.user_data(3), 0U);
  EXPECT_THROW(static_cast<void>(simulation.user_data(12000)), Error);
  for (SphereId k = 0; k < 4000; ++k) {
    const SphereId id = 11999 - 3 * k;
    simulation.set_user_data(id, 10 * id);
  }
  simulation.remove(5);
  simulation.remove(8);
  // Beside another, where there is room.
  const double room = simulation.clearance(1000)->distance;
  const Vec3 place = simulation.position(1000) + Vec3{simulation.sphere(1000).radius() + 0.5 * room, 0, 0};
  const SphereId added = simulation.add({.position = place, .radius = 0.1 * room});
  simulation.set_user_data(added, 7);
  Simulation copy = simulation;
  simulation.set_user_data(11, 1);
  copy.run_contacts(2000);
  const Simulation moved = std::move(copy);
  for (SphereId id = 11; id < 12000; id += 3) ASSERT_EQ(moved.user_data(id), 10 * id);
  for (SphereId id = 9; id < 12000; id += 3) ASSERT_EQ(moved.user_data(id), 0U);
  EXPECT_EQ(moved.user_data(added), 7U);
  EXPECT_EQ(simulation.user_data(11), 1U);
}

TEST(UserDataOfSpheres, IsAssignedAndForgottenWithTheSpheres) {
  Simulation simulation(head_on_pair());
  simulation.set_user_data(1, 5);
  Simulation other(small_gas());
  other.set_user_data(1, 6);
  other = simulation;
  EXPECT_EQ(other.user_data(1), 5U);
  EXPECT_EQ(other.user_data(0), 0U);

  UserData data;
  data.set(1, 5);
  data.remove(0);
  EXPECT_EQ(data.get(1), 5U);
  data.remove(1);
  EXPECT_EQ(data.get(1), 0U);
}

TEST(ContactsWithin, AreThoseOfTheRunThatFollows) {
  Simulation simulation(small_gas());
  simulation.run_contacts(100);
  int heard = 0;
  simulation.on_contact([&](const Contact&) { ++heard; });
  const std::vector<Contact> all = simulation.contacts_within(0.3);
  EXPECT_EQ(simulation.contacts_within(0.3, 5).size(), 5U);
  EXPECT_EQ(heard, 0);
  const std::vector<Contact> happened = support::record(simulation, {.until = after(simulation.now(), 0.3)});
  ASSERT_GT(all.size(), 20U);
  ASSERT_EQ(all.size(), happened.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].time, happened[i].time);
    EXPECT_EQ(all[i].first, happened[i].first);
    EXPECT_EQ(all[i].second, happened[i].second);
    EXPECT_EQ(all[i].after, happened[i].after);
  }
  for (const double bad : {-1.0, kNan, kInfinity, 1e200}) {
    EXPECT_THROW(static_cast<void>(simulation.contacts_within(bad)), Error);
  }
}

TEST(ContactsWithin, AreRefusedToResponses) {
  Simulation simulation(head_on_pair());
  simulation.respond_with([&](const Contact& contact) {
    static_cast<void>(simulation.contacts_within(1));
    return contact.before;
  });
  EXPECT_THROW(simulation.run_until(10), Error);
}

TEST(FirstContact, TellsWhatASphereWouldHitAndWhen) {
  const Simulation simulation(head_on_pair());
  EXPECT_EQ(simulation.first_contact(0, {3, 0, 0}, 10), (NextContact{2, EventKind::collision, 0, 1}));
  EXPECT_EQ(simulation.first_contact(1, {-3, 0, 0}, 10), (NextContact{2, EventKind::collision, 1, 0}));
  EXPECT_EQ(simulation.first_contact(0, {-1, 0, 0}, 10),
            (NextContact{4, EventKind::wall, 0, face_of(0, false)}));
  EXPECT_EQ(simulation.first_contact(0, {0, 2, 0}, kInfinity),
            (NextContact{2, EventKind::wall, 0, face_of(1, true)}));
  EXPECT_EQ(simulation.first_contact(0, {-1, 0, 0}, 4), simulation.first_contact(0, {-1, 0, 0}, 10));
  EXPECT_EQ(simulation.first_contact(0, {-1, 0, 0}, 3.9), std::nullopt);
  EXPECT_EQ(simulation.first_contact(0, {}, 7.9), std::nullopt);
  EXPECT_EQ(simulation.first_contact(0, {}, 8), (NextContact{8, EventKind::collision, 0, 1}));
  EXPECT_EQ(simulation.first_contact({.position = {10, 5, 5}, .velocity = {1, 0, 0}}, 10),
            (NextContact{1.5, EventKind::collision, kNoSphere, 1}));
  for (const double bad : {-1.0, kNan, -kInfinity}) {
    EXPECT_THROW(static_cast<void>(simulation.first_contact(0, {}, bad)), Error);
  }
  EXPECT_THROW(static_cast<void>(simulation.first_contact(2, {}, 1)), Error);
  EXPECT_THROW(static_cast<void>(simulation.first_contact(0, {kNan, 0, 0}, 1)), Error);
  EXPECT_THROW(static_cast<void>(simulation.first_contact({.position = {0.5, 5, 5}}, 1)), Error);
}

TEST(FirstContact, IsNotWithWhatASphereIsPassingThrough) {
  World world;
  world.set_interactions(support::passing({{0, 1}}));
  world.add({.position = {0, 0, 0}, .velocity = {1, 0, 0}});
  world.add({.position = {4, 0, 0}, .species = 1});
  world.add({.position = {10, 0, 0}});
  Simulation simulation(world);
  EXPECT_EQ(simulation.first_contact(0, {1, 0, 0}, 10), (NextContact{2, EventKind::collision, 0, 1}));
  simulation.run_until(2);
  EXPECT_EQ(simulation.first_contact(0, {1, 0, 0}, 10), (NextContact{8, EventKind::collision, 0, 2}));
  simulation.run_until(3);
  EXPECT_EQ(simulation.first_contact(0, {1, 0, 0}, 10), (NextContact{8, EventKind::collision, 0, 2}));
  EXPECT_EQ(simulation.first_contact({.position = {4, 0, 0}, .velocity = {1, 0, 0}}, 10)->second, 2U);
}

TEST(FirstContact, GoesOnThroughManyPeriodicBoxes) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{5, 5, 5}, {0, 0, 0}, 0.5, 1});
  world.add({{5, 8, 5}, {0, 0, 0}, 0.5, 1});
  const Simulation simulation(world);
  // 1000 boxes up, 3 to the side.
  const Vec3 velocity{10, 0.003, 0};
  const auto contact = simulation.first_contact(0, velocity, 2000);
  ASSERT_TRUE(contact);
  EXPECT_EQ(contact->second, 1U);
  World changed = world;
  changed.change_velocity(0, Time(0), velocity);
  Time first = kNever;
  for (std::int32_t boxes = -1100; boxes < 0; ++boxes) {
    first = earlier(first, contact_time(changed, 1, 0, {{boxes, 0, 0}}));
  }
  // Seen from the first sphere the image lies ahead.
  for (std::int32_t boxes = 0; boxes < 1100; ++boxes) {
    first = earlier(first, contact_time(changed, 0, 1, {{boxes, 0, 0}}));
  }
  EXPECT_EQ(contact->time, first.value());
  EXPECT_EQ(simulation.first_contact(0, {1, 0, 0}, 1e4), std::nullopt);
  EXPECT_THROW(static_cast<void>(simulation.first_contact(0, {1, 0, 0}, kInfinity)), Error);
}

TEST(Ray, HitsSpheresAndWalls) {
  const Simulation simulation(head_on_pair());
  const auto sphere = simulation.ray({10, 5, 5}, {2, 0, 0}, 100);
  ASSERT_TRUE(sphere);
  EXPECT_EQ(sphere->kind, EventKind::collision);
  EXPECT_EQ(sphere->body, 1U);
  EXPECT_EQ(sphere->distance, 4);
  EXPECT_EQ(sphere->point, (Vec3{14, 5, 5}));
  EXPECT_EQ(sphere->normal, (Vec3{-1, 0, 0}));
  const auto wall = simulation.ray({10, 5, 5}, {0, 0, -1}, kInfinity);
  ASSERT_TRUE(wall);
  EXPECT_EQ(wall->kind, EventKind::wall);
  EXPECT_EQ(wall->body, face_of(2, false));
  EXPECT_EQ(wall->point, (Vec3{10, 5, 0}));
  EXPECT_EQ(wall->normal, (Vec3{0, 0, 1}));
  EXPECT_FALSE(simulation.ray({10, 5, 5}, {1, 0, 0}, 3.9));
  EXPECT_TRUE(simulation.ray({10, 5, 5}, {1, 0, 0}, 4));
  // Out of a sphere, from off its center.
  EXPECT_EQ(simulation.ray({4.5, 5, 5}, {1, 0, 0}, 100)->body, 1U);
  EXPECT_THROW(static_cast<void>(simulation.ray({10, 5, 5}, {0, 0, 0}, 1)), Error);
  EXPECT_THROW(static_cast<void>(simulation.ray({10, 5, 5}, {kNan, 0, 0}, 1)), Error);
  EXPECT_THROW(static_cast<void>(simulation.ray({10, kInfinity, 5}, {1, 0, 0}, 1)), Error);
  EXPECT_THROW(static_cast<void>(simulation.ray({10, 5, 5}, {1, 0, 0}, -1)), Error);
  EXPECT_THROW(static_cast<void>(simulation.ray({10, 5, 5}, {1, 0, 0}, kNan)), Error);
}

TEST(Ray, GoesOnThroughPeriodicImages) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{8, 5, 5}, {3, 0, 0}, 1, 1});
  const Simulation simulation(world);
  const auto ahead = simulation.ray({9.5, 5, 5}, {1, 0, 0}, 100);
  ASSERT_TRUE(ahead);
  EXPECT_EQ(ahead->distance, 7.5);
  EXPECT_EQ(ahead->point, (Vec3{7, 5, 5}));
  EXPECT_FALSE(simulation.ray({9.5, 2, 5}, {1, 0, 0}, 1000));
  EXPECT_THROW(static_cast<void>(simulation.ray({9.5, 5, 5}, {1, 0, 0}, kInfinity)), Error);
}

TEST(Clearance, IsTheDistanceToTheNearestSurface) {
  const Simulation simulation(head_on_pair());
  const auto nearest = simulation.clearance({8, 5, 5});
  ASSERT_TRUE(nearest);
  EXPECT_EQ(nearest->distance, 2);
  EXPECT_EQ(nearest->kind, EventKind::collision);
  EXPECT_EQ(nearest->body, 0U);
  EXPECT_EQ(simulation.clearance({10, 5, 9.5})->body, face_of(2, true));
  EXPECT_EQ(simulation.clearance({5, 5, 5})->distance, -1);
  EXPECT_EQ(simulation.clearance(0)->distance, 4);
  EXPECT_EQ(simulation.clearance(0)->kind, EventKind::wall);
  EXPECT_EQ(simulation.clearance(0)->body, face_of(0, false)) << "of five faces the first";
  EXPECT_THROW(static_cast<void>(simulation.clearance(2)), Error);
  EXPECT_THROW(static_cast<void>(simulation.clearance({kNan, 0, 0})), Error);
  World alone(Box::periodic({10, 10, 10}));
  alone.add({{5, 5, 5}, {}, 1, 1});
  EXPECT_FALSE(Simulation(alone).clearance(0));
  EXPECT_FALSE(Simulation(World()).clearance(Vec3{}));
}

// The world stands still for a ray, moving walls included.
TEST(Ray, SeesMovingWallsWhereTheyAre) {
  const Surface rising(Plane({0, 0, 1}), {0, 0, 0}, {0, 0, 1});
  const Surface shaken(OscillatingPlane({0, 0, -1}, 1, 0.25), {0, 0, 20});
  World world(Box::open(), {0, 0, -1}, {rising, shaken});
  world.add({{50, 0, 10}, {0, 0, 4}, 1, 1});
  Simulation simulation(world);
  simulation.run_until(1);
  EXPECT_EQ(simulation.time(), 1);
  const auto down = simulation.ray({0, 0, 10}, {0, 0, -1}, 100);
  ASSERT_TRUE(down);
  EXPECT_EQ(down->body, kFaces);
  EXPECT_DOUBLE_EQ(down->distance, 9);
  EXPECT_EQ(down->normal, (Vec3{0, 0, 1}));
  const auto up = simulation.ray({0, 0, 10}, {0, 0, 1}, 100);
  ASSERT_TRUE(up);
  EXPECT_EQ(up->body, kFaces + 1);
  EXPECT_NEAR(up->distance, 10 - 1, 1e-12) << "a quarter of a period later it is one unit toward its normal";
  EXPECT_NEAR(simulation.clearance({0, 0, 12})->distance, 7, 1e-12);
}

}  // namespace
}  // namespace hardball::steering_test
