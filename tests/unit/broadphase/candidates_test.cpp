// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/candidates.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"

namespace hardball::candidates_test {
namespace {

void expect_padding(const Candidates& candidates) {
  for (std::size_t i = 0; i < Candidates::kPadding; ++i) {
    EXPECT_EQ(candidates.slots()[candidates.size() + i], candidates.self());
  }
}

TEST(Candidates, AreEmptyAfterBeginAndPaddedAfterEnd) {
  Candidates candidates;
  for (const Slot self : {0U, 5U, 4000000000U}) {
    for (const bool nearest : {true, false}) {
      candidates.begin(self, nearest);
      candidates.end();
      EXPECT_EQ(candidates.self(), self);
      EXPECT_EQ(candidates.uses_minimum_image(), nearest);
      EXPECT_EQ(candidates.size(), 0U);
      expect_padding(candidates);
    }
  }
}

TEST(Candidates, KeepTheOrderInWhichTheyWereAddedAndArePadded) {
  for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 55U, 56U, 57U, 64U, 1000U}) {
    Candidates candidates;
    candidates.begin(3, true);
    for (std::size_t i = 0; i < count; ++i) candidates.add(static_cast<Slot>(10 + 7 * i));
    candidates.end();
    ASSERT_EQ(candidates.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_EQ(candidates.slot(i), 10 + 7 * i);
      ASSERT_EQ(candidates.slots()[i], 10 + 7 * i);
    }
    expect_padding(candidates);
  }
}

TEST(Candidates, AddTheFirstOfALineInItsOrder) {
  Candidates candidates;
  SlotLists::LineOfSlots line;
  for (std::uint32_t i = 0; i < line.size(); ++i) line[i] = 100 + i;
  for (std::uint32_t count = 0; count <= line.size(); ++count) {
    candidates.begin(5, true);
    for (Slot before = 0; before < 60; ++before) {
      // Lines may end at the end of the arrays.
      candidates.add(before);
      candidates.add(line, count);
    }
    candidates.end();
    ASSERT_EQ(candidates.size(), 60 * (1 + count));
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const std::size_t place = i % (1 + count);
      ASSERT_EQ(candidates.slot(i), place == 0 ? i / (1 + count) : 99 + place);
    }
    expect_padding(candidates);
  }
}

TEST(Candidates, MarksAreForgottenInTheNextRound) {
  Candidates candidates;
  for (int round = 0; round < 1000; ++round) {
    candidates.begin(9, false);
    candidates.start_round(6);
    EXPECT_FALSE(candidates.is_new(9)) << "the sphere itself";
    for (const Slot slot : {1U, 2U, 3U}) {
      EXPECT_TRUE(candidates.is_new(slot));
      candidates.mark(slot);
      EXPECT_FALSE(candidates.is_new(slot));
    }
  }
}

TEST(Candidates, MarkDistinguishesSpheresThatShareAnEntry) {
  Candidates candidates;
  candidates.begin(0, false);
  candidates.mark(5);
  EXPECT_FALSE(candidates.is_new(5));
  EXPECT_TRUE(candidates.is_new(5 + 256));
  candidates.mark(5 + 256);
  EXPECT_FALSE(candidates.is_new(5 + 256));
}

TEST(Candidates, ListedImagesAndShiftsAgree) {
  Random random(2);
  const Box box({Boundary::periodic, Boundary::wall, Boundary::periodic}, {10, 7, 3});
  Candidates candidates;
  for (std::uint64_t round = 0; round < support::cases(300); ++round) {
    candidates.begin(2, false);
    std::vector<std::pair<Slot, Image>> expected(random.bits() % 200);
    for (auto& [slot, image] : expected) {
      slot = 3 + static_cast<Slot>(random.bits() % 50);
      image[0] = static_cast<std::int32_t>(random.bits() % 5) - 2;
      image[2] = static_cast<std::int32_t>(random.bits() % 5) - 2;
      candidates.add(slot, image, box);
    }
    candidates.end();
    ASSERT_FALSE(candidates.uses_minimum_image());
    ASSERT_EQ(candidates.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_EQ(candidates.slot(i), expected[i].first);
      ASSERT_EQ(candidates.image(i), expected[i].second);
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        ASSERT_EQ(candidates.shifts(axis)[i], box.shift(expected[i].second)[axis]);
      }
    }
    expect_padding(candidates);
    // A round without images in between.
    candidates.begin(1, true);
    for (Slot slot = 2; slot < 400; ++slot) candidates.add(slot);
    candidates.end();
  }
}

// Rounds are counted in 32 bits, which overflow after an hour of events: an old mark must not hide a new
// candidate.
TEST(Candidates, LoseNoneWhenTheCountOfRoundsOverflows) {
  constexpr std::uint32_t kLast = std::numeric_limits<std::uint32_t>::max();
  for (const std::uint32_t rounds : {kLast - 1, kLast}) {
    Candidates candidates(rounds);
    for (int round = 0; round < 4; ++round) {
      candidates.begin(7, false);
      candidates.start_round(2);
      for (const Slot slot : {0U, 1U}) {
        EXPECT_TRUE(candidates.is_new(slot)) << "round " << round;
        candidates.mark(slot);
        EXPECT_FALSE(candidates.is_new(slot));
      }
    }
  }
}

}  // namespace
}  // namespace hardball::candidates_test
