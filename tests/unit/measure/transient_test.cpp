// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/transient.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "hardball/numbers/random.hpp"

namespace hardball::transient_test {
namespace {

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

}  // namespace
}  // namespace hardball::transient_test
