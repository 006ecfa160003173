// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/padded_lists.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/kernels/instruction_set.hpp"
#include "hardball/world/random.hpp"
#include "support/effort.hpp"

namespace hardball::padded_lists_test {
namespace {

// Lists and their lengths, beside plain vectors.
struct Both {
  explicit Both(Slot owners) : lengths(owners), plain(owners) { lists.reset(owners); }

  void insert(Slot owner, Slot slot) {
    lists.insert(owner, lengths[owner], slot);
    plain[owner].push_back(slot);
  }
  void erase(Slot owner, Slot slot) {
    lists.erase(owner, lengths[owner], slot);
    plain[owner].erase(std::find(plain[owner].begin(), plain[owner].end(), slot));
  }
  void assign(Slot owner, const std::vector<Slot>& slots) {
    lists.assign(owner, lengths[owner], slots);
    plain[owner] = slots;
  }

  void expect_same() const {
    for (Slot owner = 0; owner < plain.size(); ++owner) {
      const std::uint32_t length = lengths[owner];
      ASSERT_EQ(length, plain[owner].size());
      const Slot* const slots = lists.slots(owner, length);
      ASSERT_TRUE(std::is_permutation(slots, slots + length, plain[owner].begin()));
      // Kernels read whole vectors.
      for (std::uint32_t i = length; i % kWidestVector != 0; ++i) ASSERT_EQ(slots[i], owner);
    }
  }

  PaddedLists lists;
  std::vector<std::uint32_t> lengths;
  std::vector<std::vector<Slot>> plain;
};

TEST(PaddedLists, HoldWhatWasInsertedAndNotErased) {
  constexpr Slot kOwners = 20;
  Random random(1);
  Both both(kOwners);
  // They grow and shrink through several sizes of blocks.
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

TEST(PaddedLists, AreReplacedByListsOfAnyLength) {
  constexpr Slot kOwners = 5;
  Random random(2);
  Both both(kOwners);
  for (std::uint64_t step = 0; step < support::cases(2000); ++step) {
    std::vector<Slot> slots(random.bits() % (step % 3 == 0 ? 200 : 20));
    for (Slot& slot : slots) slot = static_cast<Slot>(100 + random.bits() % 1000);
    both.assign(static_cast<Slot>(random.bits() % kOwners), slots);
    both.expect_same();
    if (HasFatalFailure()) return;
  }
}

TEST(PaddedLists, UseABlockAgain) {
  PaddedLists lists;
  lists.reset(2);
  std::uint32_t length = 0;
  std::size_t bytes = 0;
  for (int round = 0; round < 10; ++round) {
    for (Slot slot = 0; slot < 100; ++slot) lists.insert(0, length, slot);
    if (round == 0) bytes = lists.memory_bytes();
    EXPECT_EQ(lists.memory_bytes(), bytes);
    for (Slot slot = 0; slot < 100; ++slot) lists.erase(0, length, slot);
  }
}

TEST(PaddedLists, NoticeThatASlotIsMissing) {
  PaddedLists lists;
  lists.reset(1);
  std::uint32_t length = 0;
  lists.insert(0, length, 7);
  EXPECT_THROW(lists.erase(0, length, 8), BrokenInvariant);
}

}  // namespace
}  // namespace hardball::padded_lists_test
