// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/block_average.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "hardball/world/random.hpp"

namespace hardball {
namespace {

TEST(BlockAverage, KnowsNothingOfNoSamples) {
  const BlockAverage nothing;
  EXPECT_EQ(nothing.blocks(), 0U);
  EXPECT_TRUE(std::isnan(nothing.mean()));
  EXPECT_TRUE(std::isnan(nothing.error()));
  EXPECT_TRUE(std::isnan(nothing.ratio(0, 0)));
}

TEST(BlockAverage, KnowsAMeanAndNoErrorOfOneSample) {
  BlockAverage average;
  average.add(3, 2);
  EXPECT_EQ(average.mean(), 3);
  EXPECT_TRUE(std::isnan(average.error()));
}

TEST(BlockAverage, OfFewSamplesHasTheirStandardError) {
  BlockAverage average;
  for (const double value : {1.0, 2.0, 4.0, 5.0}) average.add(value);
  EXPECT_EQ(average.blocks(), 4U);
  EXPECT_EQ(average.mean(), 3);
  // Squared deviations of 4 + 1 + 1 + 4, over 4 * 3.
  EXPECT_DOUBLE_EQ(average.error(), std::sqrt(10.0 / 12));
}

TEST(BlockAverage, WeighsValuesByTheTimeForWhichTheyHeld) {
  BlockAverage average;
  average.add(1, 3);
  average.add(5, 1);
  EXPECT_EQ(average.mean(), 2);
  // Deviations 3 (1 - 2) and 1 (5 - 2), twice the sum of their squares over the square of 4.
  EXPECT_DOUBLE_EQ(average.error(), std::sqrt(2 * (9.0 + 9)) / 4);
}

TEST(BlockAverage, SpreadsWhatCameAtOneMomentOverTheTimeSinceTheLast) {
  BlockAverage average(2);
  average.put(0, 6);
  average.close_sample(2);
  average.put(1, 8);
  average.close_sample(0);
  average.close_sample(2);
  EXPECT_EQ(average.samples(), 3U);
  EXPECT_EQ(average.mean(0), 1.5);
  EXPECT_EQ(average.mean(1), 2);
}

// The same numbers cut into blocks and added up with pencil and paper.
struct Blocks {
  double mean = 0;
  double error = 0;
};

Blocks direct(const std::vector<double>& values, std::size_t per_block) {
  double sum = 0;
  for (const double value : values) sum += value;
  Blocks found;
  found.mean = sum / static_cast<double>(values.size());
  const std::size_t count = values.size() / per_block;
  double squares = 0;
  for (std::size_t block = 0; block < count; ++block) {
    double of_block = 0;
    for (std::size_t i = 0; i < per_block; ++i) of_block += values[block * per_block + i];
    const double deviation = of_block / static_cast<double>(per_block) - found.mean;
    squares += deviation * deviation;
  }
  found.error = std::sqrt(squares / static_cast<double>(count * (count - 1)));
  return found;
}

TEST(BlockAverage, IsADirectComputationOverItsBlocks) {
  Random random(31);
  for (const std::size_t samples : {2U, 63U, 64U, 96U, 128U, 4096U, 5120U}) {
    BlockAverage average(3);
    std::vector<double> values;
    for (std::size_t i = 0; i < samples; ++i) {
      values.push_back(random.normal());
      average.add(std::array{1.0, values.back(), 2 * values.back()});
    }
    std::size_t per_block = 1;
    while (samples / per_block >= BlockAverage::kMostBlocks) per_block *= 2;
    const Blocks expected = direct(values, per_block);
    EXPECT_EQ(average.blocks(), samples / per_block);
    EXPECT_EQ(average.mean(0), 1);
    EXPECT_EQ(average.error(0), 0);
    EXPECT_NEAR(average.mean(1), expected.mean, 1e-14);
    EXPECT_NEAR(average.error(1), expected.error, 1e-14);
    EXPECT_NEAR(average.error(2), 2 * expected.error, 1e-14);
  }
}

TEST(BlockAverage, KeepsBetween32And64Blocks) {
  BlockAverage average;
  for (int i = 1; i <= 10000; ++i) {
    average.add(i);
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
    average.add(x);
  }
  const double expected = 1 / (std::sqrt(kSamples) * (1 - kMemory));
  EXPECT_NEAR(average.error() / expected, 1, 0.52);
  EXPECT_LT(std::fabs(average.mean()), 4 * expected);
}

TEST(BlockAverage, TakesRatiosBlockByBlock) {
  BlockAverage average(2);
  average.add(std::array{2.0, 1.0});
  average.add(std::array{4.0, 3.0});
  EXPECT_EQ(average.ratio(0, 1), 1.5);
  // Deviations 2 - 1.5 and 4 - 4.5.
  EXPECT_DOUBLE_EQ(average.ratio_error(0, 1), std::sqrt(2 * (0.25 + 0.25)) / 4);
  // Where both grow together the ratio is certain.
  BlockAverage exact(2);
  for (int i = 1; i <= 10; ++i) exact.add(std::array{2.0 * i, 1.0 * i});
  EXPECT_EQ(exact.ratio(0, 1), 2);
  EXPECT_EQ(exact.ratio_error(0, 1), 0);
}

}  // namespace
}  // namespace hardball
