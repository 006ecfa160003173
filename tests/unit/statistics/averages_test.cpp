// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/statistics/block_average.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "hardball/statistics/agreement.hpp"
#include "hardball/statistics/estimate.hpp"
#include "hardball/statistics/transient.hpp"

namespace hardball::averages_test {
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

TEST(BlockAverage, HasAHistoryOfTheMiddlesOfItsBlocks) {
  BlockAverage average;
  average.add(std::array{3.0}, 12, 2);
  average.add(std::array{7.0}, 12, 0);
  average.add(std::array{5.0}, 16, 4);
  EXPECT_EQ(average.history([](std::span<const double> means) { return means[0]; }),
            (std::vector<double>{3, 5}));
  EXPECT_EQ(average.middles(10), (std::vector<double>{11, 14}));
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
  const double of_coupled = std::sqrt(2) * expected;
  EXPECT_NEAR(average.estimate(kRatio, BlockAverage::Groups::coupled).error, of_coupled, 1e-3);
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

const FunctionOfMeans kFirst = [](std::span<const double> means) { return means[0]; };

// Noise about a value that starts `height` too high and settles in the time `settling`; ten samples for each
// unit of time, to 100.
BlockAverage watched(double height, double settling, std::uint64_t seed) {
  Random random(seed);
  BlockAverage average;
  for (int i = 0; i < 1000; ++i) {
    const double time = 0.1 * (i + 1);
    average.add(std::array{5 + height * std::exp(-time / settling) + 0.1 * random.normal()}, time);
  }
  return average;
}

TEST(Transients, AreLeftOut) {
  const BlockAverage average = watched(2, 4, 81);
  const Transient found = find_transient(average, std::array{kFirst});
  ASSERT_TRUE(found.end.has_value());
  EXPECT_TRUE(found.is_over);
  // After four times its length 2 exp(-4) of it is left, a third of the noise.
  EXPECT_GT(*found.end, 12);
  EXPECT_LT(*found.end, 40);
  EXPECT_NEAR(average.mean(), 5.08, 0.02);
  const BlockAverage rest = found.left_out_of(average);
  EXPECT_NEAR(rest.mean(), 5, 0.02);
  EXPECT_LT(rest.blocks(), average.blocks());
  EXPECT_EQ(rest.history(kFirst).size(), average.history(kFirst).size());
}

// A sixteenth is beyond two errors by chance in one run of 20.
TEST(Transients, AreRarelyFoundWhereThereAreNone) {
  int seen = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    if (find_transient(watched(0, 1, seed), std::array{kFirst}).end) ++seen;
  }
  EXPECT_GT(seen, 4);
  EXPECT_LT(seen, 40);
}

TEST(Transients, ThatAreNotOverLeaveNoErrors) {
  Random random(82);
  BlockAverage average;
  for (int i = 0; i < 1000; ++i) average.add(std::array{(i < 490 ? 1.0 : 0.0) + 0.1 * random.normal()}, i);
  const Transient found = find_transient(average, std::array{kFirst});
  EXPECT_FALSE(found.is_over);
  EXPECT_FALSE(found.end.has_value());
  Measurement measurement;
  measurement.quantities.push_back({"a", "1", 5, 0.1});
  measurement.columns = {{"x", "1", ColumnRole::argument, {1}},
                         {"y", "1", ColumnRole::value, {2}},
                         {"y_error", "1", ColumnRole::error, {3}}};
  found.note_in(measurement);
  leave_unsettled_open(measurement);
  EXPECT_FALSE(measurement.is_transient_over);
  EXPECT_EQ(measurement.quantities[0].value, 5);
  EXPECT_TRUE(std::isnan(measurement.quantities[0].error));
  EXPECT_EQ(measurement.columns[1].values[0], 2);
  EXPECT_TRUE(std::isnan(measurement.columns[2].values[0]));
}

TEST(Transients, AreNotSoughtInAFewSamples) {
  BlockAverage average;
  for (int i = 0; i < 15; ++i) average.add(std::array{i < 5 ? 10.0 : 0.0}, i);
  EXPECT_FALSE(find_transient(average, std::array{kFirst}).end.has_value());
}

// The first samples, at times 0 and 1, are a transient by themselves.
TEST(Transients, MayBeTheFirstSixteenth) {
  Random random(83);
  BlockAverage average;
  for (int i = 0; i < 40; ++i) average.add(std::array{(i < 2 ? 9.0 : 0.0) + random.normal()}, i);
  const Transient found = find_transient(average, std::array{kFirst});
  ASSERT_TRUE(found.end.has_value());
  EXPECT_EQ(*found.end, 1);
  EXPECT_EQ(found.left_out_of(average).blocks(), 38U);
  EXPECT_EQ(Transient{}.left_out_of(average).blocks(), 40U);
}

// One that ends at time zero is one sample.
TEST(Transients, MayEndAtZero) {
  BlockAverage average;
  for (int i = 0; i < 20; ++i) average.add(std::array{1.0}, i);
  const Transient at_zero{.end = 0, .is_over = true};
  EXPECT_EQ(at_zero.left_out_of(average).blocks(), 19U);
}

Measurement with(std::vector<Quantity> quantities) {
  return {
      .name = "things", .title = "Things", .formula = "", .source = "", .quantities = std::move(quantities)};
}

// Student's t with seven degrees of freedom is beyond 3.499 with a probability of 1%, and beyond 5.408 with
// 0.1%; two errors are 2.365.
TEST(Agreement, AllowsForMoreThanOneNumber) {
  EXPECT_NEAR(largest_by_chance(1), 3.4995 / 2.3646 * 2, 1e-3);
  EXPECT_NEAR(largest_by_chance(10), 5.4079 / 2.3646 * 2, 1e-3);
  EXPECT_GT(largest_by_chance(100), largest_by_chance(10));
}

TEST(Agreement, ComparesWhatHasAnErrorAndATheory) {
  EXPECT_DOUBLE_EQ(deviation({"size", "1", 5, 0.5, 3}), 4);
  EXPECT_DOUBLE_EQ(deviation({"size", "1", 5, 0.5, 3, 1.5}), 1);
  EXPECT_EQ(deviation({"size", "1", 5, 0.5, 3, 2.5}), 0);
  EXPECT_TRUE(std::isnan(deviation({"size", "1", 5, 0.5, 3, kForComparison})));
  EXPECT_TRUE(std::isnan(deviation({"size", "1", 5, 0.5})));
  EXPECT_TRUE(std::isnan(deviation({"size", "1", 5, 0, 3}))) << "exact but for rounding";
  EXPECT_TRUE(std::isnan(deviation({"size", "1", 5, std::nan(""), 3})));
}

TEST(Agreement, NamesWhatIsTooFar) {
  std::vector<Measurement> found{
      with({{"size", "1", 3.3, 0.1, 3}, {"mass", "1", 4, 0.1, 3}, {"age", "1", 3}})};
  const Agreement few(found);
  EXPECT_EQ(few.compared(), 2U);
  ASSERT_EQ(few.far().size(), 1U);
  EXPECT_EQ(few.far()[0].quantity, "mass");
  EXPECT_EQ(few.far()[0].title, "Things");
  EXPECT_TRUE(few.is_far(found[0].quantities[1]));
  EXPECT_FALSE(few.is_far(found[0].quantities[0]));
  // Four errors are much for one number, and not for many.
  found.push_back(with({{"length", "1", 3.4, 0.1, 3}}));
  for (int i = 0; i < 50; ++i) found.push_back(with({{"width", "1", 3, 0.1, 3}}));
  const Agreement many(found);
  ASSERT_EQ(many.far().size(), 1U);
  EXPECT_EQ(many.far()[0].quantity, "mass");
  EXPECT_TRUE(Agreement({}).far().empty());
}

}  // namespace
}  // namespace hardball::averages_test
