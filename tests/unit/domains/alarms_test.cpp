// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/alarms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "hardball/numbers/random.hpp"

namespace hardball::alarms_test {
namespace {

Alarms::Alarm alarm(Slot slot, double time) {
  return {.time = time, .slot = slot, .path = Time(0)};
}

std::vector<Slot> taken_by(Alarms& alarms, double until) {
  std::vector<Alarms::Alarm> taken;
  alarms.take(until, taken);
  std::vector<Slot> slots;
  for (const Alarms::Alarm& each : taken) slots.push_back(each.slot);
  std::ranges::sort(slots);
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
  return slots;
}

TEST(Alarms, AreTakenOnceWhenTheyAreDue) {
  Alarms alarms;
  alarms.restart(0, 10);
  alarms.set(alarm(0, 5));
  alarms.set(alarm(1, 1));
  alarms.set(alarm(2, 5.001));
  EXPECT_EQ(taken_by(alarms, 0.5), std::vector<Slot>{});
  EXPECT_EQ(taken_by(alarms, 5), (std::vector<Slot>{0, 1}));
  EXPECT_EQ(taken_by(alarms, 10), std::vector<Slot>{2});
  EXPECT_EQ(taken_by(alarms, 10), std::vector<Slot>{});
}

TEST(Alarms, AreSetUpToNoTimeBeforeTheFirstStart) {
  EXPECT_LT(Alarms().horizon(), std::numeric_limits<double>::lowest());
}

TEST(Alarms, OfASphereAreAsEarlyAsTheFirst) {
  Alarms alarms;
  alarms.restart(0, 10);
  alarms.set(alarm(0, 3));
  alarms.set(alarm(0, 8));
  EXPECT_EQ(taken_by(alarms, 4), std::vector<Slot>{0});
  EXPECT_EQ(taken_by(alarms, 10), std::vector<Slot>{}) << "whoever takes an alarm sets the next";
  alarms.set(alarm(1, 9.5));
  alarms.restart(10, 20);
  alarms.set(alarm(1, 18));
  alarms.set(alarm(1, 12));
  EXPECT_EQ(taken_by(alarms, 13), std::vector<Slot>{1});
  EXPECT_EQ(taken_by(alarms, 20), std::vector<Slot>{}) << "the later one no longer counts";
}

// No sphere is looked at too late, whatever is set, taken and set again; against the least time
// that was set for each.
TEST(Alarms, AreNeverLate) {
  constexpr Slot kSlots = 40;
  constexpr double kHorizon = 100;
  Random random(1);
  Alarms alarms;
  alarms.restart(0, kHorizon);
  std::vector<double> due(kSlots, 2 * kHorizon);
  double now = 0;
  while (now < kHorizon) {
    for (int k = 0; k < 30; ++k) {
      const auto slot = static_cast<Slot>(random.uniform() * kSlots);
      const double time = now + random.uniform() * random.uniform() * (kHorizon - now);
      alarms.set(alarm(slot, time));
      due[slot] = std::min(due[slot], time);
    }
    now = std::min(now + random.uniform(), kHorizon);
    for (const Slot slot : taken_by(alarms, now)) due[slot] = 2 * kHorizon;
    for (Slot slot = 0; slot < kSlots; ++slot) ASSERT_GT(due[slot], now) << slot;
  }
}

}  // namespace
}  // namespace hardball::alarms_test
