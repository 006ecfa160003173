// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/engine/bound_watch.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace hardball::bound_watch_test {
namespace {

// Predictions of which one in `every` is ambiguous; returns how many were bounded.
std::uint64_t bounded(BoundWatch& watch, std::uint64_t predictions, std::uint64_t every) {
  std::uint64_t count = 0;
  for (std::uint64_t i = 0; i < predictions; ++i) {
    if (!watch.pays()) {
      watch.note_exact();
      continue;
    }
    watch.note_bounded();
    if (++count % every == 0) watch.note_ambiguous();
  }
  return count;
}

constexpr std::uint64_t kMany = 1000000;

TEST(BoundWatch, LetsBoundsPayWhileFewAreAmbiguous) {
  BoundWatch watch;
  EXPECT_EQ(bounded(watch, kMany, kMany), kMany);
  EXPECT_EQ(bounded(watch, kMany, 4), kMany);
}

TEST(BoundWatch, TriesBoundsNowAndThenIfMostAreAmbiguous) {
  BoundWatch watch;
  const std::uint64_t tried = bounded(watch, kMany, 1);
  EXPECT_GT(tried, kMany / 50);
  EXPECT_LT(tried, kMany / 20);
}

TEST(BoundWatch, ReturnsToBoundsWhenTheyTellAgain) {
  BoundWatch watch;
  bounded(watch, kMany, 1);
  bounded(watch, kMany, kMany);
  EXPECT_EQ(bounded(watch, kMany, kMany), kMany);
}

}  // namespace
}  // namespace hardball::bound_watch_test
