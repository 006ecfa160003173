// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "bench/power_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace hardball::bench::power_law_test {
namespace {

TEST(PowerLaw, FindsTheLawThatGeneratedThePoints) {
  const std::vector<double> x = {1, 3, 10, 500};
  std::vector<double> y;
  for (const double value : x) y.push_back(0.25 * std::pow(value, 1.75));
  const PowerLaw law = fit_power_law(x, y);
  EXPECT_NEAR(law.exponent, 1.75, 1e-13);
  EXPECT_NEAR(law.factor, 0.25, 1e-13);
  EXPECT_NEAR(law.standard_error, 0, 1e-13);
  EXPECT_EQ(law.points, 4U);
}

TEST(PowerLaw, GivesTheStandardErrorOfTheSlope) {
  // In logarithms the points (0, 0), (1, 3), (2, 0): slope 0, residuals -1, 2, -1, error sqrt(6 / 1 / 2).
  constexpr double e = std::numbers::e;
  const PowerLaw law = fit_power_law(std::vector{1., e, e * e}, std::vector{1., e * e * e, 1.});
  EXPECT_NEAR(law.exponent, 0, 1e-14);
  EXPECT_NEAR(law.standard_error, std::sqrt(3), 1e-13);
}

TEST(PowerLaw, TwoPointsHaveNoError) {
  const PowerLaw law = fit_power_law(std::vector{1., 2.}, std::vector{1., 8.});
  EXPECT_NEAR(law.exponent, 3, 1e-14);
  EXPECT_TRUE(std::isnan(law.standard_error));
}

}  // namespace
}  // namespace hardball::bench::power_law_test
