// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/neighbor_counts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "unit/theory/some_gas.hpp"

namespace hardball::neighbor_counts_test {
namespace {

using support::some_gas;

// What lists with the best skin do, if spheres that collide have `crowding` times as many neighbors as
// expected.
ListUse use_in_crowd(const GasStatistics& statistics, double crowding) {
  const NeighborCounts counts = expected_neighbor_counts(statistics, optimal_skin(statistics));
  return {std::max(16.0, crowding * counts.neighbors), counts.rebuild / counts.collision};
}

TEST(BetterSkin, IsNoneWhereListsAreAsExpected) {
  for (const double packing_fraction : {0.15, 0.25, 0.35, 0.45, 0.55}) {
    const GasStatistics statistics = some_gas(4000, packing_fraction, 0.5);
    EXPECT_FALSE(better_skin(statistics, optimal_skin(statistics), use_in_crowd(statistics, 1)));
  }
}

TEST(BetterSkin, IsSmallerInACrowd) {
  const GasStatistics statistics = some_gas(4000, 0.15, 0.5);
  const double skin = optimal_skin(statistics);
  ListUse use = use_in_crowd(statistics, 4);
  use.rebuilds /= 10;  // caged spheres rarely leave their balls
  const std::optional<double> better = better_skin(statistics, skin, use);
  ASSERT_TRUE(better);
  EXPECT_LT(*better, skin / 1.5);
}

TEST(BetterSkin, IsLargerWhereListsAreRebuiltOften) {
  const GasStatistics statistics = some_gas(4000, 0.25, 0.5);
  const double skin = optimal_skin(statistics);
  ListUse use = use_in_crowd(statistics, 1);
  use.rebuilds *= 20;
  const std::optional<double> better = better_skin(statistics, skin, use);
  ASSERT_TRUE(better);
  EXPECT_GT(*better, 1.5 * skin);
}

TEST(BetterSkin, NeedsMotion) {
  GasStatistics statistics = some_gas(4000, 0.25, 0.5);
  statistics.mean_speed = 0;
  EXPECT_FALSE(better_skin(statistics, 0.3, {50, 0}));
  EXPECT_FALSE(better_skin({}, 0.3, {50, 0}));
}

}  // namespace
}  // namespace hardball::neighbor_counts_test
