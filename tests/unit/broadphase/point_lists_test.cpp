// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/point_lists.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"

namespace hardball::point_lists_test {
namespace {

using Points = std::multimap<Slot, std::uint32_t>;

// What the kernel sees: the points of a list block by block, of which it asks for the second only if the
// first is full.
Points points_of(const PointLists& lists, std::uint32_t list, std::size_t* blocks = nullptr) {
  Points found;
  for (const std::uint32_t first = list; list != PointLists::kNone; list = lists.next()[list]) {
    const PointBlock& block = lists.blocks()[list];
    for (std::size_t lane = 0; lane < PointBlock::kRoom; ++lane) {
      if (block.slots[lane] != PointBlock::kNoSlot) found.emplace(block.slots[lane], block.positions[lane]);
    }
    if (blocks != nullptr) ++*blocks;
    if (list == first && found.size() < PointBlock::kRoom) return found;
  }
  return found;
}

// A place that tells whose it is.
PackedPosition position_of(Slot slot) {
  return PackedPosition({static_cast<std::int32_t>(slot), 1000 - static_cast<std::int32_t>(slot), 7});
}

TEST(PointLists, AgreeWithMultimapsUnderRandomTraffic) {
  PointLists lists;
  Random random(1);
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random.bits() % n); };
  for (const std::size_t count : {1U, 8U}) {
    lists.reset(count);
    std::vector<Points> known(count);
    std::size_t longest = 0;
    for (std::uint64_t step = 0; step < support::cases(40000); ++step) {
      // Fill up and empty in turn, all the way down.
      const bool filling = step / 1000 % 2 == 0;
      const auto chosen = static_cast<std::uint32_t>(below(count));
      Points& points = known[chosen];
      if (points.empty() || random.uniform() < (filling ? 0.8 : 0.2)) {
        const auto slot = static_cast<Slot>(below(30));
        lists.insert(chosen, slot, position_of(slot));
        points.emplace(slot, position_of(slot).bits());
      } else {
        const auto erased = std::next(points.begin(), static_cast<std::ptrdiff_t>(below(points.size())));
        lists.erase(chosen, erased->first);
        points.erase(erased);
      }
      for (std::uint32_t list = 0; list < count; ++list) {
        std::size_t blocks = 0;
        ASSERT_EQ(points_of(lists, list, &blocks), known[list]) << "step " << step;
        longest = std::max(longest, blocks);
      }
    }
    EXPECT_GT(longest, 3U);
  }
}

// Empty blocks do not stay in a chain.
TEST(PointLists, ReuseTheirMemory) {
  PointLists lists;
  lists.reset(3);
  std::size_t after_first = 0;
  for (std::uint32_t round = 0; round < 200; ++round) {
    const std::uint32_t list = round % 3;
    for (Slot slot = 0; slot < 100; ++slot) lists.insert(list, slot, {});
    for (Slot slot = 0; slot < 100; ++slot) lists.erase(list, round % 2 == 0 ? slot : 99 - slot);
    std::size_t blocks = 0;
    EXPECT_TRUE(points_of(lists, list, &blocks).empty());
    EXPECT_EQ(blocks, 1U);
    if (round == 0) after_first = lists.memory_bytes();
  }
  EXPECT_EQ(lists.memory_bytes(), after_first);
}

TEST(PointLists, StartOnACacheLine) {
  PointLists lists;
  lists.reset(100);
  for (std::uint32_t list = 0; list < 100; ++list) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(lists.blocks() + list) % 64, 0U);
  }
}

TEST(PointLists, NoticeThatASlotIsNotThere) {
  PointLists lists;
  lists.reset(2);
  EXPECT_THROW(lists.erase(0, 0), BrokenInvariant) << "unused places are filled with zeros";
  for (Slot slot = 1; slot < 40; ++slot) lists.insert(0, slot, {});
  EXPECT_THROW(lists.erase(0, 40), BrokenInvariant);
  EXPECT_THROW(lists.erase(1, 5), BrokenInvariant);
  EXPECT_NO_THROW(lists.erase(0, 39));
  EXPECT_THROW(lists.erase(0, 39), BrokenInvariant) << "it was there once";
}

}  // namespace
}  // namespace hardball::point_lists_test
