// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/geometry/extent_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "hardball/geometry/swept_ball.hpp"
#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"

namespace hardball::extent_tree_test {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

Vec3 random_point(Random& random, const Vec3& size) {
  return {size.x * random.uniform(), size.y * random.uniform(), size.z * random.uniform()};
}

// Of all sizes and far from each other, or close to a place that is far away.
std::vector<ExtentTree::Item> random_items(Random& random) {
  const double scale = std::pow(10.0, 110 * random.uniform() - 55);
  const double spread = random.uniform() < 0.3 ? std::exp2(-50 * random.uniform()) : 1;
  const Vec3 center = scale * random.direction();
  std::vector<ExtentTree::Item> items;
  const std::size_t count = 1 + random.bits() % 200;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3 low = center + (spread * scale) * random_point(random, {1, 1, 1});
    const double size = spread * scale * std::exp2(-60 * random.uniform());
    const Vec3 high = random.uniform() < 0.1 ? low : low + random_point(random, {size, size, size});
    items.push_back({{low, high}, 7 * i});
  }
  return items;
}

TEST(ExtentTree, HasExtentsAroundItemsOfAnySize) {
  for (std::uint64_t seed = 0; seed < support::cases(300); ++seed) {
    Random random(seed);
    const auto items = random_items(random);
    const ExtentTree tree(items);
    Extent all = items.front().extent;
    for (const auto& item : items) {
      all.enclose(item.extent);
      // What is asked about is a corner of the item, which no extent around it leaves out.
      for (const Vec3& corner : {item.extent.low, item.extent.high}) {
        bool is_found = false;
        tree.for_each_in({corner, corner}, [&](std::uint32_t number) { is_found |= number == item.number; });
        EXPECT_TRUE(is_found) << "seed " << seed << ", item " << item.number;
      }
    }
    EXPECT_EQ(tree.extent().low, all.low);
    EXPECT_EQ(tree.extent().high, all.high);
  }
}

TEST(ExtentTree, LeavesOutWhatIsFarAway) {
  std::uint64_t visits = 0;
  for (std::uint64_t seed = 0; seed < support::cases(300); ++seed) {
    Random random(seed);
    std::vector<ExtentTree::Item> items;
    for (std::uint32_t i = 0; i < 1000; ++i) {
      const Vec3 place = random_point(random, {10, 10, 10});
      items.push_back({Extent{place, place}.grown(0.1), i});
    }
    const ExtentTree tree(items);
    const Vec3 place = random_point(random, {10, 10, 10});
    tree.for_each_in(Extent{place, place}.grown(0.4), [&](std::uint32_t) { ++visits; });
  }
  // Of the thousand one is in the cube of edge 1 where an item is near enough.
  EXPECT_LT(visits, support::cases(300) * 2);
}

// As the walls of a box in a file: each of two triangles of a wall reaches along all of it.
TEST(ExtentTree, AsksFewNodesAboutOneOfManyWalls) {
  std::vector<ExtentTree::Item> walls;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (const double place : {0.0, 1.0}) {
      Extent wall{{0, 0, 0}, {1, 1, 1}};
      wall.low[axis] = wall.high[axis] = place;
      for (int triangle = 0; triangle < 2; ++triangle)
        walls.push_back({wall, static_cast<std::uint32_t>(walls.size())});
    }
  }
  const ExtentTree tree(walls);
  double asked = 0;
  double visits = 0;
  const auto cases = static_cast<double>(support::cases(3000));
  for (std::uint64_t seed = 0; seed < support::cases(3000); ++seed) {
    Random random(seed);
    Vec3 place = random_point(random, {1, 1, 1});
    place[random.bits() % kAxes] = random.bits() % 2 == 0 ? 0.001 : 0.999;
    const double farthest = 0.002;
    tree.for_each_within(
        farthest,
        [&](const FourExtents& extents) {
          ++asked;
          return distance_to(extents, place);
        },
        [&](std::uint32_t) { ++visits; });
  }
  EXPECT_NEAR(visits, 2 * cases, 0.1 * cases);
  // There are four at least.
  EXPECT_LT(asked, 3.2 * cases);
}

TEST(FourExtents, AreAsFarAsEachOfThem) {
  for (std::uint64_t seed = 0; seed < support::cases(3000); ++seed) {
    Random random(seed);
    FourExtents four;
    std::array<Extent, FourNumbers::kCount> each;
    for (std::size_t i = 0; i < each.size(); ++i) {
      const Vec3 low = random_point(random, {4, 4, 4});
      each[i] = {low, low + random_point(random, {2, 2, 2})};
    }
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      four.low[axis] =
          FourNumbers(std::array{each[0].low[axis], each[1].low[axis], each[2].low[axis], each[3].low[axis]});
      four.high[axis] = FourNumbers(
          std::array{each[0].high[axis], each[1].high[axis], each[2].high[axis], each[3].high[axis]});
    }
    const Vec3 place = random_point(random, {6, 6, 6});
    const FourNumbers distances = distance_to(four, place);
    Vec3 velocity = random.direction();
    if (random.uniform() < 0.3) velocity[random.bits() % kAxes] = 0;
    if (random.uniform() < 0.1) velocity = {};
    const Vec3 acceleration = random.uniform() < 0.3 ? random.direction() : Vec3{};
    const double growth = random.uniform() < 0.3 ? random.uniform() - 0.3 : 0;
    const SweptBall ball(place, velocity, acceleration, random.uniform(), growth);
    const double begin = random.uniform();
    const double end = random.uniform() < 0.3 ? kForever : begin + 4 * random.uniform();
    const FourNumbers free = ball.free_until(four, begin, end, 1e-12);
    for (std::size_t i = 0; i < each.size(); ++i) {
      EXPECT_DOUBLE_EQ(distances[i], distance_to(each[i], place)) << "seed " << seed;
      const double alone = ball.free_until(each[i], begin, end, 1e-12);
      EXPECT_EQ(free[i] < kForever, alone < kForever) << "seed " << seed;
      if (alone < kForever) {
        EXPECT_NEAR(free[i], alone, 1e-12 * (1 + alone)) << "seed " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace hardball::extent_tree_test
