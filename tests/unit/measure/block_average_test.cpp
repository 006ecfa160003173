// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/block_average.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "hardball/numbers/random.hpp"

namespace hardball::block_average_test {
namespace {

TEST(BlockAverage, HasNoValuesWithoutSamples) {
  const BlockAverage nothing;
  EXPECT_EQ(nothing.blocks(), 0U);
  EXPECT_TRUE(std::isnan(nothing.mean()));
  EXPECT_TRUE(std::isnan(nothing.error()));
  EXPECT_TRUE(std::isnan(nothing.ratio(0, 0).value));
  ASSERT_EQ(nothing.histogram(0, 1).size(), 1U);
  EXPECT_TRUE(std::isnan(nothing.histogram(0, 1).front().value));
  EXPECT_TRUE(std::isnan(nothing.histogram(0, 1).front().error));
  EXPECT_TRUE(std::isnan(nothing.estimate([](std::span<const double> means) { return means[0]; }).value));
}

TEST(BlockAverage, HasAMeanAndNoErrorOfOneSample) {
  BlockAverage average;
  average.add(std::array{3.0}, 2, 2);
  EXPECT_EQ(average.mean(), 3);
  EXPECT_TRUE(std::isnan(average.error()));
}

TEST(BlockAverage, WeightsValuesByTheTimeForWhichTheyHeld) {
  BlockAverage average;
  average.add(std::array{1.0}, 3, 3);
  average.add(std::array{5.0}, 4, 1);
  EXPECT_EQ(average.blocks(), 2U);
  EXPECT_EQ(average.mean(), 2);
}

TEST(BlockAverage, SpreadsInstantaneousAmountsOverTheTimeSinceTheLastSample) {
  BlockAverage average(2);
  average.put(0, 6);
  average.close_sample(2, 2);
  average.put(1, 8);
  average.close_sample(2, 0);
  average.close_sample(4, 2);
  EXPECT_EQ(average.samples(), 3U);
  EXPECT_EQ(average.mean(0), 1.5);
  EXPECT_EQ(average.mean(1), 2);
}

// The same numbers cut into blocks and added up by hand.
Estimate direct(const std::vector<double>& values, std::size_t per_block) {
  double mean = 0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  std::vector<double> shares;
  for (std::size_t begin = 0; begin < values.size(); begin += per_block) {
    shares.push_back(0);
    for (std::size_t i = begin; i < begin + per_block; ++i) {
      shares.back() += (values[i] - mean) / static_cast<double>(values.size());
    }
  }
  return {mean, error_of_series(shares)};
}

TEST(BlockAverage, IsADirectComputationOverItsBlocks) {
  Random random(31);
  for (const std::size_t samples : {20U, 63U, 64U, 96U, 128U, 4096U, 5120U}) {
    BlockAverage average(3);
    std::vector<double> values;
    for (std::size_t i = 0; i < samples; ++i) {
      values.push_back(random.normal());
      average.add(std::array{1.0, values.back(), 2 * values.back()}, static_cast<double>(i));
    }
    std::size_t per_block = 1;
    while (samples / per_block >= BlockAverage::kMaxBlocks) per_block *= 2;
    const Estimate expected = direct(values, per_block);
    EXPECT_EQ(average.blocks(), samples / per_block);
    EXPECT_EQ(average.ends().back(), static_cast<double>(samples - 1));
    EXPECT_EQ(average.mean(0), 1);
    EXPECT_TRUE(std::isnan(average.error(0))) << "of equal samples";
    EXPECT_NEAR(average.mean(1), expected.value, 1e-14);
    EXPECT_NEAR(average.error(1), expected.error, 1e-14);
    EXPECT_NEAR(average.error(2), 2 * expected.error, 1e-14);
    const Estimate same = average.estimate([](std::span<const double> means) { return means[1]; });
    EXPECT_NEAR(same.value, expected.value, 1e-14);
    EXPECT_NEAR(same.error, expected.error, 1e-12);
  }
}

TEST(BlockAverage, KeepsBetween32And64Blocks) {
  BlockAverage average;
  for (int i = 1; i <= 10000; ++i) {
    average.add(std::array{static_cast<double>(i)}, i);
    EXPECT_LE(average.blocks(), 64U);
    if (i < 64) continue;
    EXPECT_GE(average.blocks(), 32U);
  }
  EXPECT_EQ(average.mean(), 5000.5);
}

// x' = a x + noise of variance one: the variance of the mean of N is 1 / (N (1 - a)^2) for large N, larger by
// (1 + a) / (1 - a) = 19 than if the values, of variance 1 / (1 - a^2), were independent. With 32 to 64
// blocks the estimate has a relative deviation of 1 / sqrt(2 * 31) = 0.13 at most; four of these.
TEST(BlockAverage, KnowsTheErrorOfACorrelatedSeries) {
  constexpr double kMemory = 0.9;
  constexpr int kSamples = 100000;
  Random random(32);
  BlockAverage average;
  double x = 0;
  for (int i = 0; i < kSamples; ++i) {
    x = kMemory * x + random.normal();
    average.add(std::array{x}, i);
  }
  const double expected = 1 / (std::sqrt(kSamples) * (1 - kMemory));
  EXPECT_NEAR(average.error() / expected, 1, 0.52);
  EXPECT_LT(std::fabs(average.mean()), 4 * expected);
}

TEST(BlockAverage, TakesRatiosBlockByBlock) {
  BlockAverage average(2);
  for (int i = 0; i < 10; ++i) average.add(std::array{i % 2 + 2.0, i % 2 + 1.0}, i);
  EXPECT_DOUBLE_EQ(average.ratio(0, 1).value, 25.0 / 15);
  // Where both are proportional the ratio is exact.
  BlockAverage exact(2);
  for (int i = 1; i <= 20; ++i) exact.add(std::array{2.0 * i, 1.0 * i}, i);
  EXPECT_EQ(exact.ratio(0, 1).value, 2);
  EXPECT_TRUE(std::isnan(exact.ratio(0, 1).error));
}

TEST(BlockAverage, LeavesOutBlocksThatEndedBefore) {
  BlockAverage average;
  for (int i = 0; i < 25; ++i) average.add(std::array{i < 5 ? 100.0 : 1.0 + i % 2}, i);
  average.leave_out_until(4);
  EXPECT_EQ(average.blocks(), 20U);
  EXPECT_EQ(average.mean(), 1.5);
  EXPECT_LT(average.error(), 0.5);
  EXPECT_EQ(average.history([](std::span<const double> means) { return means[0]; }).size(), 25U);
}

constexpr std::size_t kGroups = 16;

// One sample of so many members of each group; the value of each, and how many they are.
BlockAverage one_look(const std::array<double, kGroups>& sums, double members) {
  BlockAverage average(2, kGroups);
  for (std::size_t group = 0; group < kGroups; ++group) {
    average.put(0, sums[group], group);
    average.put(1, members, group);
  }
  average.close_sample(0);
  return average;
}

const FunctionOfMeans kRatio = [](std::span<const double> means) { return means[0] / means[1]; };

TEST(BlockAverage, OfASingleSampleHasTheErrorOfItsGroups) {
  const BlockAverage average = one_look({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}, 2);
  // The sums have the standard deviation sqrt(340 / 15) about 8.5.
  const double expected = std::sqrt(340.0 / 15 / kGroups) / 2 * 2.1812 / 2;
  EXPECT_EQ(average.ratio(0, 1).value, 8.5 / 2);
  EXPECT_NEAR(average.ratio(0, 1).error, expected, 1e-3);
  EXPECT_NEAR(average.estimate(kRatio, BlockAverage::Groups::separate).error, expected, 1e-3);
  EXPECT_NEAR(average.estimate(kRatio, BlockAverage::Groups::exchanging).error, expected, 1e-3);
  EXPECT_TRUE(std::isnan(average.estimate(kRatio).error));
  EXPECT_TRUE(std::isnan(average.ratio(0).error));
}

// Groups that keep their values gain no precision from repeated samples; the scatter of the blocks is zero.
TEST(BlockAverage, OfARepeatedSampleHasTheErrorOfItsGroupsWhereBlocksAreFew) {
  BlockAverage average(2, kGroups);
  for (int i = 0; i < 12; ++i) {
    for (std::size_t group = 0; group < kGroups; ++group) {
      average.put(0, static_cast<double>(group + 1), group);
      average.put(1, 2, group);
    }
    average.close_sample(i);
  }
  const double expected = std::sqrt(340.0 / 15 / kGroups) / 2 * 2.1812 / 2;
  EXPECT_NEAR(average.ratio(0, 1).error, expected, 1e-3);
  EXPECT_NEAR(average.estimate(kRatio, BlockAverage::Groups::exchanging).error, expected, 1e-3);
}

// Groups that remember half their value from sample to sample pass on the rest: the square of the error grows
// by that. Those that remember nothing have nothing to pass on.
TEST(BlockAverage, AllowsForExchangeBetweenGroups) {
  constexpr int kSamples = 12;
  const auto growth = [](double memory) {
    Random random(33);
    double separate = 0;
    double exchanging = 0;
    for (int trial = 0; trial < 200; ++trial) {
      BlockAverage average(2, kGroups);
      std::array<double, kGroups> values{};
      for (double& value : values) value = random.normal();
      for (int i = 0; i < kSamples; ++i) {
        for (std::size_t group = 0; group < kGroups; ++group) {
          average.put(0, values[group], group);
          average.put(1, 1, group);
          values[group] = memory * values[group] + std::sqrt(1 - memory * memory) * random.normal();
        }
        average.close_sample(i);
      }
      separate += std::pow(average.estimate(kRatio, BlockAverage::Groups::separate).error, 2);
      exchanging += std::pow(average.estimate(kRatio, BlockAverage::Groups::exchanging).error, 2);
    }
    return exchanging / separate;
  };
  EXPECT_NEAR(growth(0), 1, 0.15);
  // The sum of 0.5^|i - j| over 12 by 12 samples is 32: so much of 144 is kept, and 20 of 32 are remembered.
  EXPECT_NEAR(growth(0.5), 1 + 20.0 / 32 * (1 - 32.0 / 144), 0.1);
  EXPECT_EQ(growth(1), 1);
}

// Every sixteenth count of 0, 1 and 100 lies in the first, second and third bin.
TEST(BlockAverage, AllowsForOneMoreCountInAHistogram) {
  BlockAverage average(4, kGroups);
  for (std::size_t group = 0; group < kGroups; ++group) {
    average.put(1, group == 0 ? 1 : 0, group);
    average.put(2, group % 2 == 0 ? 3 : 5, group);
    average.put(3, 100, group);
  }
  average.close_sample(0);
  const std::vector<Estimate> bins = average.histogram(0, 3, 3);
  const double one = 1.0 / (100 * kGroups);
  EXPECT_EQ(bins[0].value, 0);
  EXPECT_DOUBLE_EQ(bins[0].error, one);
  EXPECT_DOUBLE_EQ(bins[1].value, one);
  EXPECT_NEAR(bins[1].error, std::hypot(one, average.ratio(1, 3).error), 1e-15);
  EXPECT_NEAR(bins[2].value, 64 * one, 1e-15);
}

// Spheres that are sampled ten times each, or not at all, make ten counts out of one.
TEST(BlockAverage, CountsThatComeTenAtATimeAsOne) {
  Random random(34);
  BlockAverage average(21, kGroups);
  for (std::size_t group = 0; group < kGroups; ++group) {
    for (std::size_t bin = 0; bin < 20; ++bin) {
      if (random.uniform() < 0.5) average.put(bin, 10, group);
    }
    average.put(20, 100, group);
  }
  average.close_sample(0);
  const double one = 1.0 / (100 * kGroups);
  // p (1 - p) of ten counts squared, over ten p, is five for p = 1/2.
  const Estimate plain = average.ratio(0, 20);
  const Estimate allowed = average.histogram(0, 20, 20)[0];
  const double added = std::sqrt(allowed.error * allowed.error - plain.error * plain.error) / one;
  EXPECT_NEAR(added, 5 * 2.1812 * 2.1812 / 4, 1);
}

TEST(BlockAverage, CountsEarlierSamplesHalfAfterHalving) {
  BlockAverage average;
  for (int i = 0; i < 4; ++i) average.add(std::array{1.0}, i);
  average.halve_weights();
  for (int i = 4; i < 6; ++i) average.add(std::array{2.0}, i);
  EXPECT_EQ(average.mean(), (4 * 0.5 * 1 + 2 * 2) / (4 * 0.5 + 2));
}

// Samples that are all equal say nothing about those of other runs.
TEST(BlockAverage, OfEqualSamplesHasNoError) {
  for (const double noise : {0.0, 1e-16, 1e-3}) {
    Random random(36);
    BlockAverage average;
    for (int i = 0; i < 50; ++i) average.add(std::array{1 + noise * random.normal()}, i);
    EXPECT_EQ(std::isnan(average.error()), noise < 1e-12) << noise;
  }
}

}  // namespace
}  // namespace hardball::block_average_test
