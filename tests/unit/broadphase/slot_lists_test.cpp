// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/slot_lists.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"

namespace hardball::slot_lists_test {
namespace {

std::multiset<Slot> slots_of(const SlotLists& lists, std::uint32_t list) {
  std::multiset<Slot> found;
  lists.for_each(list, [&found](Slot slot) { found.insert(slot); });
  return found;
}

// The slots of a list line by line, in no more lines than necessary.
std::multiset<Slot> slots_by_lines(const SlotLists& lists, std::uint32_t list) {
  std::multiset<Slot> found;
  std::size_t lines = 0;
  lists.for_each_line(list, [&](const SlotLists::LineOfSlots& slots, std::uint32_t count) {
    EXPECT_LE(count, SlotLists::kRoom);
    EXPECT_TRUE(count > 0 || lines == 0);
    found.insert(slots.begin(), slots.begin() + count);
    ++lines;
  });
  EXPECT_EQ(lines, std::max<std::size_t>(1, (found.size() + SlotLists::kRoom - 1) / SlotLists::kRoom));
  return found;
}

std::size_t lines_of(const SlotLists& lists, std::uint32_t list) {
  std::size_t lines = 0;
  lists.for_each_line(list, [&lines](const SlotLists::LineOfSlots&, std::uint32_t) { ++lines; });
  return lines;
}

TEST(SlotLists, AreEmptyAfterReset) {
  SlotLists lists;
  for (const std::size_t count : {3U, 0U, 20U}) {
    lists.reset(count);
    for (std::uint32_t list = 0; list < count; ++list) {
      EXPECT_TRUE(slots_of(lists, list).empty());
      for (Slot slot = 0; slot < 40; ++slot) lists.insert(list, slot);
    }
  }
}

TEST(SlotLists, ChainAsManyLinesAsTheyNeed) {
  SlotLists lists;
  lists.reset(2);
  lists.insert(1, 1000);
  std::multiset<Slot> expected;
  for (Slot slot = 0; slot < 100; ++slot) {
    lists.insert(0, slot);
    expected.insert(slot);
    ASSERT_EQ(slots_by_lines(lists, 0), expected);
    ASSERT_EQ(lines_of(lists, 0), slot / SlotLists::kRoom + 1);
  }
  // Emptied in the order of insertion.
  for (Slot slot = 0; slot < 100; ++slot) {
    lists.erase(0, slot);
    expected.erase(slot);
    ASSERT_EQ(slots_by_lines(lists, 0), expected);
  }
  EXPECT_EQ(slots_of(lists, 1), std::multiset<Slot>{1000});
}

TEST(SlotLists, FirstLineIsAPartOfTheList) {
  SlotLists lists;
  lists.reset(1);
  for (Slot slot = 0; slot < 30; ++slot) {
    lists.insert(0, slot);
    std::vector<Slot> first(SlotLists::kRoom);
    const std::uint32_t count = lists.copy_first(0, first.data());
    ASSERT_EQ(count, std::min(slot + 1, SlotLists::kRoom));
    for (std::uint32_t i = 0; i < count; ++i) ASSERT_TRUE(slots_of(lists, 0).contains(first[i]));
  }
}

// Slots may be in a list several times.
TEST(SlotLists, AgreeWithMultisetsUnderRandomTraffic) {
  SlotLists lists;
  Random random(1);
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random.bits() % n); };
  for (const std::size_t count : {1U, 8U}) {
    lists.reset(count);
    std::vector<std::multiset<Slot>> known(count);
    std::size_t longest = 0;
    for (std::uint64_t step = 0; step < support::cases(40000); ++step) {
      // Fill up and empty in turn, all the way down.
      const bool filling = step / 1000 % 2 == 0;
      const auto chosen = static_cast<std::uint32_t>(below(count));
      std::multiset<Slot>& slots = known[chosen];
      if (slots.empty() || random.uniform() < (filling ? 0.8 : 0.2)) {
        const auto slot = static_cast<Slot>(below(30));
        lists.insert(chosen, slot);
        slots.insert(slot);
      } else {
        const auto erased = std::next(slots.begin(), static_cast<std::ptrdiff_t>(below(slots.size())));
        lists.erase(chosen, *erased);
        slots.erase(erased);
      }
      for (std::uint32_t list = 0; list < count; ++list) {
        ASSERT_EQ(slots_by_lines(lists, list), known[list]) << "step " << step;
        longest = std::max(longest, lines_of(lists, list));
      }
    }
    EXPECT_GT(longest, 3U);
  }
}

TEST(SlotLists, ReuseTheirMemory) {
  SlotLists lists;
  lists.reset(10);
  std::size_t after_first = 0;
  for (int round = 0; round < 200; ++round) {
    for (std::uint32_t list = 0; list < 10; ++list) {
      for (Slot slot = 0; slot < 100; ++slot) lists.insert(list, slot);
    }
    for (std::uint32_t list = 0; list < 10; ++list) {
      for (Slot slot = 0; slot < 100; ++slot) lists.erase(list, slot);
    }
    if (round == 0) after_first = lists.memory_bytes();
  }
  EXPECT_EQ(lists.memory_bytes(), after_first);
}

TEST(SlotLists, StartOnACacheLine) {
  SlotLists lists;
  lists.reset(100);
  for (std::uint32_t list = 0; list < 100; ++list) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(lists.address(list)) % 64, 0U);
  }
}

TEST(SlotLists, NoticeThatASlotIsNotThere) {
  SlotLists lists;
  lists.reset(2);
  EXPECT_THROW(lists.erase(0, 0), BrokenInvariant) << "unused places are filled with zeros";
  for (Slot slot = 1; slot < 40; ++slot) lists.insert(0, slot);
  EXPECT_THROW(lists.erase(0, 40), BrokenInvariant);
  EXPECT_THROW(lists.erase(1, 5), BrokenInvariant);
  EXPECT_NO_THROW(lists.erase(0, 39));
  EXPECT_THROW(lists.erase(0, 39), BrokenInvariant) << "it was there once";
}

}  // namespace
}  // namespace hardball::slot_lists_test
