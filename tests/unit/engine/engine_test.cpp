// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The event loops, without the facade.
#include "hardball/engine/engine.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "hardball/broadphase/all_pairs.hpp"
#include "hardball/broadphase/cell_grid.hpp"
#include "hardball/broadphase/neighbor_list.hpp"
#include "hardball/events/calendar_queue.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/paper/paper_engine.hpp"
#include "hardball/placement/placement.hpp"
#include "support/ordered_queue.hpp"
#include "support/run_engine.hpp"

namespace hardball::engine_test {
namespace {

// Six spheres of diameter one in a ring of 11, one of them moving: collision k happens exactly at time k.
World newtons_cradle() {
  World world(Box::periodic({11, 11, 11}));
  for (const double x : {0.0, 1.0, 3.0, 5.0, 7.0, 9.0})
    world.add({{x, 5, 5}, {x == 1 ? 1.0 : 0.0, 0, 0}, 0.5, 1});
  return world;
}

using support::run;

template <class Made>
struct EveryEngine : testing::Test {};

struct CellsWithCalendar {
  static auto make(World world) {
    return Engine<CalendarQueue>(std::move(world), PhaseSettings(PhaseKind::cells, 1.3), Time(0));
  }
};
struct CellsWithTree {
  static auto make(World world) {
    return Engine<support::OrderedQueue>(std::move(world), PhaseSettings(PhaseKind::cells, 0.6), Time(0));
  }
};
struct AllPairsWithCalendar {
  static auto make(World world) {
    return Engine<CalendarQueue>(std::move(world), PhaseSettings(PhaseKind::all_pairs, 1), Time(0));
  }
};
struct NeighborsWithCalendar {
  static auto make(World world) {
    return Engine<CalendarQueue>(std::move(world), PhaseSettings(PhaseKind::neighbors, 0.3), Time(0));
  }
};
struct NeighborsWithTree {
  static auto make(World world) {
    return Engine<support::OrderedQueue>(std::move(world), PhaseSettings(PhaseKind::neighbors, 0.1), Time(0));
  }
};
struct Paper {
  static auto make(World world) { return PaperEngine(std::move(world), 1.5, Time(0)); }
};
using Makers = testing::Types<CellsWithCalendar, CellsWithTree, AllPairsWithCalendar, NeighborsWithCalendar,
                              NeighborsWithTree, Paper>;
TYPED_TEST_SUITE(EveryEngine, Makers);

constexpr auto kIgnore = [](const Contact&) {};

void change_velocity(auto& engine, Slot slot, const Time& moment, const Vec3& velocity) {
  const NewVelocity change{slot, engine.world().velocity(slot, moment), velocity};
  engine.change_velocities(moment, {&change, 1});
}

TYPED_TEST(EveryEngine, RunsNewtonsCradleWithoutRounding) {
  auto engine = TypeParam::make(newtons_cradle());
  double expected = 0;
  const RunStatus status = run(engine, {.until = Time(1000)}, [&](const Contact& contact) {
    expected += 1;
    ASSERT_EQ(contact.time, Time(expected));
    ASSERT_EQ(contact.overlap(), 0);
  });
  EXPECT_EQ(status, RunStatus::time_reached);
  EXPECT_EQ(expected, 1000) << "events exactly at the end happen";
  EXPECT_EQ(engine.counters().collision, 1000U);
  EXPECT_EQ(engine.counters().wall, 0U);
  engine.validate();
}

TYPED_TEST(EveryEngine, StopsAtTheFirstLimitReached) {
  auto engine = TypeParam::make(newtons_cradle());
  EXPECT_EQ(run(engine, {.until = Time(50), .contacts = 0}, kIgnore), RunStatus::contacts_reached);
  EXPECT_EQ(engine.counters().contacts(), 0U);
  EXPECT_EQ(run(engine, {.until = Time(50), .contacts = 3}, kIgnore), RunStatus::contacts_reached);
  EXPECT_EQ(engine.now(), Time(3));
  EXPECT_EQ(run(engine, {.until = Time(3.5), .contacts = 3}, kIgnore), RunStatus::time_reached);
  EXPECT_EQ(engine.counters().contacts(), 3U);
  EXPECT_EQ(run(engine, {.until = Time(50), .steps = 0}, kIgnore), RunStatus::steps_reached);
  EXPECT_EQ(engine.counters().contacts(), 3U);
  EXPECT_EQ(run(engine, {.until = Time(50), .steps = 1}, kIgnore), RunStatus::steps_reached);
}

TYPED_TEST(EveryEngine, ReturnsTheNextContactWithoutExecutingIt) {
  auto engine = TypeParam::make(newtons_cradle());
  for (int i = 0; i < 3; ++i) {
    const std::optional<Event> next = engine.next_contact(Time(10));
    ASSERT_TRUE(next);
    EXPECT_EQ(*next, (Event{Time(1), EventKind::collision, 1, 2, {}}));
  }
  EXPECT_EQ(engine.next_contact(Time(0.5)), std::nullopt);
  EXPECT_EQ(engine.counters().contacts(), 0U);
}

TYPED_TEST(EveryEngine, NamesSpheresByTheirIdsWhereverTheyAreStored) {
  // Ids 3, 4, 5, ... correspond to 0, 1, 2, ..., and slots are in reverse order.
  World world(newtons_cradle().box());
  for (int gone = 0; gone < 3; ++gone) world.add({{5, 1, 1}, {}, 0.5, 1});
  const World cradle = newtons_cradle();
  for (Slot slot = 0; slot < cradle.size(); ++slot) {
    world.add({cradle.path(slot).position, cradle.path(slot).velocity, cradle.base_radius(slot),
               cradle.mass(slot)});
  }
  for (SphereId gone = 0; gone < 3; ++gone) world.remove(gone);
  world.reorder(std::array<Slot, 6>{5, 4, 3, 2, 1, 0});
  auto engine = TypeParam::make(world);
  auto plain = TypeParam::make(cradle);
  EXPECT_EQ(engine.next_contact(Time(10)), (Event{Time(1), EventKind::collision, 4, 5, {}}));
  std::vector<Contact> expected;
  run(plain, {.until = Time(100)}, [&](const Contact& contact) { expected.push_back(contact); });
  std::size_t count = 0;
  run(engine, {.until = Time(100)}, [&](const Contact& contact) {
    ASSERT_LT(count, expected.size());
    EXPECT_EQ(contact.time, expected[count].time);
    EXPECT_EQ(contact.first, expected[count].first + 3);
    EXPECT_EQ(contact.second, expected[count].second + 3);
    EXPECT_EQ(contact.position, expected[count].position);
    EXPECT_EQ(contact.image, expected[count].image);
    ++count;
  });
  EXPECT_EQ(count, 100U);
  engine.validate();
}

TYPED_TEST(EveryEngine, IsAValueThatCanBeCopied) {
  auto engine = TypeParam::make(newtons_cradle());
  run(engine, {.until = Time(4)}, kIgnore);
  auto copy = engine;
  std::vector<Time> times;
  std::vector<Time> copied_times;
  run(engine, {.until = Time(30)}, [&](const Contact& contact) { times.push_back(contact.time); });
  run(copy, {.until = Time(30)}, [&](const Contact& contact) { copied_times.push_back(contact.time); });
  EXPECT_EQ(times.size(), 26U);
  EXPECT_EQ(times, copied_times);
}

TYPED_TEST(EveryEngine, GoesOnAfterAnObserverThrew) {
  auto engine = TypeParam::make(newtons_cradle());
  const auto throws = [](const Contact&) { throw std::runtime_error("enough"); };
  EXPECT_THROW(run(engine, {}, throws), std::runtime_error);
  EXPECT_EQ(engine.counters().contacts(), 1U) << "the contact has happened";
  run(engine, {.contacts = 1}, kIgnore);
  EXPECT_EQ(engine.now(), Time(2));
  engine.validate();
}

TYPED_TEST(EveryEngine, TakesANewVelocityInBetween) {
  auto engine = TypeParam::make(newtons_cradle());
  run(engine, {.until = Time(1.5)}, kIgnore);
  // Sphere 2 has moved from 3 to 3.5; it turns back toward sphere 1, at rest at 2.
  change_velocity(engine, 2, Time(1.5), {-0.5, 0, 0});
  std::vector<Time> times;
  run(engine, {.until = Time(3)}, [&](const Contact& contact) { times.push_back(contact.time); });
  EXPECT_EQ(times, (std::vector<Time>{Time(2.5)}));
  engine.validate();
}

TYPED_TEST(EveryEngine, NeedsMemoryInProportionToTheSpheres) {
  const auto bytes = [](int spheres) {
    World world(Box::periodic({1e4, 1e4, 1e4}));
    for (int i = 0; i < spheres; ++i) world.add({{3.0 * (i % 100), 3.0 * (i / 100), 0}, {0, 0, 1}, 0.5, 1});
    return TypeParam::make(world).memory_bytes();
  };
  EXPECT_LT(bytes(4000), 6 * bytes(1000)) << "some capacities are powers of two";
  EXPECT_LT(bytes(4000), 4000U * 3000);
}

// Dense enough for spheres to be caged at times; mixed radii make long lists.
World mixed_gas(const std::array<Boundary, kAxes>& boundary, std::uint64_t seed, double smallest_radius) {
  constexpr std::size_t kSpheres = 300;
  Random random(seed);
  std::vector<double> radii(kSpheres);
  double volume = 0;
  for (double& radius : radii) {
    radius = smallest_radius + (0.5 - smallest_radius) * random.uniform();
    volume += 4 * std::numbers::pi / 3 * radius * radius * radius;
  }
  const double edge = std::cbrt(volume / 0.25);
  World world(Box(boundary, {edge, edge, edge}));
  const std::vector<Vec3> centers =
      place_randomly(world.box(), {{}, {edge, edge, edge}}, radii, random, "gas");
  for (std::size_t i = 0; i < kSpheres; ++i) {
    const Vec3 velocity{random.normal(), random.normal(), random.normal()};
    world.add({centers[i], velocity, radii[i], radii[i] * radii[i] * radii[i]});
  }
  return world;
}

template <class Checked>
void run_and_validate(Checked engine) {
  ASSERT_NO_THROW(engine.validate());
  for (int stop = 0; stop < 30; ++stop) {
    // In open space contacts end, and crossings do not.
    run(engine, {.contacts = 50, .steps = 3000}, kIgnore);
    ASSERT_NO_THROW(engine.validate()) << "after " << engine.counters().contacts() << " contacts";
    // A change from outside, too.
    change_velocity(engine, static_cast<Slot>(7 * stop), engine.now(), {1, 2, -3});
    ASSERT_NO_THROW(engine.validate());
  }
  EXPECT_GT(engine.counters().enter, 0U);
}

TEST(Engine, KeepsItsStructuresSoundInEveryKindOfBox) {
  constexpr Boundary kPeriodic = Boundary::periodic;
  constexpr Boundary kWall = Boundary::wall;
  constexpr Boundary kOpen = Boundary::open;
  using Kinds = std::array<Boundary, kAxes>;
  for (const Kinds& boundary : {Kinds{kPeriodic, kPeriodic, kPeriodic}, Kinds{kWall, kWall, kWall},
                                Kinds{kOpen, kOpen, kOpen}, Kinds{kOpen, kPeriodic, kWall}}) {
    for (const double smallest_radius : {0.5, 0.3, 0.1}) {
      SCOPED_TRACE(testing::Message() << static_cast<int>(boundary[0]) << static_cast<int>(boundary[1])
                                      << static_cast<int>(boundary[2]) << ", " << smallest_radius);
      const World world = mixed_gas(boundary, 5, smallest_radius);
      for (const double skin : {0.02, 0.2, 1.0}) {
        run_and_validate(Engine<CalendarQueue>(world, PhaseSettings(PhaseKind::neighbors, skin), Time(0)));
      }
      run_and_validate(Engine<CalendarQueue>(world, PhaseSettings(PhaseKind::cells, 1.3), Time(0)));
      if (HasFailure()) return;
    }
  }
}

// Prefetching reads spheres whose queue entries are dead: stopped ones have no next crossing, and there are
// no cells behind a wall.
void stop_spheres_in_a_large_gas(const PhaseSettings& phase) {
  Random random(6);
  constexpr int kPerAxis = 23;
  World world(Box::walls({3.0 * kPerAxis, 3.0 * kPerAxis, 3.0 * kPerAxis}));
  for (int i = 0; i < kPerAxis * kPerAxis * kPerAxis; ++i) {
    const Vec3 place{1.5 + 3.0 * (i % kPerAxis), 1.5 + 3.0 * (i / kPerAxis % kPerAxis),
                     1.5 + 3.0 * (i / kPerAxis / kPerAxis)};
    world.add({place, random.direction(), 0.25, 1});
  }
  Engine<CalendarQueue> engine(std::move(world), phase, Time(0));
  run(engine, {.until = Time(0.01)}, kIgnore);
  for (Slot slot = 0; slot < engine.world().size(); slot += 2) {
    change_velocity(engine, slot, Time(0.01), {0, 0, 0});
  }
  EXPECT_NO_THROW(run(engine, {.until = Time(3)}, kIgnore));
  EXPECT_GT(engine.counters().contacts(), 100U);
}

TEST(Engine, PrefetchesForSpheresThatHaveBeenStopped) {
  stop_spheres_in_a_large_gas({PhaseKind::cells, 3});
  stop_spheres_in_a_large_gas({PhaseKind::neighbors, 0.5});
}

}  // namespace
}  // namespace hardball::engine_test
