// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/layout.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

#include "hardball/domains/block_distances.hpp"
#include "hardball/domains/load.hpp"
#include "hardball/domains/ownership_map.hpp"
#include "hardball/domains/partition.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/gas.hpp"
#include "support/random_centers.hpp"

namespace hardball::layout_test {
namespace {

constexpr Vec3 kSize{20, 10, 10};
const Box kBox = Box::periodic(kSize);

SystemSize size_of(const std::vector<Vec3>& centers, double diameter) {
  return {.spheres = centers.size(), .speeds = static_cast<double>(centers.size()), .contact = diameter};
}

// A tenth of all windows has failed.
constexpr WindowCounters kOftenFailed{.windows = 100, .failed = 10};

TEST(Layout, HasSoManyDomainsThatNoneHasTooManyNeighbors) {
  const std::vector<Vec3> centers = support::random_centers(1000, kSize);
  Layout layout({.domains = 64, .halo = 1.5});
  layout.lay_out(kBox, size_of(centers, 0.5), centers);
  EXPECT_EQ(layout.partition().size(), 64U);
  EXPECT_DOUBLE_EQ(layout.halo().depth, 0.75);
  layout.lay_out(kBox, size_of(centers, 2), centers);
  EXPECT_EQ(layout.partition().size(), 32U);
  EXPECT_LE(layout.partition().most_neighbors(layout.halo().neighborhood()), kMaxNeighbors);
}

TEST(Layout, RefusesMoreProcessesThanCanBeNeighbors) {
  const std::vector<Vec3> centers = support::random_centers(1000, kSize);
  Layout layout({.domains = 4, .halo = 1.5}, 64);
  layout.lay_out(kBox, size_of(centers, 0.5), centers);
  EXPECT_EQ(layout.partition().size() % 64, 0U);
  EXPECT_THROW(layout.lay_out(kBox, size_of(centers, 4), centers), Error);
}

TEST(Layout, DeepensHalosByStepsWhileWindowsFail) {
  const std::vector<Vec3> centers = support::random_centers(1000, kSize);
  const SystemSize size = size_of(centers, 1);
  Layout layout({.domains = 4, .halo = 3.7});
  layout.lay_out(kBox, size, centers);
  const Load load{{10, 10, 10, 10}, kOftenFailed};
  ASSERT_TRUE(layout.may_improve(load, size.spheres));
  EXPECT_TRUE(layout.improve(load, kBox, size, centers));
  EXPECT_DOUBLE_EQ(layout.halo().depth, 3.95);
  EXPECT_FALSE(layout.may_improve(load, size.spheres));
}

// Blocks crowd where the contacts are: then halos cannot be as deep, or blocks have to stay where they are.
TEST(Layout, NeverGetsTooManyNeighborsByLoad) {
  constexpr std::size_t kDomains = 40;
  const std::vector<Vec3> centers = support::random_centers(4000, kSize);
  Load load{std::vector<std::uint64_t>(kDomains, 0), kOftenFailed};
  for (std::size_t k = 0; k < 4; ++k) load.contacts[k] = 1'000'000;
  std::size_t deeper = 0;
  std::size_t only_moved = 0;
  std::size_t unchanged = 0;
  for (double diameter = 0.2; diameter < 2; diameter *= 1.01) {
    const SystemSize size = size_of(centers, diameter);
    Layout layout({.domains = kDomains, .halo = 1.5});
    layout.lay_out(kBox, size, centers);
    if (layout.partition().size() < kDomains) break;
    ASSERT_TRUE(load.is_uneven(size.spheres));
    const double before = layout.partition().block(0).high(0);
    const bool has_improved = layout.improve(load, kBox, size, centers);
    EXPECT_EQ(layout.partition().size(), kDomains);
    EXPECT_LE(layout.partition().most_neighbors(layout.halo().neighborhood()), kMaxNeighbors);
    const bool is_deeper = layout.halo().depth > 1.6 * diameter;
    const bool has_moved = layout.partition().block(0).high(0) != before;
    EXPECT_EQ(has_improved, has_moved);
    ++(is_deeper ? deeper : has_moved ? only_moved : unchanged);
  }
  EXPECT_GT(deeper, 0U);
  EXPECT_GT(only_moved, 0U);
  EXPECT_GT(unchanged, 0U);
}

TEST(Layout, IsReviewedEverySoManyWindows) {
  const std::vector<Vec3> centers = support::random_centers(100, kSize);
  Layout layout({.domains = 2});
  layout.lay_out(kBox, size_of(centers, 1), centers);
  EXPECT_FALSE(layout.is_review_due(63));
  EXPECT_TRUE(layout.is_review_due(64));
  EXPECT_FALSE(layout.is_review_due(127));
  EXPECT_TRUE(layout.is_review_due(128));
  Layout alone({.domains = 1});
  alone.lay_out(kBox, size_of(centers, 1), centers);
  EXPECT_FALSE(alone.is_review_due(1000));
}

TEST(BlockDistances, AreThoseOfEachBlock) {
  constexpr std::array kKinds{Boundary::periodic, Boundary::wall, Boundary::open};
  constexpr Vec3 kEdges{10, 7, 4};
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto kind = [&] { return kKinds[static_cast<std::size_t>(3 * random.uniform())]; };
    const Box box({kind(), kind(), kind()}, kEdges);
    const auto point = [&](double margin) {
      Vec3 place;
      for (std::size_t axis = 0; axis < kAxes; ++axis)
        place[axis] = kEdges[axis] * (random.uniform() * (1 + 2 * margin) - margin);
      return place;
    };
    std::vector<Vec3> centers;
    for (int k = 0; k < 200; ++k) centers.push_back(point(0));
    const std::size_t count = 1 + seed % BlockDistances::kMaxBlocks;
    const Partition partition = Partition::bisection(box, count, centers);
    const BlockDistances all(partition.blocks());
    for (int k = 0; k < 20; ++k) {
      // Starts of legs may lie outside the box.
      const Vec3 place = point(0.5);
      BlockDistances::Distances distances;
      all.find(place, distances);
      for (std::size_t block = 0; block < count; ++block)
        ASSERT_EQ(distances[block], partition.blocks()[block].distance(place)) << block;
    }
  }
}

TEST(Load, IsUnevenWhereDomainsWait) {
  EXPECT_EQ((Load{{100, 100, 100}, {}}.waited()), 0U);
  EXPECT_EQ((Load{{100, 300, 200}, {}}.waited()), 300U);
  EXPECT_FALSE((Load{{0, 400}, {}}.is_uneven(100)));
  EXPECT_TRUE((Load{{0, 401}, {}}.is_uneven(100)));
}

TEST(Load, HasShallowHalosWhereManyWindowsFail) {
  EXPECT_FALSE((Load{{1, 1}, {.windows = 320, .failed = 10}}.has_shallow_halos()));
  EXPECT_TRUE((Load{{1, 1}, {.windows = 320, .failed = 11}}.has_shallow_halos()));
}

// The blocks that are made have the same load, if spheres of a domain are alike.
TEST(Load, MovesCutsToWhereContactsAre) {
  const Box box = Box::periodic({20, 10, 10});
  const std::vector<Vec3> centers = support::random_centers(20000, {20, 10, 10});
  const Partition before = Partition::bisection(box, 2, centers);
  ASSERT_NEAR(before.block(0).high(0), 10, 0.2);
  const Partition after =
      Partition::bisection(box, 2, centers_by_load(centers, before, {{30000, 10000}, {}}));
  // Three quarters of the contacts are below 10, evenly: half of all are below 20 / 3.
  EXPECT_NEAR(after.block(0).high(0), 20.0 / 3, 0.2);
  const Partition same = Partition::bisection(box, 2, centers_by_load(centers, before, {{20000, 20000}, {}}));
  EXPECT_NEAR(same.block(0).high(0), before.block(0).high(0), 0.2);
}

// Fast spheres on one side, slow ones on the other.
TEST(Load, HasSystemsDividedAnew) {
  World world = support::make_gas({.count = 2000, .packing_fraction = 0.3, .seed = 11});
  const double middle = world.box().size().x / 2;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    if (world.path(slot).position.x > middle)
      world.change_velocity(slot, Time(0), 0.01 * world.velocity(slot, Time(0)));
  }
  Simulation expected(world);
  Simulation divided(world, {.division = Division{.domains = 4, .window = 0.5}});
  const auto cuts = [&] {
    std::vector<double> places;
    for (const Block& block : divided.blocks()) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) places.push_back(block.low(axis));
    }
    return places;
  };
  const std::vector<double> cuts_before = cuts();
  expected.run_contacts(60000);
  divided.run_contacts(60000);
  EXPECT_EQ(divided.event_log_hash(), expected.event_log_hash());
  EXPECT_EQ(divided.positions(), expected.positions());
  EXPECT_EQ(divided.tally().virial(), expected.tally().virial());
  EXPECT_NE(cuts(), cuts_before);
  EXPECT_EQ(expected.counters().collision, divided.counters().collision);
}

}  // namespace
}  // namespace hardball::layout_test
