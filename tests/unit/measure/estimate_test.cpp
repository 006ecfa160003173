// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/estimate.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "hardball/numbers/random.hpp"

namespace hardball::estimate_test {
namespace {

// A series of variance one in which each value keeps the fraction `memory` of the last, plus white noise.
std::vector<double> series(Random& random, std::size_t count, double memory, double noise = 0) {
  std::vector<double> values;
  double x = random.normal();
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(x + noise * random.normal());
    x = memory * x + std::sqrt(1 - memory * memory) * random.normal();
  }
  return values;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value / static_cast<double>(values.size());
  return sum;
}

// By how much each value moved the mean.
std::vector<double> shares_of(const std::vector<double>& values) {
  const double mean = mean_of(values);
  std::vector<double> shares;
  for (const double value : values) shares.push_back((value - mean) / static_cast<double>(values.size()));
  return shares;
}

TEST(Estimates, MultiplyWithTheirErrors) {
  const Estimate product = Estimate{3, 0.3} * Estimate{4, 0.3};
  EXPECT_EQ(product.value, 12);
  EXPECT_DOUBLE_EQ(product.error, 1.5);
}

TEST(Jackknife, OfAMeanFindsByHowMuchEachPartMovedIt) {
  const std::array sums{1.0, 2.0, 4.0, 9.0};
  const std::array weights{1.0, 1.0, 1.0, 1.0};
  const Parts found = jackknife(sums, weights, [](auto means) { return means[0]; });
  EXPECT_EQ(found.value, 4);
  ASSERT_EQ(found.shares.size(), 4U);
  EXPECT_DOUBLE_EQ(found.shares[0], -3.0 / 4);
  EXPECT_DOUBLE_EQ(found.shares[3], 5.0 / 4);
}

// Student's t that 2.275% exceed is 3.3068 with three degrees of freedom and 2.1812 with 15.
TEST(ErrorOfIndependent, IsTheStandardErrorTimesStudentsFactor) {
  const std::vector<double> shares{-2, -1, 1, 2};
  EXPECT_NEAR(error_of_independent(shares), std::sqrt(10 * 4.0 / 3) * 3.3068 / 2, 0.06);
  const std::vector<double> many{1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1};
  EXPECT_NEAR(error_of_independent(many), std::sqrt(16 * 16.0 / 15) * 2.1812 / 2, 1e-3);
  EXPECT_TRUE(std::isnan(error_of_independent(std::vector<double>{-1, 0, 1})));
}

TEST(IndependentParts, AreAllOfThemInUncorrelatedSeries) {
  Random random(71);
  double sum = 0;
  constexpr int kTrials = 400;
  for (int trial = 0; trial < kTrials; ++trial) {
    const double found = independent_parts(shares_of(series(random, 64, 0)));
    EXPECT_LE(found, 128);
    sum += found / kTrials;
  }
  EXPECT_GT(sum, 48);
  EXPECT_EQ(independent_parts(std::vector<double>(12, 0.0)), 12);
}

// n (1 - a) / (1 + a), of 64: a series worth a quarter of its length, and one half hidden by noise.
TEST(IndependentParts, AreFewerInCorrelatedSeries) {
  Random random(72);
  double plain = 0;
  double noisy = 0;
  constexpr int kTrials = 1000;
  for (int trial = 0; trial < kTrials; ++trial) {
    plain += independent_parts(shares_of(series(random, 64, 0.6))) / kTrials;
    noisy += independent_parts(shares_of(series(random, 64, 0.8, 1))) / kTrials;
  }
  EXPECT_NEAR(plain, 16, 3);
  // The variance of the mean is (9 + 1) / 64 where independent values of the variance 2 would have 2 / 64.
  // Half of the correlation is detected.
  EXPECT_NEAR(noisy, 2 * 64 / 5.0, 5);
}

// Counts the series, among many, whose mean is off by more than two errors.
struct Coverage {
  int outside = 0;
  int known = 0;
};

Coverage coverage(Random& random, int trials, std::size_t count, double memory) {
  Coverage found;
  for (int trial = 0; trial < trials; ++trial) {
    const std::vector<double> values = series(random, count, memory);
    const double error = error_of_series(shares_of(values));
    if (std::isnan(error)) continue;
    ++found.known;
    if (std::fabs(mean_of(values)) > 2 * error) ++found.outside;
  }
  return found;
}

// Four deviations of the binomial distribution are 0.9% of 4000.
TEST(ErrorOfSeries, CoversTheTruthInTheStatedFractionOfRuns) {
  Random random(73);
  constexpr int kTrials = 4000;
  for (const std::size_t count : {16U, 32U, 64U}) {
    for (const double memory : {0.0, 0.3}) {
      // Nine independent values are too near the limit of eight.
      if (count == 16 && memory > 0) continue;
      const Coverage found = coverage(random, kTrials, count, memory);
      EXPECT_GT(found.known, 0.85 * kTrials) << count << " " << memory;
      EXPECT_LT(found.outside, 0.07 * found.known) << count << " " << memory;
      EXPECT_GT(found.outside, 0.02 * found.known) << count << " " << memory;
    }
  }
}

// Runs as short as the correlation time: there are fewer than eight independent values, and most runs have no
// error. Those that do are no more than would be off by chance.
TEST(ErrorOfSeries, IsNotKnownOfARunThatIsTooShort) {
  Random random(74);
  constexpr int kTrials = 4000;
  for (const double memory : {0.8, 0.95, 0.99}) {
    const Coverage found = coverage(random, kTrials, 48, memory);
    EXPECT_LT(found.known, 0.35 * kTrials) << memory;
    EXPECT_LT(found.outside, 0.07 * kTrials) << memory;
  }
  EXPECT_TRUE(std::isnan(error_of_series(shares_of(series(random, 15, 0)))));
}

TEST(ErrorOfSeries, OfAConstantIsZero) {
  EXPECT_EQ(error_of_series(std::vector<double>(16, 0.0)), 0);
}

}  // namespace
}  // namespace hardball::estimate_test
