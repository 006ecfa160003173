// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/padded_lists.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/kernels/instruction_set.hpp"
#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"

namespace hardball::padded_lists_test {
namespace {

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
    for (std::uint64_t step = 0; step < support::cases(3000); ++step) {
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
  for (std::uint64_t step = 0; step < support::cases(2000); ++step) {
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
}  // namespace hardball::padded_lists_test
