// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/sampling_schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace hardball::sampling_schedule_test {
namespace {

constexpr Pace kPace{.free_time = 0.3, .cost = 1e6, .contact_cost = 1000};

std::vector<double> times_of(SamplingSchedule schedule, std::size_t count) {
  constexpr std::uint64_t kMany = 1'000'000'000;
  std::vector<double> times;
  while (times.size() < count) {
    times.push_back(schedule.next().value());
    schedule.advance(schedule.next(), kMany * times.size());
  }
  return times;
}

// The mean of a wave of this period over samples at these times.
double mean_of_wave(const std::vector<double>& times, double period) {
  double cosine = 0;
  double sine = 0;
  for (const double time : times) {
    cosine += std::cos(2 * std::numbers::pi * time / period);
    sine += std::sin(2 * std::numbers::pi * time / period);
  }
  return std::hypot(cosine, sine) / static_cast<double>(times.size());
}

TEST(SamplingSchedule, IsAsFineAsItMayBeIfTheRunCanAffordIt) {
  const SamplingSchedule cheap = SamplingSchedule::scattered(Time(0), 0.5, 1, kPace);
  EXPECT_EQ(cheap.interval(), 0.5);
  EXPECT_EQ(cheap.period(), 0.5);
  EXPECT_LT(cheap.next(), Time(0.5));
  EXPECT_EQ(power_of_two_from(0.25), 0.25);
  EXPECT_EQ(power_of_two_from(0.26), 0.5);
}

TEST(SamplingSchedule, HasOneScatteredSampleInEachPeriod) {
  const std::vector<double> times = times_of(SamplingSchedule::scattered(Time(3), 0.25), 1000);
  for (std::size_t k = 0; k < times.size(); ++k) {
    EXPECT_EQ(std::floor((times[k] - 3) / 0.25), static_cast<double>(k));
  }
}

// A wave over samples at random has the mean square 1 / n; in stretches as long as its period it has less.
TEST(SamplingSchedule, ComesToAllPhasesOfAnythingPeriodic) {
  constexpr std::size_t kSamples = 4096;
  const double by_chance = 4 / std::sqrt(static_cast<double>(kSamples));
  const std::vector<double> scattered = times_of(SamplingSchedule::scattered(Time(0), 0.5), kSamples);
  // So dear that periods are of many intervals.
  const SamplingSchedule dear = SamplingSchedule::scattered(Time(0), 0.5, 1e8, kPace);
  ASSERT_GT(dear.period(), 100);
  const std::vector<double> rare = times_of(dear, kSamples);
  const std::vector<double> regular =
      times_of(SamplingSchedule::regular(Time(0), irrational_from(0.3)), kSamples);
  for (const double period : {0.05, 0.1, 0.125, 1.0 / 3, 0.25, 0.5, 1.0, 1.5, 2.0, 4.0, 128.0}) {
    EXPECT_LT(mean_of_wave(scattered, period), by_chance) << period;
    EXPECT_LT(mean_of_wave(rare, period), by_chance) << period;
    EXPECT_LT(mean_of_wave(regular, period), by_chance) << period;
  }
  EXPECT_GT(mean_of_wave(times_of(SamplingSchedule::regular(Time(0), 0.5), kSamples), 0.25), 0.99)
      << "as a user may ask";
}

TEST(SamplingSchedule, IsIrrationalByDefaultWhereItIsRegular) {
  EXPECT_GE(irrational_from(0.3), 0.3);
  EXPECT_LT(irrational_from(0.3), 0.6);
  EXPECT_NEAR(irrational_from(1), std::sqrt(5.0) - 1, 1e-7);
  EXPECT_EQ(irrational_from(irrational_from(0.3)), irrational_from(0.3));
}

// So that measures that can afford fewer samples need no surroundings of their own.
TEST(SamplingSchedule, HasSamplesInCommonWithThoseOfHalfTheirPeriod) {
  std::vector<double> fine = times_of(SamplingSchedule::scattered(Time(0), 0.5), 4096);
  for (const double cost : {1e6, 1e7, 1e8}) {
    const SamplingSchedule dear = SamplingSchedule::scattered(Time(0), 0.5, cost, kPace);
    for (const double time : times_of(dear, 100)) {
      if (time >= fine.back()) break;
      EXPECT_TRUE(std::ranges::binary_search(fine, time)) << cost << " at " << time;
    }
  }
}

// At a cost of 1e6 the run pays for a sample every 1e6 / (0.0025 * 1e6) = 400 units of time: ten doublings of
// half a unit. Free are 250 samples, 25 for each doubling. A sample is worth 1e6 / (0.0025 * 1000) = 400,000
// contacts, a thousand for each unit of time.
TEST(SamplingSchedule, SpreadsWhatIsFreeOverTheDoublingsOfItsPeriod) {
  SamplingSchedule schedule = SamplingSchedule::scattered(Time(0), 0.5, 1e6, kPace);
  double previous = 0;
  int samples = 0;
  int doublings = 0;
  const auto advance = [&] {
    previous = schedule.next().value();
    doublings += schedule.advance(schedule.next(), static_cast<std::uint64_t>(1000 * previous));
    ++samples;
  };
  for (double period = 0.5; period < 256; period *= 2) {
    for (int i = 0; i < 25; ++i) {
      EXPECT_EQ(schedule.period(), period);
      EXPECT_LE(schedule.next().value() - previous, 2 * period);
      advance();
    }
  }
  EXPECT_EQ(doublings, 9) << "which samples stand for as much time is told";
  for (int i = 0; i < 200; ++i) advance();
  EXPECT_EQ(schedule.period(), 256) << "which the run pays for within the tolerance";
  EXPECT_LE(1e6 * samples, SamplingSchedule::kAllowance + 2 * SamplingSchedule::kShare * 1e6 * previous);
}

TEST(SamplingSchedule, WaitsOnlyForSamplesThatAreNotFree) {
  const auto first = [](double share) {
    return SamplingSchedule::scattered(Time(0), 0.5, share * SamplingSchedule::kAllowance, kPace).next();
  };
  EXPECT_LT(first(0.9), Time(100000));
  EXPECT_GT(first(1.1), Time(100000));
  EXPECT_EQ(SamplingSchedule::regular(Time(0), 0.5, 1, 0.9 * SamplingSchedule::kAllowance, kPace).next(),
            Time(0));
}

// Windows stay dense; what grows are the pauses.
TEST(SamplingSchedule, KeepsTheIntervalOfItsWindows) {
  SamplingSchedule schedule = SamplingSchedule::regular(Time(0), 0.25, 4, 1e8 / 4, kPace);
  const std::vector<double> expected{0, 0.25, 0.5, 0.75};
  ASSERT_GT(schedule.period(), 4 * 0.25);
  for (int window = 0; window < 10; ++window) {
    const double begin = schedule.next().value();
    EXPECT_EQ(std::fmod(begin, schedule.period()), 0);
    for (const double time : expected) {
      EXPECT_EQ(schedule.next(), Time(begin + time));
      schedule.advance(schedule.next(), 0);
    }
  }
}

TEST(SamplingSchedule, DoublesItsPeriodWhereContactsBecomeRare) {
  SamplingSchedule schedule = SamplingSchedule::scattered(Time(1), 512, 1e6, kPace);
  std::uint64_t contacts = 0;
  int doublings = 0;
  for (int i = 0; i < 8; ++i) doublings += schedule.advance(schedule.next(), contacts += 400000);
  EXPECT_EQ(doublings, 0);
  EXPECT_EQ(schedule.period(), 512);
  EXPECT_EQ(std::floor((schedule.next().value() - 1) / 512), 8);
  for (int i = 0; i < 8; ++i) doublings += schedule.advance(schedule.next(), contacts += 180000);
  EXPECT_EQ(doublings, 1);
  EXPECT_EQ(schedule.period(), 1024);
  EXPECT_EQ(std::floor((schedule.next().value() - 1) / 1024), 8);
}

TEST(SamplingSchedule, OfTheUserDoesNotChange) {
  SamplingSchedule schedule = SamplingSchedule::regular(Time(0), 0.1);
  for (int i = 0; i < 100; ++i) schedule.advance(schedule.next(), 0);
  EXPECT_EQ(schedule.next(), Time(100 * 0.1));
  EXPECT_EQ(SamplingSchedule().next(), kNever);
}

}  // namespace
}  // namespace hardball::sampling_schedule_test
