// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/statistics/moment_lags.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "hardball/numbers/random.hpp"

namespace hardball::moment_lags_test {
namespace {

// The slope from increments of a length and of twice that, the latter overlapping by half.
double plain_slope(const std::vector<double>& steps, std::size_t length, double base) {
  const auto sum = [&](std::size_t begin) {
    double total = 0;
    for (std::size_t i = begin; i < begin + length; ++i) total += steps[i];
    return total;
  };
  double excess = 0;
  double windows = 0;
  for (std::size_t begin = 0; begin + 2 * length <= steps.size(); begin += length) {
    const double first = sum(begin);
    const double second = sum(begin + length);
    excess += std::pow(first + second, 2) - (first * first + second * second) / 2;
    ++windows;
  }
  return excess / windows / (static_cast<double>(length) * base);
}

std::vector<double> correlated_steps(std::size_t count, double mean) {
  Random random(3);
  std::vector<double> steps;
  double state = 0;
  for (std::size_t i = 0; i < count; ++i) {
    state = 0.8 * state + random.normal();
    steps.push_back(mean + state);
  }
  return steps;
}

MomentLags lags_of(const std::vector<double>& steps, double base, bool has_mean) {
  MomentLags lags(base, {1}, has_mean);
  for (std::size_t i = 0; i < steps.size(); ++i)
    lags.add(std::array{steps[i]}, static_cast<double>(i + 1) * base);
  return lags;
}

TEST(MomentLags, HasTheSlopesOfAllIncrements) {
  const std::vector<double> steps = correlated_steps(1000, 0);
  const MomentLags lags = lags_of(steps, 0.5, false);
  ASSERT_GE(lags.levels(), 9U);
  for (std::size_t level = 0; level < 9; ++level) {
    const double expected = plain_slope(steps, std::size_t{1} << level, 0.5);
    EXPECT_EQ(lags.lag(level), std::ldexp(0.5, static_cast<int>(level)));
    EXPECT_NEAR(lags.slope(level).value, expected, 1e-11 * std::fabs(expected)) << level;
  }
}

// Of a process with memory the slope tends to the sum of all correlations: 1 / (1 - .8)^2 for these steps.
TEST(MomentLags, EndsInTheSumOfAllCorrelations) {
  for (const double mean : {0.0, 40.0}) {
    const MomentLags lags = lags_of(correlated_steps(400000, mean), 1, mean != 0);
    const MomentLags::Plateau plateau = lags.plateau(4, 4);
    EXPECT_EQ(plateau.reason, "");
    EXPECT_GE(plateau.lag, 16) << "by then correlations are over";
    EXPECT_NEAR(plateau.slope.value, 25, 3 * plateau.slope.error);
    EXPECT_LT(plateau.slope.error, 1.5);
  }
}

TEST(MomentLags, TakesALagAsLongAsWantedIfTheRunAllows) {
  const MomentLags lags = lags_of(correlated_steps(1000, 0), 1, false);
  EXPECT_GE(lags.plateau(4, 16).lag, 16);
  EXPECT_EQ(lags.plateau(4, 64).lag, 16) << "the run is 62 times as long";
}

TEST(MomentLags, SaysWhyThereIsNoPlateau) {
  const MomentLags lags = lags_of(correlated_steps(200, 0), 1, false);
  EXPECT_NE(lags.plateau(8, 8).reason, "");
  EXPECT_TRUE(std::isnan(lags.plateau(8, 8).slope.value));
  EXPECT_NE(MomentLags(1, {1}).plateau(1, 1).reason, "");
}

}  // namespace
}  // namespace hardball::moment_lags_test
