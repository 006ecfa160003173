// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/geometry/time.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "hardball/geometry/double_double.hpp"
#include "hardball/numbers/random.hpp"

namespace hardball::time_test {
namespace {

using Exact = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<400, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

Exact exactly(const Time& time) {
  return Exact(time.high) + Exact(time.low);
}

double spread(Random& random, double low_exponent, double high_exponent) {
  return std::exp2(low_exponent + random.uniform() * (high_exponent - low_exponent));
}

Time random_time(Random& random) {
  return after(Time(spread(random, -20, 60)), spread(random, -60, 20));
}

TEST(Time, AfterLosesAtMostTheLastOf106Bits) {
  Random random(1);
  for (int i = 0; i < 30000; ++i) {
    const Time start = random_time(random);
    const double wait = spread(random, -80, 70);
    const Time end = after(start, wait);
    const Exact exact = exactly(start) + wait;
    ASSERT_LE(abs(exactly(end) - exact), exact * Exact(0x1p-105));
    ASSERT_EQ(end.high, static_cast<double>(exactly(end))) << "high is the nearest double";
    ASSERT_GE(end, start);
  }
}

TEST(Time, AfterIsExactAsLongAsTheSumFits) {
  const Time later_on = after(after(Time(1), 0x1p-60), 0x1p-80);
  EXPECT_EQ(later_on.high, 1);
  EXPECT_EQ(later_on.low, 0x1p-60 + 0x1p-80);
  EXPECT_EQ(after(Time(0.25), 0.5), Time(0.75));
  EXPECT_EQ(after(Time(0), 5e-324), Time(5e-324));
}

TEST(Time, DurationIsAccurateToTwoUnitsInTheLastPlaceOrToTheResolution) {
  Random random(2);
  for (int i = 0; i < 30000; ++i) {
    const Time a = random_time(random);
    const Time b = random.uniform() < 0.5 ? random_time(random) : after(a, spread(random, -60, 10));
    const double time = duration(a, b);
    const Exact exact = exactly(b) - exactly(a);
    const double unit = std::nextafter(std::fabs(time), 1e300) - std::fabs(time);
    const Exact resolution = (exactly(a) + exactly(b)) * Exact(0x1p-106);
    ASSERT_LE(abs(exact - time), 2 * Exact(unit) + resolution) << "case " << i;
    ASSERT_EQ(duration(b, a), -time);
  }
}

TEST(Time, WaitsComeBackAsDurations) {
  Random random(3);
  for (int i = 0; i < 30000; ++i) {
    const Time start = random_time(random);
    // The 106 bits of the time hold the 53 of the wait.
    const double wait = start.high * spread(random, -45, 0);
    const double back = duration(start, after(start, wait));
    ASSERT_LE(std::fabs(back - wait), 2 * (std::nextafter(wait, 1e300) - wait));
  }
}

TEST(Time, IsAsPreciseAfterALongRunAsAtItsStart) {
  const Time late(1e12);
  const Time a = after(late, 0.1);
  const Time b = after(a, 1e-17);
  EXPECT_LT(a, b);
  EXPECT_EQ(a.high, b.high) << "a double cannot distinguish them";
  // 1e12 is resolved to 1e12 * 2^-106 = 1.2e-20.
  EXPECT_NEAR(duration(a, b), 1e-17, 2.5e-20);
  EXPECT_NEAR(duration(late, a), 0.1, 2.8e-17);
}

TEST(Time, OrderIsThatOfTheExactSums) {
  Random random(4);
  for (int i = 0; i < 20000; ++i) {
    const Time a = random_time(random);
    const Time b = random.uniform() < 0.3 ? a : after(a, spread(random, -150, 0));
    ASSERT_EQ(a < b, exactly(a) < exactly(b));
    ASSERT_EQ(a == b, exactly(a) == exactly(b));
    ASSERT_EQ(later(a, b), b);
    ASSERT_EQ(earlier(a, b), a);
  }
}

TEST(Time, NeverIsLaterThanAllOthers) {
  EXPECT_LT(Time(1e308), kNever);
  EXPECT_EQ(after(Time(5), std::numeric_limits<double>::infinity()), kNever);
  EXPECT_EQ(after(Time(1.7e308), 1.7e308), kNever) << "a sum that overflows";
  EXPECT_EQ(after(kNever, 1), kNever);
  EXPECT_EQ(earlier(kNever, Time(2)), Time(2));
}

TEST(Time, ScalesExactlyWithPowersOfTwo) {
  Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const Time start = random_time(random);
    const double wait = spread(random, -60, 60);
    const Time end = after(start, wait);
    for (const double scale : {0x1p-40, 0x1p40}) {
      ASSERT_EQ(after(Time(scale * start.high, scale * start.low), scale * wait),
                Time(scale * end.high, scale * end.low));
    }
  }
}

TEST(DoubleDouble, SumsAndProductsOfDoublesAreExact) {
  Random random(6);
  for (int i = 0; i < 20000; ++i) {
    const double a = random.normal() * spread(random, -60, 60);
    const double b = random.normal() * spread(random, -60, 60);
    const DoubleDouble s = sum(a, b);
    const DoubleDouble p = product(a, b);
    ASSERT_EQ(Exact(s.high) + s.low, Exact(a) + b);
    ASSERT_EQ(Exact(p.high) + p.low, Exact(a) * b);
  }
}

Exact exactly(const DoubleDouble<>& a) {
  return Exact(a.high) + a.low;
}

bool is_normalized(const DoubleDouble<>& a) {
  return a.high == static_cast<double>(exactly(a));
}

TEST(DoubleDouble, NormalizedIsTheSameNumberWithTheNearestDoubleInFront) {
  Random random(8);
  for (int i = 0; i < 20000; ++i) {
    const double high = random.normal() * spread(random, -60, 60);
    const double low = high * (2 * random.uniform() - 1) * spread(random, -80, 0);
    const DoubleDouble found = normalized(high, low);
    ASSERT_EQ(exactly(found), Exact(high) + low);
    ASSERT_TRUE(is_normalized(found));
  }
  EXPECT_EQ(normalized(1, -1).high, 0);
  EXPECT_EQ(normalized(0, 0).low, 0);
}

TEST(DoubleDouble, ArithmeticKeepsAbout106Bits) {
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const DoubleDouble a = sum(random.normal(), random.normal() * 0x1p-54);
    DoubleDouble b = sum(random.normal() * spread(random, -30, 30), random.normal() * 0x1p-90);
    // Sometimes of the same size, so that most of a difference cancels.
    if (i % 3 == 0) b = normalized(a.high * (1 + random.normal() * spread(random, -60, -2)), b.low * 0x1p-30);
    const Exact magnitude = abs(exactly(a)) + abs(exactly(b));
    ASSERT_LE(abs(exactly(a - b) - (exactly(a) - exactly(b))), magnitude * Exact(0x1p-103));
    ASSERT_LE(abs(exactly(a * b) - exactly(a) * exactly(b)), abs(exactly(a) * exactly(b)) * Exact(0x1p-101));
    ASSERT_TRUE(is_normalized(a - b));
    ASSERT_TRUE(is_normalized(a * b));
  }
}

TEST(DoubleDouble, DifferenceOfProductsIsAccurateTo104BitsOfTheLargerProduct) {
  Random random(9);
  for (int i = 0; i < 50000; ++i) {
    const double a = random.normal() * spread(random, -40, 40);
    const double b = random.normal() * spread(random, -40, 40);
    const double c = random.normal() * spread(random, -40, 40);
    double d = random.normal() * spread(random, -40, 40);
    // Two thirds of the time of similar size, or with most of the difference canceling.
    if (i % 3 == 1) d = a * b / c * (random.uniform() < 0.5 ? -1 : 1) * (0.5 + random.uniform());
    if (i % 3 == 2) d = a * b / c * (1 + random.normal() * spread(random, -56, -2));
    const DoubleDouble found = difference_of_products(a, b, c, d);
    const Exact exact = Exact(a) * b - Exact(c) * d;
    const Exact magnitude = std::max(abs(Exact(a) * b), abs(Exact(c) * d));
    ASSERT_LE(abs(exactly(found) - exact), magnitude * Exact(0x1p-104)) << "case " << i;
    ASSERT_TRUE(is_normalized(found)) << "case " << i;
  }
  const DoubleDouble nothing = difference_of_products(0.1, 0.3, 0.3, 0.1);
  EXPECT_EQ(nothing.high, 0);
  EXPECT_EQ(nothing.low, 0);
}

TEST(DoubleDouble, SumOfThreeIsAccurateTo103BitsOfTheLargest) {
  Random random(10);
  const auto any = [&random] {
    const double high = random.normal() * spread(random, -8, 8);
    return sum(high, high * random.normal() * 0x1p-55);
  };
  for (int i = 0; i < 50000; ++i) {
    const DoubleDouble a = any();
    const DoubleDouble b = any();
    DoubleDouble c = any();
    // Half of the time most of the sum cancels.
    if (i % 2 == 1) {
      const double whole = -(a.high + b.high) * (1 + random.normal() * spread(random, -60, -2));
      c = sum(whole, whole * random.normal() * 0x1p-55);
    }
    const DoubleDouble found = sum_of_three(a, b, c);
    const Exact exact = exactly(a) + exactly(b) + exactly(c);
    const Exact magnitude = std::max({abs(exactly(a)), abs(exactly(b)), abs(exactly(c))});
    ASSERT_LE(abs(exactly(found) - exact), magnitude * Exact(0x1p-103)) << "case " << i;
    ASSERT_TRUE(is_normalized(found)) << "case " << i;
  }
}

}  // namespace
}  // namespace hardball::time_test
