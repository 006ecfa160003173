// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/surfaces/sine.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "hardball/numbers/random.hpp"

namespace hardball::sine_test {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_100;

TEST(Circular, IsExactInTheQuadrants) {
  EXPECT_EQ(circular(1, Time(0)).sine.high, 0);
  EXPECT_EQ(circular(1, Time(0)).cosine.high, 1);
  EXPECT_EQ(circular(1, Time(0.25)).sine.high, 1);
  EXPECT_EQ(circular(0.5, Time(1)).cosine.high, -1);
  EXPECT_EQ(circular(1, Time(1e15 + 0.75)).sine.high, -1);
  EXPECT_EQ(circular(1, Time(-0.25)).sine.high, -1);
}

TEST(Circular, IsDefinedForAnyNumberOfTurns) {
  for (const double frequency : {1e40, 1e200, 1e300}) {
    const Circular found = circular(frequency, Time(1e200));
    EXPECT_EQ(found.sine.high, 0) << frequency;
    EXPECT_EQ(found.cosine.high, 1) << frequency;
  }
}

TEST(Circular, AgreesWithAHundredDigits) {
  Random random(3);
  const Wide turn = 2 * boost::math::constants::pi<Wide>();
  for (int i = 0; i < 2000; ++i) {
    const double frequency = std::ldexp(1 + random.uniform(), static_cast<int>(20 * random.uniform()) - 10);
    const Time time = after(Time(std::ldexp(random.uniform(), static_cast<int>(40 * random.uniform()))),
                            1e-20 * random.uniform());
    Wide turns = Wide(frequency) * (Wide(time.high) + Wide(time.low));
    turns -= floor(turns);
    const Circular found = circular(frequency, time);
    const Wide sine = Wide(found.sine.high) + Wide(found.sine.low);
    const Wide cosine = Wide(found.cosine.high) + Wide(found.cosine.low);
    // The product of frequency and time is rounded to 2^-104.
    const double tolerance = std::ldexp(1 + frequency * time.high, -97);
    ASSERT_LT(abs(sine - sin(turn * turns)), tolerance) << i;
    ASSERT_LT(abs(cosine - cos(turn * turns)), tolerance) << i;
  }
}

}  // namespace
}  // namespace hardball::sine_test
