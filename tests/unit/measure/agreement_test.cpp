// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/agreement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hardball::agreement_test {
namespace {

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
}  // namespace hardball::agreement_test
