// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "hardball/errors/error.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/pair_event.hpp"
#include "hardball/world/sphere_edit.hpp"
#include "hardball/world/totals.hpp"
#include "hardball/world/walls.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"

namespace hardball::world_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Box mixed_box() {
  return Box({Boundary::wall, Boundary::periodic, Boundary::open}, {10, 8, 0});
}

TEST(Box, RefusesSizesThatAreNotPositiveAndFinite) {
  for (const double size : {0.0, -1.0, kInfinity, kNan, 1e61, 1e-61}) {
    EXPECT_THROW(Box::walls({10, size, 10}), Error);
    EXPECT_THROW(Box::periodic({10, 10, size}), Error);
  }
  // The size along an open axis is ignored.
  EXPECT_NO_THROW(Box({Boundary::open, Boundary::wall, Boundary::open}, {kNan, 1, -1}));
}

TEST(Box, CountsTheBoxesBeyondAlongPeriodicAxesOnly) {
  const Box box = mixed_box();
  EXPECT_EQ(box.boxes_beyond({-100, 7.9, -100}), Image{});
  EXPECT_EQ(box.boxes_beyond({0, 8, 0}), (Image{{0, 1, 0}}));
  EXPECT_EQ(box.boxes_beyond({0, -0.1, 0}), (Image{{0, -1, 0}}));
  EXPECT_EQ(box.boxes_beyond({0, 8.0 * 1000 + 1, 0}), (Image{{0, 1000, 0}}));
  EXPECT_EQ(box.shift({{0, -3, 0}}), (Vec3{0, -24, 0}));
  EXPECT_THROW(box.boxes_beyond({0, 8 * 0x1p31, 0}), RunFailure);
  EXPECT_EQ(box.volume(), kInfinity);
  EXPECT_EQ(Box::walls({2, 3, 4}).volume(), 24);
}

TEST(Box, FoldsAlongPeriodicAxesOnly) {
  const Box box = mixed_box();
  for (const double y : {-8.0 * 3, -0.1, 0.0, 7.9, 8.0, 8.0 * 1000 + 1}) {
    const Vec3 beyond{-100, y, kInfinity};
    Vec3 folded = beyond;
    const Image image = box.fold(folded);
    EXPECT_EQ(image, box.boxes_beyond(beyond));
    EXPECT_EQ(image, (Image{{0, static_cast<std::int32_t>(std::floor(y / 8)), 0}}));
    EXPECT_EQ(folded, (Vec3{-100, y - 8 * image[1], kInfinity}));
  }
  Vec3 far{0, 8 * 0x1p31, 0};
  EXPECT_THROW(box.fold(far), RunFailure);
  Vec3 nowhere{0, kNan, 0};
  EXPECT_THROW(box.fold(nowhere), RunFailure);
}

TEST(Box, FindsTheNearestImageAlongPeriodicAxesOnly) {
  const Box box = mixed_box();
  EXPECT_EQ(box.nearest_image({9, 3.9, 1000}), Image{});
  EXPECT_EQ(box.nearest_image({9, 4.1, 1000}), (Image{{0, 1, 0}}));
  EXPECT_EQ(box.nearest_image({9, -4.1, 1000}), (Image{{0, -1, 0}}));
  EXPECT_EQ(box.nearest_image({9, -8.0 * 1000 - 3, 1000}), (Image{{0, -1000, 0}}));
}

TEST(World, StoresAPathAndCountsTheBoxesItHasLeft) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{9, 5, 5}, {1, 0, 0}, 0.5, 1});
  const Path path{{1, 5, 5}, {-1, 0, 0}, Time(2)};
  SphereEdit(world, path.time, 0).store_path(0, path, {{1, 0, 0}});
  EXPECT_EQ(world.path(0), path);
  EXPECT_EQ(image_of(world, 0, Time(2)), (Image{{1, 0, 0}}));
  SphereEdit(world, path.time, 0).store_path(0, path, {});
  EXPECT_EQ(image_of(world, 0, Time(3)), (Image{{1, 0, 0}}));
  EXPECT_EQ(image_of(world, 0, Time(4)), Image{});
}

TEST(World, NumbersSpheresInOrderAndNeverReusesAnId) {
  World world;
  for (SphereId id = 0; id < 5; ++id) EXPECT_EQ(world.add({{3.0 * id, 0, 0}, {}, 1, 1}), id);
  world.remove(1);
  world.remove(4);
  EXPECT_EQ(world.add({{50, 0, 0}, {}, 1, 2}), 5U);
  EXPECT_EQ(world.size(), 4U);
  EXPECT_EQ(world.slot_of(0), 0U);
  EXPECT_EQ(world.slot_of(2), 2U);
  EXPECT_EQ(world.slot_of(3), 1U);  // in place of sphere 1: with 4 gone, it was the last
  EXPECT_EQ(world.slot_of(5), 3U);
  EXPECT_EQ(world.id(3), 5U);
  EXPECT_EQ(world.mass(3), 2);
  for (const SphereId gone : {1U, 4U, 6U, 1000U}) {
    EXPECT_THROW(static_cast<void>(world.slot_of(gone)), Error);
    EXPECT_THROW(world.remove(gone), Error);
  }
}

TEST(World, RefusesInvalidNumbersAndChangesNothing) {
  World world(mixed_box());
  const Sphere good{{5, 4, 0}, {1, 0, 0}, 1, 1};
  std::vector<Sphere> bad(0);
  for (const double number : {kNan, kInfinity, -kInfinity, 1e61}) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      bad.push_back(good);
      bad.back().position[axis] = number;
      bad.push_back(good);
      bad.back().velocity[axis] = number;
    }
  }
  for (const double number : {0.0, -1.0, kNan, kInfinity, -kInfinity, 1e-61, 1e61}) {
    bad.push_back({.position = good.position, .radius = number});
    bad.push_back({.position = good.position, .inertia_factor = number});
    // Kinematic spheres have an infinite mass.
    if (number != kInfinity) bad.push_back({.position = good.position, .mass = number});
    if (number != 0 && number != -1) bad.push_back({.position = good.position, .spin = {0, number, 0}});
  }
  bad.push_back({{5, 4, 0}, {1e-61, 0, 0}, 1, 1});  // slower than the operating range and not at rest
  bad.push_back({{0.99, 4, 0}, {}, 1, 1});          // through the lower wall
  bad.push_back({{9.01, 4, 0}, {}, 1, 1});          // through the upper wall
  bad.push_back({{5, 4, 0}, {}, 4.01, 1});          // larger than the periodic box
  for (const Sphere& sphere : bad) EXPECT_THROW(world.add(sphere), Error);
  EXPECT_EQ(world.size(), 0U);
  EXPECT_EQ(world.add(good), 0U);
  EXPECT_THROW(world.change_velocity(0, Time(0), {kNan, 0, 0}), Error);
  EXPECT_EQ(world.path(0).velocity, good.velocity);
}

TEST(World, RefusesInvalidMoments) {
  World world(mixed_box());
  world.add({{5, 4, 0}, {1, 1, 1}, 1, 1}, Time(3));
  for (const Time& bad : {Time(kNan), Time(kInfinity), Time(-kInfinity), Time(1e300), Time(0, kNan),
                          Time(1, kInfinity), Time(1, 1)}) {
    EXPECT_THROW(world.add({{5, 4, 9}, {}, 1, 1}, bad), Error);
    EXPECT_THROW(world.change_velocity(0, bad, {1, 0, 0}), Error);
  }
  for (const Time& bad : {Time(kNan), Time(kInfinity), Time(-kInfinity)}) {
    EXPECT_THROW(world.position(0, bad), Error);
    EXPECT_THROW(image_of(world, 0, bad), Error);
  }
  EXPECT_EQ(world.size(), 1U);
  EXPECT_EQ(world.path(0), (Path{{5, 4, 0}, {1, 1, 1}, Time(3)})) << "nothing was half done";
  EXPECT_EQ(world.add({{5, 4, 9}, {}, 1, 1}, Time(-1e100, 1e80)), 1U);
}

TEST(World, RefusesCentersTooManyPeriodicBoxesAway) {
  World world(mixed_box());
  EXPECT_THROW(world.add({{5, 8 * 0x1p31, 0}, {}, 1, 1}), Error);
  EXPECT_THROW(world.add({{5, -1e60, 0}, {}, 1, 1}), Error);
  EXPECT_EQ(world.add({{5, 8 * 0x1p29 + 1, 1e60}, {}, 1, 1}), 0U) << "open axes have no boxes";
  EXPECT_EQ(world.path(0).position, (Vec3{5, 1, 1e60}));
}

TEST(World, HoldsSpheresThatTouchTheWallsOrFillTheBox) {
  World world(mixed_box());
  EXPECT_NO_THROW(world.add({{1, 4, 0}, {}, 1, 1}));
  EXPECT_NO_THROW(world.add({{9, 4, 3}, {}, 1, 1}));
  EXPECT_NO_THROW(world.add({{5, 4, 1e30}, {}, 4, 1}));
  // Rounding may put a center slightly too close.
  EXPECT_NO_THROW(world.add({{1 - 1e-13, 4, 8}, {}, 1, 1}));
}

TEST(World, FoldsPositionsAndCountsWhatItFolded) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{-3, 25, 5}, {1, -2, 0}, 1, 1});
  EXPECT_EQ(world.path(0).position, (Vec3{7, 5, 5}));
  EXPECT_EQ(image_of(world, 0, Time(0)), (Image{{-1, 2, 0}}));
  // At time 6 it is at x = 13, y = -7, relative to the folded start.
  EXPECT_EQ(world.position(0, Time(6)), (Vec3{3, 3, 5}));
  EXPECT_EQ(image_of(world, 0, Time(6)), (Image{{0, 1, 0}}));
  EXPECT_EQ(world.path(0).time, Time(0)) << "a query moves nothing";
  const Image folded = world.change_velocity(0, Time(6), {0, 0, 1});
  EXPECT_EQ(folded, (Image{{1, -1, 0}}));
  EXPECT_EQ(world.path(0), (Path{{3, 3, 5}, {0, 0, 1}, Time(6)}));
  EXPECT_EQ(image_of(world, 0, Time(6)), (Image{{0, 1, 0}}));
  EXPECT_EQ(image_of(world, 0, Time(36)), (Image{{0, 1, 3}}));
}

TEST(World, SumsEnergyMomentumAndVolume) {
  World world;
  EXPECT_EQ(world.largest_radius(), 0);
  EXPECT_EQ(kinetic_energy(world, Time(0)), 0);
  world.add({{0, 0, 0}, {3, 0, -4}, 2, 2});
  world.add({{9, 0, 0}, {0, 1, 0}, 1, 6});
  EXPECT_EQ(kinetic_energy(world, Time(0)), 28);
  EXPECT_EQ(momentum(world, Time(0)), (Vec3{6, 6, -8}));
  EXPECT_DOUBLE_EQ(sphere_volume(world, Time(0)), 12 * std::numbers::pi);
  EXPECT_EQ(world.largest_radius(), 2);
}

std::vector<Slot> random_order(std::size_t size, Random& random) {
  std::vector<Slot> order(size);
  std::iota(order.begin(), order.end(), 0U);
  for (std::size_t i = size; i > 1; --i) std::swap(order[i - 1], order[random.bits() % i]);
  return order;
}

// What a world knows about a sphere.
struct Known {
  SphereId id = 0;
  Path path;
  double radius = 0;
  double mass = 0;
  Image image;

  friend bool operator==(const Known&, const Known&) = default;
};

// In the order of ids; checks that all ways to look up a sphere agree.
std::vector<Known> known_by_id(const World& world) {
  std::vector<Known> known;
  world.for_each_by_id([&](Slot slot) {
    EXPECT_EQ(world.slot_of(world.id(slot)), slot);
    known.push_back({world.id(slot), world.path(slot), world.base_radius(slot), world.mass(slot),
                     image_of(world, slot, world.path(slot).time)});
  });
  EXPECT_EQ(known.size(), world.size());
  EXPECT_EQ(world.paths().size(), world.size());
  EXPECT_TRUE(
      std::is_sorted(known.begin(), known.end(), [](const Known& a, const Known& b) { return a.id < b.id; }));
  return known;
}

// Worlds with and without equal radii and equal masses.
class Reorder : public testing::TestWithParam<std::pair<bool, bool>> {
 protected:
  Sphere random_sphere(Random& random) const {
    const auto [mixed_radii, mixed_masses] = GetParam();
    const Vec3 place{20 * random.normal(), 20 * random.normal(), 20 * random.normal()};
    return {place,
            {random.normal(), random.normal(), random.normal()},
            mixed_radii ? 0.5 + random.uniform() : 0.7,
            mixed_masses ? 1 + 9 * random.uniform() : 3};
  }
};

TEST_P(Reorder, ChangesNothingButTheSlots) {
  Random random(1);
  World world(Box::periodic({10, 10, 10}));
  for (int i = 0; i < 200; ++i) world.add(random_sphere(random), Time(random.uniform()));
  for (const SphereId gone : {0U, 77U, 199U}) world.remove(gone);
  const std::vector<Known> before = known_by_id(world);
  const double energy = kinetic_energy(world, Time(0));
  const Vec3 momentum_before = momentum(world, Time(0));
  const double volume = sphere_volume(world, Time(0));
  for (int round = 0; round < 5; ++round) {
    const std::vector<Slot> order = random_order(world.size(), random);
    std::vector<SphereId> ids;
    for (const Slot slot : order) ids.push_back(world.id(slot));
    world.reorder(order);
    for (Slot slot = 0; slot < world.size(); ++slot) ASSERT_EQ(world.id(slot), ids[slot]);
    ASSERT_EQ(known_by_id(world), before);
    // To the last bit, since sums are taken in the order of ids.
    EXPECT_TRUE(support::same_bits(kinetic_energy(world, Time(0)), energy));
    EXPECT_TRUE(support::same_bits(momentum(world, Time(0)), momentum_before));
    EXPECT_TRUE(support::same_bits(sphere_volume(world, Time(0)), volume));
    EXPECT_EQ(world.base_radii().is_common(), !GetParam().first);
    for (const SphereId gone : {0U, 77U, 199U, 200U})
      EXPECT_THROW(static_cast<void>(world.slot_of(gone)), Error);
  }
  // Back to the order of ids.
  std::vector<Slot> order;
  world.for_each_by_id([&](Slot slot) { order.push_back(slot); });
  world.reorder(order);
  for (Slot slot = 0; slot < world.size(); ++slot) EXPECT_EQ(world.id(slot), before[slot].id);
  EXPECT_EQ(known_by_id(world), before);
}

// Between reorderings, spheres are added and removed and change their paths, here and in a world whose slots
// stay in the order of ids.
TEST_P(Reorder, AllowsSpheresToBeAddedAndRemoved) {
  Random random(2);
  World world(Box::periodic({10, 10, 10}));
  World plain = world;
  for (int step = 0; step < 500; ++step) {
    const double what = random.uniform();
    if (what < 0.4 || world.size() == 0) {
      const Sphere sphere = random_sphere(random);
      ASSERT_EQ(world.add(sphere, Time(step)), plain.add(sphere, Time(step)));
    } else if (what < 0.7) {
      const SphereId id = world.id(static_cast<Slot>(random.bits() % world.size()));
      world.remove(id);
      plain.remove(id);
    } else if (what < 0.85) {
      const SphereId id = world.id(static_cast<Slot>(random.bits() % world.size()));
      const Vec3 velocity{random.normal(), random.normal(), random.normal()};
      ASSERT_EQ(world.change_velocity(world.slot_of(id), Time(step), velocity),
                plain.change_velocity(plain.slot_of(id), Time(step), velocity));
    } else {
      world.reorder(random_order(world.size(), random));
    }
    ASSERT_EQ(known_by_id(world), known_by_id(plain)) << "step " << step;
    ASSERT_EQ(world.largest_radius(), plain.largest_radius());
    ASSERT_TRUE(support::same_bits(kinetic_energy(world, Time(0)), kinetic_energy(plain, Time(0))));
    ASSERT_TRUE(support::same_bits(momentum(world, Time(0)), momentum(plain, Time(0))));
  }
}

INSTANTIATE_TEST_SUITE_P(RadiiAndMasses, Reorder,
                         testing::Values(std::pair(false, false), std::pair(true, false),
                                         std::pair(false, true), std::pair(true, true)));

TEST(World, HasNoLargestRadiusAfterTheLastSphereIsGone) {
  World world;
  world.add({{0, 0, 0}, {}, 2, 1});
  world.remove(0);
  EXPECT_EQ(world.largest_radius(), 0);
  world.add({{0, 0, 0}, {}, 2, 1});
  world.add({{9, 0, 0}, {}, 1, 1});
  world.remove(1);
  EXPECT_EQ(world.largest_radius(), 1);
  world.remove(2);
  EXPECT_EQ(world.largest_radius(), 0);
}

// A wall contact is never overlooked, not even by a unit in the last place, and one that comes much later is
// excluded.
TEST(NextWallEvent, IsNeverOverlookedByMayMeetWall) {
  std::uint64_t excluded = 0;
  for (std::uint64_t seed = 0; seed < support::cases(20000); ++seed) {
    Random random(seed);
    constexpr double kStarts[] = {0, 1, 1e12};
    const Time start(kStarts[seed % 3], 1e-17 * random.uniform() * kStarts[seed % 3]);
    World world(Box({Boundary::wall, Boundary::periodic, Boundary::wall}, {10, 20, 30}));
    const double scale = std::exp2(40 * (random.uniform() - 0.5));
    const Vec3 velocity{scale * random.normal(), scale * random.normal(),
                        seed % 5 == 0 ? 0 : scale * random.normal()};
    world.add({{1 + 8 * random.uniform(), 20 * random.uniform(), 1 + 28 * random.uniform()}, velocity, 1, 1},
              start);
    const double contact = next_wall_event(world, 0, Time(0)).time.high;
    EXPECT_TRUE(may_meet_wall(world, 0, std::nextafter(contact, kNever.high), Time(0))) << "seed " << seed;
    EXPECT_TRUE(may_meet_wall(world, 0, kNever.high, Time(0))) << "seed " << seed;
    const double half = start.high + (contact - start.high) / 2;
    excluded += half < contact && !may_meet_wall(world, 0, half, Time(0)) ? 1U : 0U;
  }
  EXPECT_GT(excluded, support::cases(20000) / 2);
}

TEST(NextWallEvent, IsTheFirstFaceAheadAndPrefersTheLowerOnATie) {
  World world(Box::walls({10, 10, 10}));
  world.add({{5, 5, 5}, {2, -1, 0}, 1, 1});
  world.add({{5, 5, 5}, {-1, 1, 1}, 1, 1});
  world.add({{5, 5, 5}, {0, 0, 0}, 1, 1});
  world.add({{9, 5, 5}, {1, 0, 0}, 1, 1});
  world.add({{9, 5, 5}, {-1, 0, 0}, 1, 1});
  EXPECT_EQ(next_wall_event(world, 0, Time(0)), (Event{Time(2), EventKind::wall, 0, face_of(0, true), {}}));
  EXPECT_EQ(next_wall_event(world, 1, Time(0)), (Event{Time(4), EventKind::wall, 1, face_of(0, false), {}}));
  EXPECT_FALSE(next_wall_event(world, 2, Time(0)).happens());
  EXPECT_EQ(next_wall_event(world, 3, Time(0)).time, Time(0)) << "touching and approaching";
  EXPECT_EQ(next_wall_event(world, 4, Time(0)).time, Time(8)) << "touching and receding";
  World open;
  open.add({{0, 0, 0}, {1, 1, 1}, 1, 1});
  EXPECT_FALSE(next_wall_event(open, 0, Time(0)).happens());
}

TEST(ContactTime, OfTwoSpheresOfAWorldDependsOnTheImage) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{1, 5, 5}, {-1, 0, 0}, 0.5, 1});
  world.add({{8, 5, 5}, {0, 0, 0}, 0.5, 1});
  EXPECT_EQ(contact_time(world, 0, 1, {}), kNever);
  EXPECT_EQ(contact_time(world, 0, 1, {{-1, 0, 0}}), Time(2));
  EXPECT_EQ(contact_time(world, 1, 0, {{1, 0, 0}}), Time(2));
  EXPECT_EQ(contact_time(world, 0, 1, {{-2, 0, 0}}), Time(12)) << "once around the box";
}

TEST(World, RefusesObstaclesThatMoveInAPeriodicBox) {
  const std::vector<Surface> moving{Surface(Obstacle(1), {5, 5, 5}, {0, 0.5, 0})};
  EXPECT_THROW(World(Box({Boundary::periodic, Boundary::wall, Boundary::wall}, {10, 10, 10}), {}, moving),
               Error);
  EXPECT_NO_THROW(World(Box::walls({10, 10, 10}), {}, moving));
}

TEST(World, RefusesSurfacesThatAreNotPeriodic) {
  const Box box({Boundary::periodic, Boundary::wall, Boundary::wall}, {10, 10, 10});
  const auto make = [&](const Surface& surface) { return World(box, {}, {surface}); };
  EXPECT_NO_THROW(make(Surface(Plane({0, 0, 1}), {0, 0, 1})));
  EXPECT_NO_THROW(make(Surface(Cylinder({1, 0, 0}, 4), {0, 5, 5})));
  EXPECT_NO_THROW(make(Surface(HollowSphere(5), {5, 5, 5})));
  EXPECT_NO_THROW(make(Surface(Obstacle(2), {9.5, 5, 5})));
  EXPECT_NO_THROW(make(Surface(Obstacle(40), {-5, 5, 15})));
  EXPECT_THROW(make(Surface(Obstacle(2), {-11, 5, 5})), Error);
  EXPECT_THROW(make(Surface(Obstacle(2), {21, 5, 5})), Error);
  EXPECT_THROW(make(Surface(Obstacle(81), {5, 5, 5})), Error);
  EXPECT_THROW(make(Surface(Plane({0.6, 0, 0.8}), {})), Error);
  EXPECT_THROW(make(Surface(OscillatingPlane({1, 0, 0}, 1, 1), {})), Error);
  EXPECT_THROW(make(Surface(Cylinder({0.6, 0.8, 0}, 4), {5, 5, 5})), Error);
  EXPECT_THROW(make(Surface(Cylinder({0, 0, 1}, 4), {3, 5, 5})), Error);
  EXPECT_THROW(make(Surface(HollowSphere(5), {4, 5, 5})), Error);
  EXPECT_THROW(make(Surface(HollowSphere(3), {5, 5, 5}, {1, 0, 0})), Error);
}

}  // namespace
}  // namespace hardball::world_test
