// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/kernels/kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <set>
#include <vector>

#include "hardball/broadphase/point_lists.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"
#include "support/instruction_sets.hpp"

namespace hardball::kernels_test {
namespace {

using support::available_instruction_sets;

TEST(InstructionSet, PortableIsAlwaysAvailableAndTheFastestIsToo) {
  EXPECT_TRUE(is_available(InstructionSet::portable));
  EXPECT_TRUE(is_available(fastest_instruction_set()));
  EXPECT_EQ(fastest_instruction_set() == InstructionSet::portable, !is_available(InstructionSet::avx2));
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

// Points in cells, and a place in one of them, the cell at the origin.
struct Points {
  struct Cell {
    std::array<std::int32_t, 3> offset{};
    std::vector<std::uint32_t> slots;
  };
  std::vector<std::array<std::int32_t, 3>> places;  // in their cells
  std::vector<Cell> cells;
  std::vector<float> radii;
  std::array<std::int32_t, 3> place{};
  std::array<float, 3> unit{};

  std::array<std::int32_t, 3> apart(const Cell& cell, std::uint32_t slot) const {
    std::array<std::int32_t, 3> steps{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      steps[axis] = cell.offset[axis] + places[slot][axis] - place[axis];
    return steps;
  }
  double distance(const Cell& cell, std::uint32_t slot) const {
    const std::array<std::int32_t, 3> steps = apart(cell, slot);
    Vec3 way;
    for (std::size_t axis = 0; axis < 3; ++axis) way[axis] = double{unit[axis]} * steps[axis];
    return length(way);
  }
};

std::array<std::int32_t, 3> random_place(Random& random) {
  std::array<std::int32_t, 3> place{};
  for (std::int32_t& number : place)
    number = static_cast<std::int32_t>(random.bits() % (PackedPosition::kMax + 1));
  return place;
}

Points random_points(Random& random) {
  Points points;
  points.place = random_place(random);
  for (float& unit : points.unit) unit = static_cast<float>((1 + random.uniform()) / 1024);
  for (std::int32_t x = -1; x <= 1; ++x) {
    for (std::int32_t y = -1; y <= 1; ++y) {
      if (random.uniform() < 0.2) continue;
      points.cells.push_back({{x * 1000, y * 1010, 0}, {}});
      // Some cells have more than a block holds.
      const std::uint64_t count = random.bits() % (random.uniform() < 0.2 ? 40 : 6);
      for (std::uint64_t i = 0; i < count; ++i) {
        points.cells.back().slots.push_back(static_cast<std::uint32_t>(points.places.size()));
        points.places.push_back(random_place(random));
        points.radii.push_back(static_cast<float>(0.1 + random.uniform()));
      }
    }
  }
  return points;
}

// The points in lists, as a kernel wants them.
struct Lists {
  PointLists lists;
  std::vector<CellNearby> cells;
};

Lists lists_of(const Points& points) {
  Lists made;
  made.lists.reset(points.cells.size());
  for (std::uint32_t list = 0; list < points.cells.size(); ++list) {
    const Points::Cell& cell = points.cells[list];
    CellNearby nearby{list, cell.offset};
    for (std::size_t axis = 0; axis < 3; ++axis) nearby.offset[axis] -= points.place[axis];
    made.cells.push_back(nearby);
    for (const std::uint32_t slot : cell.slots)
      made.lists.insert(list, slot, PackedPosition(points.places[slot]));
  }
  return made;
}

TEST(NearKernel, PicksThePointsWithinReachWithAllInstructionSets) {
  std::size_t picked = 0;
  for (std::uint64_t seed = 0; seed < support::cases(2000); ++seed) {
    Random random(seed);
    const Points points = random_points(random);
    const auto reach = static_cast<float>(3 * random.uniform());
    const bool has_radii = seed % 2 == 0;
    std::vector<std::uint32_t> expected;
    bool is_close = false;  // to the reach, where rounding to single precision decides
    for (const Points::Cell& cell : points.cells) {
      for (const std::uint32_t slot : cell.slots) {
        const double apart = points.distance(cell, slot);
        const double beyond = apart - double{reach} - double{has_radii ? points.radii[slot] : 0};
        if (beyond < 0) expected.push_back(slot);
        is_close |= std::fabs(beyond) < 0x1p-21 * apart;
      }
    }
    if (is_close) continue;
    const Lists lists = lists_of(points);
    constexpr float kMargin = 0.125F;
    NearQuery query{
        .blocks = lists.lists.blocks(),
        .next = lists.lists.next(),
        .cells = lists.cells.data(),
        .count = lists.cells.size(),
        .unit = points.unit,
        // The margin belongs to the points.
        .reach = has_radii ? reach - kMargin : reach,
        .radii = has_radii ? points.radii.data() : nullptr,
        .margin = kMargin,
        .room = expected.size(),
    };
    for (const InstructionSet set : available_instruction_sets()) {
      std::vector<std::uint32_t> near(expected.size() + kWidestVector);
      ASSERT_EQ(kernels_of(set).pick_near(query, near.data()), expected.size()) << "seed " << seed;
      near.resize(expected.size());
      std::sort(near.begin(), near.end());
      ASSERT_EQ(near, expected) << "seed " << seed;
    }
    // What there is no room for is counted, and written nowhere.
    query.room /= 2;
    for (const InstructionSet set : available_instruction_sets()) {
      std::vector<std::uint32_t> near(query.room + kWidestVector + 1, 12345);
      ASSERT_EQ(kernels_of(set).pick_near(query, near.data()), expected.size());
      ASSERT_EQ(near.back(), 12345U);
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
    const std::array<std::array<std::int32_t, 3>, 2> places{random_place(random), random_place(random)};
    const std::array<std::int32_t, 3> between{1000, 0, -1010};
    Points points;
    for (float& unit : points.unit) unit = static_cast<float>((1 + random.uniform()) / 1024);
    points.place = places[0];
    points.places = {places[1]};
    const double step = random.uniform() < 0.5 ? 0x1p-23 : 0x1p-24;
    const double rounding = step * (std::floor(5 * random.uniform()) - 2);
    const double exact = points.distance({between, {}}, 0);
    for (const InstructionSet set : available_instruction_sets()) {
      const auto is_near = [&](std::size_t from, std::int32_t sign) {
        PointBlock block;
        block.slots[0] = 0;
        block.positions[0] = PackedPosition(places[1 - from]).bits();
        CellNearby cell{0, {}};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          cell.offset[axis] = sign * between[axis] - places[from][axis];
        }
        std::vector<std::uint32_t> near(1 + kWidestVector);
        const std::uint32_t none = PointBlock::kNone;
        const NearQuery query{.blocks = &block,
                              .next = &none,
                              .cells = &cell,
                              .count = 1,
                              .unit = points.unit,
                              .reach = static_cast<float>(exact * (1 + rounding)),
                              .radii = nullptr,
                              .margin = 0,
                              .room = 1};
        return kernels_of(set).pick_near(query, near.data());
      };
      ASSERT_EQ(is_near(0, 1), is_near(1, -1)) << "seed " << seed;
      near_ones += is_near(0, 1);
    }
  }
  const std::uint64_t queries = support::cases(20000) * available_instruction_sets().size();
  EXPECT_GT(near_ones, queries / 4);
  EXPECT_LT(near_ones, queries * 3 / 4);
}

TEST(ExcludeKernel, KeepsTheOthersInOrderWithAllInstructionSets) {
  for (std::uint64_t seed = 0; seed < support::cases(5000); ++seed) {
    Random random(seed);
    const auto some = [&](std::size_t most) {
      std::vector<std::uint32_t> slots(random.bits() % (most + 1));
      for (std::uint32_t& slot : slots) slot = static_cast<std::uint32_t>(random.bits() % 60);
      return slots;
    };
    std::vector<std::uint32_t> slots = some(100);
    const std::vector<std::uint32_t> excluded = some(20);
    std::vector<std::uint32_t> expected;
    std::ranges::copy_if(slots, std::back_inserter(expected),
                         [&](std::uint32_t slot) { return std::ranges::count(excluded, slot) == 0; });
    const std::size_t count = slots.size();
    slots.resize(count + kWidestVector, 7);
    for (const InstructionSet set : available_instruction_sets()) {
      std::vector<std::uint32_t> kept(count + kWidestVector);
      kept.resize(
          kernels_of(set).exclude(slots.data(), count, excluded.data(), excluded.size(), kept.data()));
      ASSERT_EQ(kept, expected) << "seed " << seed;
      std::vector<std::uint32_t> same = slots;
      same.resize(kernels_of(set).exclude(same.data(), count, excluded.data(), excluded.size(), same.data()));
      ASSERT_EQ(same, expected) << "seed " << seed;
    }
  }
}

TEST(DifferenceKernel, ComparesSetsWithAllInstructionSets) {
  constexpr std::uint32_t kSelf = 1000;
  for (std::uint64_t seed = 0; seed < support::cases(5000); ++seed) {
    Random random(seed);
    const std::size_t lanes = kWidestVector * (1 + random.bits() % (kMaxCompared / kWidestVector));
    std::vector<std::uint32_t> before(lanes, kSelf);
    std::set<std::uint32_t> old;
    std::set<std::uint32_t> now;
    for (std::uint32_t& lane : before) {
      const auto slot = static_cast<std::uint32_t>(random.bits() % 100);
      if (random.uniform() < 0.7 && old.insert(slot).second) lane = slot;
    }
    for (const std::uint32_t slot : old) {
      if (random.uniform() < 0.8) now.insert(slot);
    }
    while (random.uniform() < 0.8) now.insert(static_cast<std::uint32_t>(random.bits() % 100));
    const std::vector<std::uint32_t> new_ones(now.begin(), now.end());
    std::vector<std::uint32_t> expected_gained;
    std::vector<std::uint32_t> expected_lost;
    std::ranges::set_difference(now, old, std::back_inserter(expected_gained));
    std::ranges::set_difference(old, now, std::back_inserter(expected_lost));
    for (const InstructionSet set : available_instruction_sets()) {
      std::vector<std::uint32_t> gained(new_ones.size() + kWidestVector);
      std::vector<std::uint32_t> lost(lanes + kWidestVector);
      const Differences found = kernels_of(set).find_differences(before.data(), lanes, kSelf, new_ones.data(),
                                                                 new_ones.size(), gained.data(), lost.data());
      gained.resize(found.gained);
      lost.resize(found.lost);
      std::ranges::sort(lost);
      ASSERT_EQ(gained, expected_gained) << "seed " << seed;
      ASSERT_EQ(lost, expected_lost) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace hardball::kernels_test
