// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The lists of slots that broad phases keep: each holds what was inserted and not erased.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <span>
#include <vector>

#include "hardball/broadphase/padded_lists.hpp"
#include "hardball/broadphase/point_lists.hpp"
#include "hardball/broadphase/slot_lists.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/kernels/instruction_set.hpp"
#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"

namespace hardball::slot_lists_test {
namespace {

using namespace support;

// A list as a kernel sees it, and of how many lines or blocks it consists.
struct Seen {
  std::multiset<Slot> slots;
  std::size_t parts = 0;
};

struct OfSlots : SlotLists {
  // Line by line, in no more lines than necessary.
  Seen seen(std::uint32_t list) const {
    Seen seen;
    for_each_line(list, [&](const LineOfSlots& slots, std::uint32_t count) {
      EXPECT_LE(count, kRoom);
      EXPECT_TRUE(count > 0 || seen.parts == 0);
      seen.slots.insert(slots.begin(), slots.begin() + count);
      ++seen.parts;
    });
    EXPECT_EQ(seen.parts, std::max<std::size_t>(1, (seen.slots.size() + kRoom - 1) / kRoom));
    std::multiset<Slot> one_by_one;
    for_each(list, [&](Slot slot) { one_by_one.insert(slot); });
    EXPECT_EQ(one_by_one, seen.slots);
    return seen;
  }
  const void* place(std::uint32_t list) const { return address(list); }
};

struct OfPoints : PointLists {
  // A place that tells whose it is.
  static PackedPosition position_of(Slot slot) {
    return PackedPosition({static_cast<std::int32_t>(slot), 1000 - static_cast<std::int32_t>(slot), 7});
  }
  void insert(std::uint32_t list, Slot slot) { PointLists::insert(list, slot, position_of(slot)); }
  // Block by block; the kernel asks for the second only if the first is full.
  Seen seen(std::uint32_t list) const {
    Seen seen;
    for (const std::uint32_t first = list; list != kNone; list = next()[list]) {
      const PointBlock& block = blocks()[list];
      for (std::size_t lane = 0; lane < PointBlock::kRoom; ++lane) {
        if (block.slots[lane] == PointBlock::kNoSlot) continue;
        seen.slots.insert(block.slots[lane]);
        EXPECT_EQ(block.positions[lane], position_of(block.slots[lane]).bits());
      }
      ++seen.parts;
      if (list == first && seen.slots.size() < PointBlock::kRoom) break;
    }
    return seen;
  }
  const void* place(std::uint32_t list) const { return blocks() + list; }
};

template <class Kind>
class Lists : public testing::Test {};

using Kinds = testing::Types<OfSlots, OfPoints>;
TYPED_TEST_SUITE(Lists, Kinds);

// Slots may be in a list several times.
TYPED_TEST(Lists, AgreeWithMultisetsUnderRandomTraffic) {
  TypeParam lists;
  Random random(1);
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random.bits() % n); };
  for (const std::size_t count : {1U, 8U}) {
    lists.reset(count);
    std::vector<std::multiset<Slot>> known(count);
    std::size_t longest = 0;
    for (std::uint64_t step = 0; step < cases(40000); ++step) {
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
        const Seen seen = lists.seen(list);
        ASSERT_EQ(seen.slots, known[list]) << "step " << step;
        longest = std::max(longest, seen.parts);
      }
    }
    EXPECT_GT(longest, 3U);
  }
}

// Empty blocks do not stay in a chain.
TYPED_TEST(Lists, ReuseTheirMemory) {
  TypeParam lists;
  lists.reset(10);
  std::size_t after_first = 0;
  for (int round = 0; round < 200; ++round) {
    for (std::uint32_t list = 0; list < 10; ++list) {
      for (Slot slot = 0; slot < 100; ++slot) lists.insert(list, slot);
    }
    for (std::uint32_t list = 0; list < 10; ++list) {
      for (Slot slot = 0; slot < 100; ++slot) lists.erase(list, round % 2 == 0 ? slot : 99 - slot);
      const Seen seen = lists.seen(list);
      EXPECT_TRUE(seen.slots.empty());
      EXPECT_EQ(seen.parts, 1U);
    }
    if (round == 0) after_first = lists.memory_bytes();
  }
  EXPECT_EQ(lists.memory_bytes(), after_first);
}

TYPED_TEST(Lists, StartOnACacheLine) {
  TypeParam lists;
  lists.reset(100);
  for (std::uint32_t list = 0; list < 100; ++list) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(lists.place(list)) % 64, 0U);
  }
}

TYPED_TEST(Lists, NoticeThatASlotIsNotThere) {
  TypeParam lists;
  lists.reset(2);
  EXPECT_THROW(lists.erase(0, 0), BrokenInvariant) << "unused places are filled with zeros";
  for (Slot slot = 1; slot < 40; ++slot) lists.insert(0, slot);
  EXPECT_THROW(lists.erase(0, 40), BrokenInvariant);
  EXPECT_THROW(lists.erase(1, 5), BrokenInvariant);
  EXPECT_NO_THROW(lists.erase(0, 39));
  EXPECT_THROW(lists.erase(0, 39), BrokenInvariant) << "it was there once";
}

TYPED_TEST(Lists, AreEmptyAfterReset) {
  TypeParam lists;
  for (const std::size_t count : {3U, 0U, 20U}) {
    lists.reset(count);
    for (std::uint32_t list = 0; list < count; ++list) {
      EXPECT_TRUE(lists.seen(list).slots.empty());
      for (Slot slot = 0; slot < 40; ++slot) lists.insert(list, slot);
    }
  }
}

TEST(SlotLists, ChainAsManyLinesAsTheyNeed) {
  OfSlots lists;
  lists.reset(2);
  lists.insert(1, 1000);
  std::multiset<Slot> expected;
  for (Slot slot = 0; slot < 100; ++slot) {
    lists.insert(0, slot);
    expected.insert(slot);
    ASSERT_EQ(lists.seen(0).slots, expected);
    ASSERT_EQ(lists.seen(0).parts, slot / SlotLists::kRoom + 1);
  }
  // Emptied in the order of insertion.
  for (Slot slot = 0; slot < 100; ++slot) {
    lists.erase(0, slot);
    expected.erase(slot);
    ASSERT_EQ(lists.seen(0).slots, expected);
  }
  EXPECT_EQ(lists.seen(1).slots, std::multiset<Slot>{1000});
}

TEST(SlotLists, FirstLineIsAPartOfTheList) {
  OfSlots lists;
  lists.reset(1);
  for (Slot slot = 0; slot < 30; ++slot) {
    lists.insert(0, slot);
    std::vector<Slot> first(SlotLists::kRoom);
    const std::uint32_t count = lists.copy_first(0, first.data());
    ASSERT_EQ(count, std::min(slot + 1, SlotLists::kRoom));
    for (std::uint32_t i = 0; i < count; ++i) ASSERT_TRUE(lists.seen(0).slots.contains(first[i]));
  }
}

// Lists beside plain vectors.
struct Both {
  Both(Slot owners, std::uint32_t lines) : plain(owners) { lists.reset(owners, lines); }

  void insert(Slot owner, Slot slot) {
    lists.insert(owner, slot);
    plain[owner].push_back(slot);
  }
  void erase(Slot owner, Slot slot) {
    lists.erase(owner, slot);
    plain[owner].erase(std::find(plain[owner].begin(), plain[owner].end(), slot));
  }
  void assign(Slot owner, const std::vector<Slot>& slots) {
    lists.assign(owner, slots);
    plain[owner] = slots;
  }

  void expect_same() const {
    for (Slot owner = 0; owner < plain.size(); ++owner) {
      ASSERT_EQ(lists.size(owner), plain[owner].size());
      const std::span<const Slot> lanes = lists.of(owner);
      ASSERT_EQ(lanes.size() % kWidestVector, 0U);
      std::vector<Slot> slots(lanes.begin(), lanes.end());
      std::erase(slots, owner);
      ASSERT_EQ(slots.size(), plain[owner].size());
      ASSERT_TRUE(std::is_permutation(slots.begin(), slots.end(), plain[owner].begin()));
    }
  }

  PaddedLists lists;
  std::vector<std::vector<Slot>> plain;
};

class PaddedListsOfLines : public testing::TestWithParam<std::uint32_t> {};

TEST_P(PaddedListsOfLines, HoldWhatWasInsertedAndNotErased) {
  constexpr Slot kOwners = 20;
  Random random(1);
  Both both(kOwners, GetParam());
  // They grow through several sizes of blocks.
  for (const double growing : {0.9, 0.1, 0.7, 0.2, 0.6, 0.0}) {
    for (std::uint64_t step = 0; step < cases(3000); ++step) {
      const auto owner = static_cast<Slot>(random.bits() % kOwners);
      if (random.uniform() < growing) {
        both.insert(owner, static_cast<Slot>(1000 + random.bits() % 100000));
      } else if (!both.plain[owner].empty()) {
        both.erase(owner, both.plain[owner][random.bits() % both.plain[owner].size()]);
      }
      if (step % 50 == 0) both.expect_same();
      if (HasFatalFailure()) return;
    }
    both.expect_same();
  }
}

TEST_P(PaddedListsOfLines, AreReplacedByListsOfAnyLength) {
  constexpr Slot kOwners = 5;
  Random random(2);
  Both both(kOwners, GetParam());
  for (std::uint64_t step = 0; step < cases(2000); ++step) {
    std::vector<Slot> slots(random.bits() % (step % 3 == 0 ? 200 : 20));
    for (Slot& slot : slots) slot = static_cast<Slot>(100 + random.bits() % 1000);
    both.assign(static_cast<Slot>(random.bits() % kOwners), slots);
    both.expect_same();
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Lines, PaddedListsOfLines, testing::Values(1, 2));

// Replacing a list gives its block back.
TEST(PaddedLists, UseABlockAgain) {
  PaddedLists lists;
  lists.reset(2);
  std::size_t bytes = 0;
  for (int round = 0; round < 10; ++round) {
    for (Slot slot = 2; slot < 100; ++slot) lists.insert(0, slot);
    if (round == 0) bytes = lists.memory_bytes();
    EXPECT_EQ(lists.memory_bytes(), bytes);
    lists.assign(0, {});
    EXPECT_EQ(lists.size(0), 0U);
  }
}

TEST(PaddedLists, NoticeThatASlotIsMissing) {
  PaddedLists lists;
  lists.reset(1);
  lists.insert(0, 7);
  EXPECT_THROW(lists.erase(0, 8), BrokenInvariant);
}

}  // namespace
}  // namespace hardball::slot_lists_test
