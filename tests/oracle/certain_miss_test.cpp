// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Whether spheres that pass each other touch, against exact arithmetic: the fast decisions of time_to_reach,
// a certain miss and a contact that needs no more digits, must never be wrong.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "hardball/geometry/contact_time.hpp"
#include "hardball/geometry/grazing_time.hpp"
#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"

namespace hardball::certain_miss_test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;  // 113 bits
// Represents the discriminant, a sum of products of four doubles, exactly if their exponents are not far
// apart.
using Exact = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<400, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

template <class Number>
Number dot_in(const Vec3& a, const Vec3& b) {
  return Number(a.x) * b.x + Number(a.y) * b.y + Number(a.z) * b.z;
}

// The discriminant as a fraction of (reach * |velocity|)^2: the squared cosine of a contact.
template <class Number>
Number squared_cosine(const Vec3& r, const Vec3& v, double reach) {
  const Number approach = dot_in<Number>(r, v);
  const Number speed_squared = dot_in<Number>(v, v);
  const Number reach_squared = Number(reach) * reach;
  return (approach * approach - speed_squared * (dot_in<Number>(r, r) - reach_squared)) /
         (speed_squared * reach_squared);
}

struct Passing {
  Vec3 separation;
  Vec3 velocity;
  double reach = 1;
};

double spread(Random& random, double low_exponent, double high_exponent) {
  return std::exp2(low_exponent + random.uniform() * (high_exponent - low_exponent));
}

// With an impact parameter within `closeness` of reach, on either side, from a distance of 1 to 2^30 reaches.
Passing passing(Random& random, double closeness) {
  const Vec3 along = random.direction();
  Vec3 across;
  do {
    across = cross(along, random.direction());
  } while (length(across) < 0.1);
  across = (1 / length(across)) * across;
  const double reach = 0.5 + random.uniform();
  const double impact = 1 + closeness * (random.uniform() < 0.5 ? 1 : -1);
  const double distance = spread(random, -6, 30);
  return {reach * (impact * across - distance * along), spread(random, -10, 10) * along, reach};
}

TEST(CertainMiss, IsNeverAContact) {
  Random random(1);
  std::uint64_t contacts = 0;
  std::uint64_t misses = 0;
  for (std::uint64_t i = 0; i < support::cases(150000); ++i) {
    const Passing p = passing(random, spread(random, -54, -1));
    if (!(dot(p.separation, p.separation) > 1.001 * p.reach * p.reach)) continue;
    const auto cosine = squared_cosine<Exact>(p.separation, p.velocity, p.reach);
    // The grazing formula has some 106 bits, for a discriminant that decreases with the square of the
    // distance.
    const double distance = length(p.separation) / p.reach;
    if (abs(cosine) <= 0x1p-98 * distance * distance) continue;
    const double time = time_to_reach(p.separation, p.velocity, p.reach);
    ASSERT_EQ(time<std::numeric_limits<double>::infinity(), cosine> 0)
        << "case " << i << ", distance " << distance << ", squared cosine " << static_cast<double>(cosine);
    ++(cosine > 0 ? contacts : misses);
  }
  EXPECT_GT(contacts, support::cases(150000) / 4);
  EXPECT_GT(misses, support::cases(150000) / 4);
}

// The bound itself: the rounding error of the discriminant.
TEST(CertainMiss, LiesBeyondTheRoundingErrorOfTheDiscriminant) {
  Random random(2);
  double worst = 0;
  for (std::uint64_t i = 0; i < support::cases(100000); ++i) {
    const Passing p = passing(random, spread(random, -54, -4));
    if (!(dot(p.separation, p.separation) > p.reach * p.reach)) continue;
    const double speed_squared = dot(p.velocity, p.velocity);
    const double closest = speed_squared * (p.reach * p.reach);
    const Vec3 angular = cross(p.separation, p.velocity);
    const double discriminant = closest - dot(angular, angular);
    const auto exact = static_cast<Quad>(squared_cosine<Exact>(p.separation, p.velocity, p.reach) *
                                         dot_in<Exact>(p.velocity, p.velocity) * p.reach * p.reach);
    const Quad error = abs(Quad(discriminant) - exact) / (speed_squared * dot(p.separation, p.separation));
    worst = std::max(worst, static_cast<double>(error));
  }
  EXPECT_LT(worst, kCertainMiss / 2);
  // If the bound were far too large, every miss would be computed twice.
  EXPECT_GT(worst, kCertainMiss / 256);
  RecordProperty("worst_error", std::to_string(worst / kCertainMiss));
}

// An ordinary miss is recognized without more digits.
TEST(CertainMiss, IsTheUsualCase) {
  Random random(3);
  std::uint64_t misses = 0;
  std::uint64_t certain = 0;
  for (std::uint64_t i = 0; i < support::cases(20000); ++i) {
    const double impact = 1 + 3 * random.uniform();
    const double distance = 1 + 10 * random.uniform();
    const Vec3 r = impact * Vec3{0, 1, 0} - distance * Vec3{1, 0, 0};
    const Vec3 v{1, 0, 0};
    const Vec3 angular = cross(r, v);
    ++misses;
    certain += 1 - dot(angular, angular) < -kCertainMiss * dot(r, r) ? 1U : 0U;
  }
  EXPECT_GE(certain + 1, misses);
}

}  // namespace
}  // namespace hardball::certain_miss_test
