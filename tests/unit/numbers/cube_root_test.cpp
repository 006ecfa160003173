// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/numbers/cube_root.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"

namespace hardball::cube_root_test {
namespace {

TEST(CubeRoot, IsThatOfTheLibraryUpToRounding) {
  Random random(1);
  for (std::size_t i = 0; i < support::cases(100000); ++i) {
    const double x = std::ldexp(1 + random.uniform(), static_cast<int>(random.bits() % 1000) - 500);
    ASSERT_NEAR(cube_root(x) / std::cbrt(x), 1, 1e-15) << x;
  }
}

TEST(CubeRoot, OfPowersOfTwoIsExact) {
  for (int power = -300; power <= 300; ++power)
    EXPECT_EQ(cube_root(std::ldexp(1.0, 3 * power)), std::ldexp(1.0, power));
}

}  // namespace
}  // namespace hardball::cube_root_test
