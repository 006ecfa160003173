// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/bounds/compact_paths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"

namespace hardball::compact_paths_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

World one_sphere(const Box& box, const Vec3& position, const Vec3& velocity) {
  World world(box);
  world.add({position, velocity, 0.5, 1});
  return world;
}

bool says_nothing(const CompactPaths& copies, Slot slot) {
  return std::isnan(copies.paths()[slot].velocity[0]) && std::isnan(copies.paths()[slot].velocity[1]) &&
         std::isnan(copies.paths()[slot].velocity[2]);
}

// Differences modulo 2^32 lead to the nearest image, if a box is one turn of the ring of integers or many.
TEST(CompactPaths, PlacesDifferByTheWayToTheNearestImage) {
  Random random(1);
  for (std::uint64_t i = 0; i < support::cases(3000); ++i) {
    const double farthest = std::exp2(6 * random.uniform() - 3);
    const double edge = farthest * std::exp2(1.2 + 20 * random.uniform());
    const Box box({Boundary::periodic, Boundary::wall, Boundary::open}, {edge, edge, 0});
    World world(box);
    const Vec3 position{edge * random.uniform(), edge * (0.3 + 0.4 * random.uniform()),
                        edge * random.normal()};
    Vec3 apart = 0.999 * farthest * random.uniform() * random.direction();
    apart.y = std::clamp(apart.y, -0.2 * edge, 0.2 * edge);
    // Small enough for any box.
    const double radius = 0.01 * farthest;
    world.add({position, {1, 0, 0}, radius, 1});
    world.add({position + apart, {1, 0, 0}, radius, 1});
    CompactPaths copies;
    copies.reset(world, farthest, Time(0));
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      // Two roundings to a grid of at most 2^-26 of the distance, and of the coordinates themselves.
      const double tolerance = 0x1p-26 * farthest + 0x1p-51 * edge;
      ASSERT_NEAR(copies.apart(copies.paths()[0].position, 1, axis), apart[axis], tolerance) << axis;
      ASSERT_NEAR(copies.apart(copies.paths()[1].position, 0, axis), -apart[axis], tolerance) << axis;
    }
  }
}

TEST(CompactPaths, AreInTheSamePlaceAfterAWholeBox) {
  const World world = one_sphere(Box::periodic({8, 16, 32}), {1, 2, 3}, {8, -16, 64});
  CompactPaths copies;
  copies.reset(world, 2, Time(0));
  const auto position = copies.paths()[0].position;
  // The last so far away that nothing else is known of the sphere.
  for (const double time : {1.0, 2.0, 1000.0, 1e5, 1e6, 1e8}) {
    copies.copy(world, 0, Time(time));
    EXPECT_EQ(copies.paths()[0].position, position);
    copies.copy(world, 0, Time(time + 0.25));
    // A quarter of the box along x and y, and half of it along z, on rings of 2^32 steps.
    constexpr std::uint32_t kQuarter = 1U << 30;
    const auto moved = [&](std::size_t axis) {
      return static_cast<std::uint32_t>(copies.paths()[0].position[axis]) -
             static_cast<std::uint32_t>(position[axis]);
    };
    EXPECT_EQ(moved(0), kQuarter);
    EXPECT_EQ(moved(1), 0U - kQuarter);
    EXPECT_EQ(moved(2), 2 * kQuarter);
  }
}

// The elapsed time between two copies [T].
double elapsed(const CompactPaths& copies, std::int32_t before, std::int32_t after) {
  const auto ticks =
      static_cast<std::int32_t>(static_cast<std::uint32_t>(after) - static_cast<std::uint32_t>(before));
  return static_cast<double>(ticks) * static_cast<double>(copies.scale().tick) * copies.time_unit();
}

TEST(CompactPaths, AgesAreElapsedTimesUntilTheyExpire) {
  Random random(2);
  for (std::uint64_t i = 0; i < support::cases(3000); ++i) {
    const double speed = std::exp2(40 * random.uniform() - 20);
    const World world = one_sphere(Box(), {1, 2, 3}, speed * random.direction());
    const double farthest = std::exp2(10 * random.uniform() - 5);
    const Time start(i % 3 == 0 ? 1e10 * random.uniform() / speed : 0);
    CompactPaths copies;
    copies.reset(world, farthest, start);
    const double tick = static_cast<double>(copies.scale().tick) * copies.time_unit();
    // Fine enough for the distance that the sphere moves in one tick.
    ASSERT_LE(tick * speed, 0x1p-23 * farthest);
    Time now = start;
    for (int step = 0; step < 5; ++step) {
      const std::int32_t before = copies.paths()[0].tick;
      const double expiry = rounded_down(now) + copies.longest_age(0);
      ASSERT_GT(expiry, now.high);
      const double wait = step % 2 == 0 ? expiry - now.high : (expiry - now.high) * random.uniform();
      now = after(now, wait);
      copies.copy(world, 0, now);
      ASSERT_NEAR(elapsed(copies, before, copies.paths()[0].tick), wait, tick + 0x1p-51 * now.high);
    }
  }
}

TEST(CompactPaths, HoldVelocitiesAndRadiiInTheirUnits) {
  Random random(3);
  for (const double length : {1e-59, 1e-9, 1.0, 1e9, 1e59}) {
    for (const double speed : {1e-58, 1e-9, 1.0, 1e9, 1e59}) {
      World world;
      const Vec3 velocity = speed * random.direction();
      world.add({{length, 2 * length, 3 * length}, velocity, 0.51 * length, 1});
      for (const bool mixed : {false, true}) {
        if (mixed) world.add({{5 * length, 2 * length, 3 * length}, velocity, 0.11 * length, 1});
        CompactPaths copies;
        copies.reset(world, 1.5 * length, Time(0));
        EXPECT_EQ(copies.radii() != nullptr, mixed);
        for (Slot slot = 0; slot < world.size(); ++slot) {
          ASSERT_FALSE(says_nothing(copies, slot));
          for (std::size_t axis = 0; axis < kAxes; ++axis) {
            const double copied = static_cast<double>(copies.paths()[slot].velocity[axis]) *
                                  (copies.length_unit() / copies.time_unit());
            EXPECT_NEAR(copied / speed, velocity[axis] / speed, 0x1p-24);
          }
          const double radius = static_cast<double>(copies.radius(slot)) * copies.length_unit();
          EXPECT_GE(radius, world.base_radius(slot)) << "rounded up";
          EXPECT_LE(radius, world.base_radius(slot) * (1 + 0x1p-23));
        }
        // Single precision holds the fourth powers of what is about one.
        EXPECT_GE(1.5 * length / copies.length_unit(), 0.5);
        EXPECT_LE(1.5 * length / copies.length_unit(), 1);
      }
    }
  }
}

// Ten spheres of speed one.
World ten_spheres() {
  World world;
  for (int i = 0; i < 10; ++i) world.add({{2.0 * i, 0, 0}, {0, 0, 1}, 0.5, 1});
  return world;
}

TEST(CompactPaths, SayNothingOfSpheresThatAreTooFast) {
  World world = ten_spheres();
  CompactPaths copies;
  copies.reset(world, 3, Time(0));
  for (const double speed : {0.0, 1.0, 4.0, 7.99}) {
    world.change_velocity(3, Time(1), {0, 0, -speed});
    copies.copy(world, 3, Time(1));
    EXPECT_FALSE(says_nothing(copies, 3)) << speed;
  }
  for (const double speed : {8.01, 1e9, 1e60}) {
    world.change_velocity(3, Time(1), {0, 0, -speed});
    copies.copy(world, 3, Time(1));
    EXPECT_TRUE(says_nothing(copies, 3)) << speed;
  }
  world.change_velocity(3, Time(1), {0, 1, 0});
  copies.copy(world, 3, Time(1));
  EXPECT_FALSE(says_nothing(copies, 3));
}

TEST(CompactPaths, SayNothingOfSpheresThatAreTooFarAway) {
  constexpr double kFarthest = 3;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      for (const double part : {0.99, 1.01, 1e30}) {
        Vec3 position;
        position[axis] = sign * part * 0x1p24 * kFarthest;
        const World world = one_sphere(Box(), position, {1, 0, 0});
        CompactPaths copies;
        copies.reset(world, kFarthest, Time(0));
        EXPECT_EQ(says_nothing(copies, 0), part > 1) << part;
      }
    }
  }
}

TEST(CompactPaths, SayNothingVeryLongAfterUnitsWereChosen) {
  World world = one_sphere(Box(), {1, 2, 3}, {1, 0, 0});
  const auto at_rest = static_cast<Slot>(world.add({{5, 2, 3}, {}, 0.5, 1}));
  CompactPaths copies;
  copies.reset(world, 3, Time(0));
  const double tick = static_cast<double>(copies.scale().tick) * copies.time_unit();
  copies.copy(world, at_rest, Time(0x1p49 * tick));
  EXPECT_FALSE(says_nothing(copies, at_rest));
  copies.copy(world, at_rest, Time(0x1p51 * tick));
  EXPECT_TRUE(says_nothing(copies, at_rest));
  copies.reset(world, 3, Time(0x1p51 * tick));
  EXPECT_FALSE(says_nothing(copies, at_rest));
}

// What docs/bounds.md derives from the greatest speed of a bounded sphere, eight times the root mean square,
// and from the growth of the sum of two radii.
TEST(CompactPaths, AllowForTheErrorsOfTheFastestGaps) {
  constexpr double kFarthest = 3;
  for (const double growth : {-0.5, 0.0, 0.5, 50.0}) {
    World world = ten_spheres();
    if (growth != 0) world.set_growth({Time(0), Time(1), 1, growth});
    const double largest = world.motion().growth().largest_scale();
    CompactPaths copies;
    copies.reset(world, kFarthest, Time(0));
    const BoundScale& scale = copies.scale();
    const double l = kFarthest / copies.length_unit();
    const double speed_unit = copies.length_unit() / copies.time_unit();
    const double w = (2 * 8 + kFarthest * std::max(growth, 0.0) / largest) / speed_unit;
    const auto expect_rounded_up = [](float number, double exact) {
      EXPECT_GE(number, exact * (1 - 0x1p-50));
      EXPECT_LE(number, exact * (1 + 0x1p-22));
    };
    expect_rounded_up(scale.speed_error, 0x1p-23 * w);
    expect_rounded_up(scale.approach_allowance, 0x1p-19 * l * w);
    expect_rounded_up(scale.speed_allowance, 0x1p-44 * w * w);
    expect_rounded_up(scale.least_discriminant, 0x1p-60 * l * l * w * w);
  }
}

TEST(CompactPaths, AreGoodUntilAFallingSphereHasMovedByTheDistance) {
  constexpr double kFarthest = 3;
  for (const double speed : {0.0, 1.0, 30.0}) {
    World world(Box(), {0, 0, -10});
    world.add({{}, {0, 0, -speed}, 0.5, 1});
    CompactPaths copies;
    copies.reset(world, kFarthest, Time(0));
    ASSERT_FALSE(says_nothing(copies, 0));
    const double age = copies.longest_age(0);
    const double fallen = speed * age + 10 * age * age / 2;
    EXPECT_LE(fallen, kFarthest);
    EXPECT_GT(fallen, 0.99 * kFarthest);
  }
}

void renew_if_outdated(CompactPaths& copies, const World& world, const Time& now) {
  if (copies.are_outdated()) copies.renew(world, now);
}

// Copies all spheres again and again, as an engine does.
void copy_often(CompactPaths& copies, const World& world, int times) {
  for (int i = 0; i < times; ++i) {
    for (Slot slot = 0; slot < world.size(); ++slot) copies.copy(world, slot, Time(1));
    renew_if_outdated(copies, world, Time(1));
  }
}

TEST(CompactPaths, AreRenewedWhenSpeedsHaveChanged) {
  World world = ten_spheres();
  CompactPaths copies;
  copies.reset(world, 3, Time(0));
  const double first_unit = copies.time_unit();
  const auto positions = copies.paths()[3].position;
  renew_if_outdated(copies, world, Time(0));
  EXPECT_EQ(copies.time_unit(), first_unit);

  // Soon, if many are too fast.
  for (Slot slot = 0; slot < 10; ++slot) world.change_velocity(slot, Time(0), {0, 1e3, 0});
  copy_often(copies, world, 20);
  for (Slot slot = 0; slot < 10; ++slot) EXPECT_FALSE(says_nothing(copies, slot));
  EXPECT_NEAR(std::log2(first_unit / copies.time_unit()), std::log2(1e3), 1);
  // The steps of the grid stay the same.
  for (Slot slot = 0; slot < 10; ++slot) world.change_velocity(slot, Time(1), {0, 0, 1});
  copies.copy(world, 3, Time(0));
  EXPECT_EQ(copies.paths()[3].position[0], positions[0]);

  // By and by, if all are slower than the copies allow for.
  copy_often(copies, world, 4000);
  EXPECT_NEAR(std::log2(copies.time_unit() / first_unit), 0, 1);

  // And if nothing moves any more, and then moves again.
  for (Slot slot = 0; slot < 10; ++slot) world.change_velocity(slot, Time(1), {});
  copy_often(copies, world, 4000);
  for (Slot slot = 0; slot < 10; ++slot) world.change_velocity(slot, Time(1), {1e-20, 0, 0});
  copy_often(copies, world, 4000);
  for (Slot slot = 0; slot < 10; ++slot) EXPECT_FALSE(says_nothing(copies, slot));
  EXPECT_NEAR(std::log2(copies.time_unit() / first_unit), std::log2(1e20), 1);
}

TEST(CompactPaths, CountTheChangesOfEachPath) {
  const World world = ten_spheres();
  CompactPaths copies;
  copies.reset(world, 3, Time(0));
  for (Slot slot = 0; slot < 10; ++slot) EXPECT_EQ(copies.revision(slot), 0U);
  constexpr std::uint32_t kRevision = CompactPaths::kRevision;
  EXPECT_EQ(copies.note_change(4), kRevision);
  EXPECT_EQ(copies.note_change(4), 2 * kRevision);
  EXPECT_EQ(copies.note_change(5), kRevision);
  // Copies of a path do not change it, nor do new units.
  copies.copy(world, 4, Time(1));
  copies.reset(world, 3, Time(2));
  EXPECT_EQ(copies.revision(3), 0U);
  EXPECT_EQ(copies.revision(4), 2 * kRevision);
  EXPECT_EQ(copies.revision(5), kRevision);
}

}  // namespace
}  // namespace hardball::compact_paths_test
