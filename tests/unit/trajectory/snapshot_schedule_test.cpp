// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/snapshot_schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace hardball::snapshot_schedule_test {
namespace {

TEST(SnapshotSchedule, NeverSamplesUnlessAsked) {
  EXPECT_TRUE(SnapshotSchedule().is_never());
  EXPECT_EQ(SnapshotSchedule().time(0), SnapshotSchedule::kNoTime);
  EXPECT_EQ(SnapshotSchedule().contacts(0), SnapshotSchedule::kNoContacts);
}

TEST(SnapshotSchedule, IsLinear) {
  const SnapshotSchedule schedule = SnapshotSchedule::every(0.1);
  EXPECT_EQ(schedule.time(0), 0);
  EXPECT_EQ(schedule.time(7), 7 * 0.1);
  EXPECT_EQ(schedule.contacts(7), SnapshotSchedule::kNoContacts);
}

TEST(SnapshotSchedule, TakesTimesThatRoundingPutsPastTheEndForTheEnd) {
  const SnapshotSchedule schedule = SnapshotSchedule::every(0.1);
  ASSERT_GT(3 * 0.1, 0.3);
  EXPECT_EQ(schedule.time(3, 0.3), 0.3);
  EXPECT_GT(schedule.time(4, 0.3), 0.3);
}

TEST(SnapshotSchedule, IsEvenInTheLogarithmOfTime) {
  for (const std::uint64_t per_decade : {1U, 3U, 10U, 1000U}) {
    const SnapshotSchedule schedule = SnapshotSchedule::logarithmic(0.001, per_decade);
    EXPECT_EQ(schedule.time(0), 0);
    EXPECT_EQ(schedule.time(1), 0.001);
    // Decades are exact.
    EXPECT_EQ(schedule.time(1 + 3 * per_decade), 0.001 * 1000);
    EXPECT_EQ(schedule.time(1 + 9 * per_decade), 0.001 * 1e9);
    for (std::uint64_t k = 1; k <= 4 * per_decade; ++k) {
      EXPECT_LT(schedule.time(k - 1), schedule.time(k));
      const double expected =
          0.001 * std::pow(10, static_cast<double>(k - 1) / static_cast<double>(per_decade));
      EXPECT_NEAR(schedule.time(k) / expected, 1, 1e-12);
    }
  }
}

TEST(SnapshotSchedule, EndsWhereTimesOverflow) {
  const SnapshotSchedule schedule = SnapshotSchedule::logarithmic(1, 1);
  EXPECT_EQ(schedule.time(1'000'000'000'000), SnapshotSchedule::kNoTime);
}

TEST(SnapshotSchedule, CountsContacts) {
  const SnapshotSchedule schedule = SnapshotSchedule::every_contacts(1000);
  EXPECT_EQ(schedule.contacts(0), 0U);
  EXPECT_EQ(schedule.contacts(3), 3000U);
  EXPECT_EQ(schedule.time(3), SnapshotSchedule::kNoTime);
  EXPECT_EQ(schedule.contacts(SnapshotSchedule::kNoContacts / 10), SnapshotSchedule::kNoContacts);
}

}  // namespace
}  // namespace hardball::snapshot_schedule_test
