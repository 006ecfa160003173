// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// After a billion mean free times gaps are resolved as well as in the first.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "hardball/broadphase/cell_grid.hpp"
#include "hardball/engine/engine.hpp"
#include "hardball/events/calendar_queue.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/gas.hpp"
#include "support/record.hpp"
#include "support/theory.hpp"

namespace hardball::precision_test {
namespace {

// How precisely spheres touch at contacts.
struct Gaps {
  std::uint64_t contacts = 0;
  double sum = 0;  ///< Sum of |distance / reach - 1|.
  double largest = 0;
  double blur_sum = 0;              ///< What the gaps would be if moments were rounded to one double.
  std::vector<double> since_start;  ///< [T]

  void record(const Contact& contact, const Time& start) {
    ++contacts;
    const double gap = std::fabs(contact.overlap());
    sum += gap;
    largest = std::max(largest, gap);
    // A clock of one double would drop the low part: the spheres would be placed where they are that much
    // earlier.
    blur_sum += contact.impact_speed() * std::fabs(contact.time.low) / contact.reach;
    since_start.push_back(duration(start, contact.time));
  }
  double mean() const { return sum / static_cast<double>(contacts); }
  double blur() const { return blur_sum / static_cast<double>(contacts); }
};

constexpr double kPacking = 0.3;
constexpr std::uint64_t kContacts = 20000;

// A gas that is at rest until `start` and is then set in motion.
Gaps gaps_of_gas_started_at(double start) {
  const World moving = support::make_gas({.count = 500, .packing_fraction = kPacking, .seed = 91});
  World resting(moving.box());
  for (const Path& path : moving.paths()) {
    resting.add({.position = path.position, .radius = support::kDiameter / 2});
  }
  Simulation simulation(resting);
  simulation.run_until(start);
  for (SphereId id = 0; id < simulation.size(); ++id)
    simulation.change_velocity(id, moving.path(id).velocity);
  Gaps gaps;
  simulation.on_contact([&](const Contact& contact) { gaps.record(contact, Time(start)); });
  simulation.run_contacts(kContacts);
  return gaps;
}

double mean_free_time() {
  return 1 / support::collision_rate(support::fluid_compressibility(kPacking));
}

TEST(AfterABillionMeanFreeTimes, GapsAtContactAreAsSmallAsInTheFirst) {
  const double late = 1e9 * mean_free_time();
  const Gaps first = gaps_of_gas_started_at(0);
  const Gaps later = gaps_of_gas_started_at(late);
  ASSERT_EQ(first.contacts, kContacts);
  ASSERT_EQ(later.contacts, kContacts);
  support::record("mean_gap_at_first", first.mean());
  support::record("mean_gap_later", later.mean());
  support::record("largest_gap_later", later.largest);
  support::record("mean_gap_with_a_double_clock", later.blur());
  // Positions in a box of ten are multiples of 2^-50 or less, about 1e-15, and enter a distance six
  // times.
  EXPECT_LT(first.mean(), 2e-15);
  EXPECT_LT(first.largest, 4e-14);
  // The gas is the same but for rounding: the mean gaps agree to 1 / sqrt(kContacts), below 1%.
  EXPECT_NEAR(later.mean() / first.mean(), 1, 0.1);
  EXPECT_LT(later.largest, 4e-14);
  // The contrast: a double near 1e8 is known to 7e-9, half an interval of 1.5e-8; half of that on average,
  // at a mean impact speed of sqrt(pi), makes gaps of 7e-9, ten million times as large.
  const double interval = std::nextafter(late, std::numeric_limits<double>::infinity()) - late;
  EXPECT_NEAR(later.blur() / (std::sqrt(std::numbers::pi) * interval / 4), 1, 0.05);
  EXPECT_GT(later.blur(), 1e6 * later.mean());
}

// The motion is the same until differences in rounding have grown: for a sphere's first few collisions.
TEST(AfterABillionMeanFreeTimes, TheMotionIsTheSameAsFromTimeZero) {
  const Gaps first = gaps_of_gas_started_at(0);
  const Gaps later = gaps_of_gas_started_at(1e9 * mean_free_time());
  constexpr std::size_t kCompared = 500;  // two collisions per sphere
  for (std::size_t i = 0; i < kCompared; ++i) {
    EXPECT_NEAR(first.since_start[i], later.since_start[i], 1e-12) << "contact " << i;
  }
}

// An engine by itself can start at any moment, such as 2^40, about 1e12, where doubles are 2.4e-4 apart. The
// box is small, the mean free time of its two spheres about one.
TEST(AnEngineStartedLate, MeetsContactsAsWellAsOneStartedAtZero) {
  const auto gaps_from = [](const Time& start) {
    World world(Box::walls({4, 4, 4}));
    world.add({.position = {1, 1.25, 1.5}, .velocity = {1.1, -0.7, 0.6}, .radius = 0.75}, start);
    world.add({.position = {3, 2.5, 2.75}, .velocity = {-0.8, 0.9, -1.2}, .radius = 0.75}, start);
    Engine<CalendarQueue> engine(world, {PhaseKind::cells, 1.5}, start);
    Gaps gaps;
    engine.run({.contacts = kContacts}, [&](const Contact& contact) { gaps.record(contact, start); });
    return gaps;
  };
  const Gaps first = gaps_from(Time(0));
  const Gaps later = gaps_from(Time(0x1p40));
  support::record("mean_gap_at_first", first.mean());
  support::record("mean_gap_later", later.mean());
  EXPECT_LT(first.largest, 1e-14);
  EXPECT_LT(later.largest, 1e-14);
  EXPECT_NEAR(later.mean() / first.mean(), 1, 0.01);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_NEAR(first.since_start[i], later.since_start[i], 1e-11);
  // With a clock of one double they would miss by a ten-thousandth of a radius.
  EXPECT_GT(later.blur(), 2e-5);
}

// Between walls the times of all of a sphere's bounces are known: t = t1 + k (D - 2r) / v. With numbers that
// are rounded, the error after a million of them does not grow with the time itself but only with their
// number.
TEST(AMillionBounces, KeepTheirPeriod) {
  constexpr double kSize = 1.7;
  constexpr double kSpeed = 0.37;
  constexpr double kRadius = 0.1;
  constexpr std::uint64_t kBounces = 1000000;
  World world(Box::walls({kSize, kSize, kSize}));
  world.add({.position = {0.3, 0.5, 0.5}, .velocity = {kSpeed, 0, 0}, .radius = kRadius});
  Simulation simulation(world);
  simulation.run_contacts(kBounces);
  const long double flight =
      (static_cast<long double>(kSize) - 2 * static_cast<long double>(kRadius)) / kSpeed;
  const long double first = (static_cast<long double>(kSize) - kRadius - 0.3) / kSpeed;
  const long double expected = first + (kBounces - 1) * flight;
  const long double moment = static_cast<long double>(simulation.now().high) + simulation.now().low;
  // Each flight is rounded by at most two units in the last place of 4, and the position of the wall by one
  // of 1.6: below 2e-15 of time in each, always with the same sign.
  support::record("error_per_bounce", static_cast<double>(moment - expected) / kBounces);
  EXPECT_LT(std::fabs(static_cast<double>(moment - expected)), kBounces * 2e-15);
}

}  // namespace
}  // namespace hardball::precision_test
