// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/geometry/sine_cosine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "hardball/geometry/rotation_matrix.hpp"
#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"

namespace hardball::sine_cosine_test {
namespace {

// Many more digits than doubles have, so that reduction of large angles does not matter.
using Precise = boost::multiprecision::cpp_bin_float_100;

double error_of(double angle) {
  const SineCosine found = sine_cosine(angle);
  const Precise sine = sin(Precise(angle)) - Precise(found.sine);
  const Precise cosine = cos(Precise(angle)) - Precise(found.cosine);
  return std::max(std::fabs(sine.convert_to<double>()), std::fabs(cosine.convert_to<double>()));
}

TEST(SineCosine, ErrsByLessThanItSays) {
  constexpr double kMostError = 1e-16;
  Random random(1);
  const std::uint64_t count = support::cases(5000);
  for (const double most : {1.0, 1000.0, 1.5e6, 1e9, 1e15}) {
    for (std::uint64_t i = 0; i < count; ++i) {
      const double angle = most * (2 * random.uniform() - 1);
      EXPECT_LT(error_of(angle), kMostError) << angle;
    }
  }
}

TEST(SineCosine, IsPreciseNearQuarterTurns) {
  Random random(2);
  for (std::uint64_t i = 0; i < support::cases(5000); ++i) {
    const double quarters = std::floor(1e6 * random.uniform());
    const double angle = quarters * 0x1.921fb54442d18p+0;
    EXPECT_LT(error_of(angle), 1e-16) << angle;
    EXPECT_LT(error_of(std::nextafter(angle, 0)), 1e-16) << angle;
  }
}

TEST(SineCosine, IsExactAtZeroAndOddAndEven) {
  EXPECT_EQ(sine_cosine(0).sine, 0);
  EXPECT_EQ(sine_cosine(0).cosine, 1);
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const double angle = 100 * random.uniform();
    EXPECT_EQ(sine_cosine(-angle).sine, -sine_cosine(angle).sine) << angle;
    EXPECT_EQ(sine_cosine(-angle).cosine, sine_cosine(angle).cosine) << angle;
  }
}

TEST(SineCosine, OfAnglesWithoutPhaseIsThatOfZero) {
  for (const double angle : {1e300, -HUGE_VAL, std::nan("")}) {
    EXPECT_EQ(sine_cosine(angle).sine, 0);
    EXPECT_EQ(sine_cosine(angle).cosine, 1);
  }
}

TEST(RotationMatrix, TurnsZIntoAnyDirection) {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 direction = random.direction();
    const RotationMatrix rotation = RotationMatrix::of_z_into(direction);
    EXPECT_TRUE(rotation.is_sound());
    EXPECT_LT(length(rotation.turned({0, 0, 1}) - direction), 1e-15);
    EXPECT_LT(length(rotation.turned_back(rotation.turned({1, 2, 3})) - Vec3{1, 2, 3}), 1e-14);
  }
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, -1}, Vec3{-1, 0, 0}}) {
    const RotationMatrix rotation = RotationMatrix::of_z_into(axis);
    EXPECT_TRUE(rotation.is_sound());
    EXPECT_EQ(rotation.turned({0, 0, 1}), axis);
    EXPECT_EQ(rotation.inverse().turned(axis), (Vec3{0, 0, 1}));
  }
}

TEST(RotationMatrix, OfAnglesIsThatOfTheQuaternion) {
  const RotationMatrix yaw = RotationMatrix::from_angles(0, 0, 0.3);
  const auto [sine, cosine] = sine_cosine(0.15);
  EXPECT_LT(length(yaw.x - RotationMatrix::from_quaternion(cosine, 0, 0, sine).x), 1e-15);
  // Roll comes first.
  const double quarter = 0x1.921fb54442d18p+0;
  EXPECT_LT(length(RotationMatrix::from_angles(quarter, 0, quarter).turned({0, 0, 1}) - Vec3{1, 0, 0}),
            1e-15);
  EXPECT_LT(length(RotationMatrix::from_angles(0, quarter, 0).turned({0, 0, 1}) - Vec3{1, 0, 0}), 1e-15);
}

}  // namespace
}  // namespace hardball::sine_cosine_test
