// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/kernels/kernels.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/world/random.hpp"
#include "support/effort.hpp"
#include "support/instruction_sets.hpp"

namespace hardball::kernels_test {
namespace {

using support::available_instruction_sets;

TEST(InstructionSet, PortableIsAlwaysAvailableAndTheWidestIsToo) {
  EXPECT_TRUE(is_available(InstructionSet::portable));
  EXPECT_TRUE(is_available(widest_instruction_set()));
  EXPECT_EQ(widest_instruction_set(), available_instruction_sets().back());
}

TEST(InstructionSet, IsRefusedWhereItIsNotAvailable) {
  for (const InstructionSet set : {InstructionSet::portable, InstructionSet::avx2, InstructionSet::avx512}) {
    if (is_available(set)) {
      EXPECT_NO_THROW(kernels_of(set));
    } else {
      EXPECT_THROW(kernels_of(set), Error);
    }
  }
}

// Points on the grid, and a query for some of them. Along periodic axes the ring of integers is the box.
struct Points {
  std::vector<std::array<std::int32_t, 3>> places;
  std::vector<float> radii;
  std::vector<std::uint32_t> asked;
  std::array<float, 3> grid{};
  std::array<bool, 3> is_periodic{};
};

constexpr double kSize = 8;

// Along open axes, a ring twice as large as the box: no difference wraps around.
std::array<std::int32_t, 3> random_place(const Points& points, Random& random) {
  std::array<std::int32_t, 3> place{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto steps = static_cast<std::uint32_t>(random.bits());
    place[axis] = static_cast<std::int32_t>(points.is_periodic[axis] ? steps : steps / 2);
  }
  return place;
}

Points random_points(Random& random) {
  Points points;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    points.is_periodic[axis] = random.uniform() < 0.5;
    points.grid[axis] = static_cast<float>(std::ldexp(points.is_periodic[axis] ? kSize : 2 * kSize, -32));
  }
  for (std::uint32_t slot = 0; slot < 60; ++slot) {
    points.places.push_back(random_place(points, random));
    points.radii.push_back(static_cast<float>(0.1 + random.uniform()));
    if (random.uniform() < 0.7) points.asked.push_back(slot);
  }
  return points;
}

// The distance of the nearest image from `place`.
double distance(const Points& points, std::uint32_t slot, const std::array<std::int32_t, 3>& place) {
  Vec3 apart;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double grid = points.grid[axis];
    apart[axis] = grid * points.places[slot][axis] - grid * place[axis];
    if (points.is_periodic[axis]) apart[axis] = std::remainder(apart[axis], kSize);
  }
  return length(apart);
}

// The points asked for in blocks, with gaps, and which blocks these are. The gaps hold places, too.
struct Blocks {
  std::vector<PointBlock> blocks;
  std::vector<std::uint32_t> numbers;
};

Blocks blocks_of(const Points& points, const std::array<std::int32_t, 3>& place, Random& random) {
  Blocks made;
  std::size_t next = 0;
  while (next < points.asked.size()) {
    PointBlock block;
    for (std::size_t lane = 0; lane < PointBlock::kRoom; ++lane) {
      const bool is_gap = next == points.asked.size() || random.uniform() < 0.3;
      const auto& from = is_gap ? place : points.places[points.asked[next]];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        block.places[axis][lane] = static_cast<std::uint32_t>(from[axis]);
      }
      if (!is_gap) block.slots[lane] = points.asked[next++];
    }
    // Others that are not asked for are between.
    if (random.uniform() < 0.5) made.blocks.push_back(block);
    made.numbers.push_back(static_cast<std::uint32_t>(made.blocks.size()));
    made.blocks.push_back(block);
  }
  return made;
}

TEST(NearKernel, PicksThePointsWithinReachWithAllInstructionSets) {
  std::size_t picked = 0;
  for (std::uint64_t seed = 0; seed < support::cases(2000); ++seed) {
    Random random(seed);
    const Points points = random_points(random);
    const std::array<std::int32_t, 3> place = random_place(points, random);
    const auto reach = static_cast<float>(3 * random.uniform());
    const bool has_radii = seed % 2 == 0;
    std::vector<std::uint32_t> expected;
    bool is_close = false;  // to the reach, where rounding to single precision decides
    for (const std::uint32_t slot : points.asked) {
      const double apart = distance(points, slot, place);
      const double beyond = apart - double{reach} - double{has_radii ? points.radii[slot] : 0};
      if (beyond < 0) expected.push_back(slot);
      is_close |= std::fabs(beyond) < 0x1p-21 * apart;
    }
    if (is_close) continue;
    const Blocks blocks = blocks_of(points, place, random);
    constexpr float kMargin = 0.125F;
    const NearQuery query{
        .blocks = blocks.blocks.data(),
        .numbers = blocks.numbers.data(),
        .count = blocks.numbers.size(),
        .place = place,
        .grid = points.grid,
        // The margin belongs to the points.
        .reach = has_radii ? reach - kMargin : reach,
        .radii = has_radii ? points.radii.data() : nullptr,
        .margin = kMargin,
    };
    for (const InstructionSet set : available_instruction_sets()) {
      std::vector<std::uint32_t> near(points.asked.size() + kWidestVector);
      near.resize(kernels_of(set).pick_near(query, near.data()));
      ASSERT_EQ(near, expected) << "seed " << seed;
    }
    picked += expected.size();
  }
  EXPECT_GT(picked, support::cases(2000));
}

// Even where rounding decides.
TEST(NearKernel, FindsTheSameInBothDirections) {
  std::uint64_t near_ones = 0;
  for (std::uint64_t seed = 0; seed < support::cases(20000); ++seed) {
    Random random(seed);
    const Points points = random_points(random);
    const double step = random.uniform() < 0.5 ? 0x1p-23 : 0x1p-24;
    const double rounding = step * (std::floor(5 * random.uniform()) - 2);
    const double exact = distance(points, 0, points.places[1]);
    for (const InstructionSet set : available_instruction_sets()) {
      const auto is_near = [&](std::uint32_t from, std::uint32_t to) {
        PointBlock block;
        block.slots[0] = to;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          block.places[axis][0] = static_cast<std::uint32_t>(points.places[to][axis]);
        }
        const std::uint32_t number = 0;
        std::vector<std::uint32_t> near(1 + kWidestVector);
        const NearQuery query{.blocks = &block,
                              .numbers = &number,
                              .count = 1,
                              .place = points.places[from],
                              .grid = points.grid,
                              .reach = static_cast<float>(exact * (1 + rounding)),
                              .radii = nullptr,
                              .margin = 0};
        return kernels_of(set).pick_near(query, near.data());
      };
      ASSERT_EQ(is_near(0, 1), is_near(1, 0)) << "seed " << seed;
      near_ones += is_near(0, 1);
    }
  }
  const std::uint64_t queries = support::cases(20000) * available_instruction_sets().size();
  EXPECT_GT(near_ones, queries / 4);
  EXPECT_LT(near_ones, queries * 3 / 4);
}

}  // namespace
}  // namespace hardball::kernels_test
