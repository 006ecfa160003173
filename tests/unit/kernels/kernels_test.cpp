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

namespace hardball {
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
  std::vector<GridPoint> places;
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
    points.places.push_back({random_place(points, random), {}});
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
    apart[axis] = grid * points.places[slot].place[axis] - grid * place[axis];
    if (points.is_periodic[axis]) apart[axis] = std::remainder(apart[axis], kSize);
  }
  return length(apart);
}

TEST(NearKernel, PicksThePointsWithinReachWithAllInstructionSets) {
  std::size_t picked = 0;
  for (std::uint64_t seed = 0; seed < support::cases(2000); ++seed) {
    Random random(seed);
    Points points = random_points(random);
    const auto count = static_cast<std::size_t>(random.bits() % (points.asked.size() + 1));
    const std::array<std::int32_t, 3> place = random_place(points, random);
    const auto reach = static_cast<float>(3 * random.uniform());
    const bool has_radii = seed % 2 == 0;
    std::vector<std::uint32_t> expected;
    bool is_close = false;  // to the reach, where rounding to single precision decides
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t slot = points.asked[i];
      const double apart = distance(points, slot, place);
      const double beyond = apart - double{reach} - double{has_radii ? points.radii[slot] : 0};
      if (beyond < 0) expected.push_back(slot);
      is_close |= std::fabs(beyond) < 0x1p-21 * apart;
    }
    if (is_close) continue;
    // The padding contains near points, too.
    std::uint32_t nearest = 0;
    for (std::uint32_t slot = 1; slot < points.places.size(); ++slot) {
      if (distance(points, slot, place) < distance(points, nearest, place)) nearest = slot;
    }
    points.asked.resize(count);
    points.asked.resize(count + kWidestVector, nearest);
    constexpr float kMargin = 0.125F;
    const NearQuery query{
        .points = points.places.data(),
        .slots = points.asked.data(),
        .count = count,
        .place = place,
        .grid = points.grid,
        // The margin belongs to the points.
        .reach = has_radii ? reach - kMargin : reach,
        .radii = has_radii ? points.radii.data() : nullptr,
        .margin = kMargin,
    };
    for (const InstructionSet set : available_instruction_sets()) {
      std::vector<std::uint32_t> near(count + kWidestVector);
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
    const double exact = distance(points, 0, points.places[1].place);
    for (const InstructionSet set : available_instruction_sets()) {
      const auto is_near = [&](std::uint32_t from, std::uint32_t to) {
        const std::vector<std::uint32_t> asked(1 + kWidestVector, to);
        std::vector<std::uint32_t> near(1 + kWidestVector);
        const NearQuery query{.points = points.places.data(),
                              .slots = asked.data(),
                              .count = 1,
                              .place = points.places[from].place,
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
}  // namespace hardball
