// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/geometry/number.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hardball/geometry/double_double.hpp"
#include "hardball/numbers/random.hpp"

namespace hardball::number_test {
namespace {

double any_number(Random& random) {
  return (random.uniform() - 0.5) * std::ldexp(1, static_cast<int>(random.bits() % 801) - 400);
}

TEST(ProductError, ByHalvesIsThatOfOneRounding) {
  Random random(5);
  for (int k = 0; k < 100'000; ++k) {
    const double a = any_number(random);
    const double b = any_number(random);
    if (std::fabs(a * b) < 0x1p-900) continue;
    ASSERT_EQ(product_error_by_halves(a, b, a * b), std::fma(a, b, -(a * b))) << a << " " << b;
  }
  EXPECT_EQ(product_error_by_halves(0x1.fffffffffffffp969, 0x1.fffffffffffffp-100, 0x1.ffffffffffffep870),
            std::fma(0x1.fffffffffffffp969, 0x1.fffffffffffffp-100, -0x1.ffffffffffffep870));
}

TEST(Divide, HasTheRemainderOfOneRounding) {
  Random random(6);
  for (int k = 0; k < 100'000; ++k) {
    const double a = any_number(random);
    const double b = any_number(random);
    if (std::fabs(a) < 0x1p-900 || b == 0) continue;
    const double high = a / b;
    const DoubleDouble<double> quotient = divide({a, 0}, b);
    const double low = std::fma(-high, b, a) / b;
    ASSERT_EQ(quotient.high, high + low);
    ASSERT_EQ(quotient.low, low - (quotient.high - high));
  }
}

}  // namespace
}  // namespace hardball::number_test
