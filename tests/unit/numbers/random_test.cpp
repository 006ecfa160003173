// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/numbers/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/effort.hpp"

namespace hardball::random_test {
namespace {

// A second implementation of the algorithms, after Vigna's C code.
struct Reference {
  std::uint64_t s[4];
  explicit Reference(std::uint64_t x) {
    for (std::uint64_t& word : s) {
      std::uint64_t z = (x += 0x9e3779b97f4a7c15);
      z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
      z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
      word = z ^ (z >> 31);
    }
  }
  static std::uint64_t rotl(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }
  std::uint64_t next() {
    const std::uint64_t result = rotl(s[0] + s[3], 23) + s[0];
    const std::uint64_t t = s[1] << 17;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= t;
    s[3] = rotl(s[3], 45);
    return result;
  }
};

TEST(Random, IsXoshiro256PlusPlusSeededBySplitMix64) {
  for (const std::uint64_t seed : {0ULL, 1ULL, 42ULL, 0xffffffffffffffffULL}) {
    Random random(seed);
    Reference reference(seed);
    for (int i = 0; i < 100; ++i) ASSERT_EQ(random.bits(), reference.next());
  }
  // The first output for seed 0, as given by other implementations.
  EXPECT_EQ(Random(0).bits(), 0x53175d61490b23dfULL);
}

// Sample moments of n numbers are held to five standard errors, with fixed seeds.
TEST(Random, UniformNumbersFillTheUnitInterval) {
  Random random(1);
  const auto n = static_cast<double>(support::cases(1000000));
  double sum = 0;
  double squares = 0;
  for (double i = 0; i < n; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    ASSERT_EQ(u * 0x1p53, std::floor(u * 0x1p53));
    sum += u;
    squares += u * u;
  }
  EXPECT_NEAR(sum / n, 0.5, 5 * std::sqrt(1.0 / 12 / n));
  EXPECT_NEAR(squares / n, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / n));
}

TEST(Random, NormalNumbersHaveTheMomentsOfAGaussian) {
  Random random(2);
  const auto n = static_cast<double>(support::cases(1000000));
  std::array<double, 5> power_sums{};
  for (double i = 0; i < n; ++i) {
    const double x = random.normal();
    double power = 1;
    for (double& sum : power_sums) {
      sum += power;
      power *= x;
    }
  }
  // The variances of x, x^2, x^3 and x^4 are 1, 2, 15 and 96.
  EXPECT_NEAR(power_sums[1] / n, 0, 5 * std::sqrt(1 / n));
  EXPECT_NEAR(power_sums[2] / n, 1, 5 * std::sqrt(2 / n));
  EXPECT_NEAR(power_sums[3] / n, 0, 5 * std::sqrt(15 / n));
  EXPECT_NEAR(power_sums[4] / n, 3, 5 * std::sqrt(96 / n));
}

TEST(Random, DirectionsAreUnitVectorsWithoutPreference) {
  Random random(3);
  const auto n = static_cast<double>(support::cases(300000));
  Vec3 sum;
  Vec3 squares;
  for (double i = 0; i < n; ++i) {
    const Vec3 d = random.direction();
    ASSERT_NEAR(dot(d, d), 1, 1e-14);
    sum += d;
    squares += {d.x * d.x, d.y * d.y, d.z * d.z};
  }
  // The variance of a component is 1/3, that of its square 4/45.
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    EXPECT_NEAR(sum[axis] / n, 0, 5 * std::sqrt(1 / (3 * n)));
    EXPECT_NEAR(squares[axis] / n, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / n));
  }
}

TEST(PortableLog, IsWithinThreeUnitsInTheLastPlaceOfTheTruth) {
  // The sum, the quotient, the series and two products round by half a unit each.
  Random random(4);
  for (std::uint64_t i = 0; i < support::cases(200000); ++i) {
    // Uniform ones as in normal(), ones near one, and all magnitudes.
    const double u = random.uniform();
    const double x = i % 3 == 0 ? u : i % 3 == 1 ? 1 + (u - 0.5) * 0x1p-8 : std::exp2(2000 * u - 1000);
    if (x == 0) continue;
    const auto truth = std::log(static_cast<long double>(x));
    const double unit =
        std::nextafter(std::fabs(static_cast<double>(truth)), 1e300) - std::fabs(static_cast<double>(truth));
    ASSERT_LE(std::fabs(static_cast<double>(portable_log(x) - truth)), 3 * unit) << x;
  }
  EXPECT_EQ(portable_log(1), 0);
}

TEST(PortableExp, IsWithinTwoUnitsInTheLastPlaceOfTheTruth) {
  Random random(5);
  for (std::uint64_t i = 0; i < support::cases(200000); ++i) {
    // Arguments near zero, those of radii, and all that give normal numbers.
    const double u = 2 * random.uniform() - 1;
    const double x = i % 3 == 0 ? u * 0x1p-8 : i % 3 == 1 ? 4 * u : 708 * u;
    const long double truth = std::exp(static_cast<long double>(x));
    const auto nearest = static_cast<double>(truth);
    const double unit = std::nextafter(nearest, 1e308) - nearest;
    ASSERT_LE(std::fabs(static_cast<double>(portable_exp(x) - truth)), 2 * unit) << x;
  }
  EXPECT_EQ(portable_exp(0), 1);
  EXPECT_EQ(portable_exp(1e9), std::numeric_limits<double>::infinity());
  EXPECT_EQ(portable_exp(-1e9), 0);
  EXPECT_GT(portable_exp(-744), 0);
  EXPECT_LT(portable_exp(709.7), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace hardball::random_test
