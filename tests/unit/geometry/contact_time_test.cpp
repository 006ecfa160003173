// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/geometry/contact_time.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"

namespace hardball::contact_time_test {
namespace {

// Wide enough for exact discriminants: products of four doubles.
using Exact = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<240, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

Exact dot_exactly(const Vec3& a, const Vec3& b) {
  return Exact(a.x) * b.x + Exact(a.y) * b.y + Exact(a.z) * b.z;
}

// The quadratic of a contact, without rounding.
struct Reference {
  Exact approach;      // r.v
  Exact excess;        // r.r - reach^2
  Exact discriminant;  // approach^2 - v.v excess
  Exact speed_squared;

  Reference(const Vec3& r, const Vec3& v, double reach)
      : approach(dot_exactly(r, v)),
        excess(dot_exactly(r, r) - Exact(reach) * reach),
        discriminant(approach * approach - dot_exactly(v, v) * excess),
        speed_squared(dot_exactly(v, v)) {}

  bool touches() const { return approach < 0 && (excess <= 0 || discriminant > 0); }
  Exact time() const { return excess <= 0 ? Exact(0) : Exact(excess / (sqrt(discriminant) - approach)); }
};

double ulp(double x) {
  return std::nextafter(x, kInfinity) - x;
}

struct Case {
  Vec3 separation;
  Vec3 velocity;
  double reach = 1;
};

// Two directions, not parallel, the second perpendicular to the first up to rounding.
struct Frame {
  Vec3 along;
  Vec3 across;
  explicit Frame(Random& random) : along(random.direction()) {
    Vec3 other;
    do {
      other = cross(along, random.direction());
    } while (length(other) < 0.1);
    across = (1 / length(other)) * other;
  }
};

// Passing at an impact parameter, from a distance, both in units of reach.
Case passing(Random& random, double distance, double impact) {
  const Frame frame(random);
  const double reach = 0.5 + random.uniform();
  const double speed = 0.1 + random.uniform();
  return {reach * (-distance * frame.along + impact * frame.across), speed * frame.along, reach};
}

double spread(Random& random, double low_exponent, double high_exponent) {
  return std::exp2(low_exponent + random.uniform() * (high_exponent - low_exponent));
}

Case make_case(Random& random, std::uint64_t kind) {
  switch (kind % 8) {
    case 0:  // anything
      return {3 * Vec3{random.normal(), random.normal(), random.normal()},
              {random.normal(), random.normal(), random.normal()},
              1};
    case 1:  // a hit from nearby
      return passing(random, 1 + 3 * random.uniform(), random.uniform());
    case 2:  // from far away
      return passing(random, spread(random, 0, 20), 1.2 * random.uniform());
    case 3:  // grazing within 1e-12 of reach
      return passing(random, 1 + 3 * random.uniform(), 1 + 1e-12 * (2 * random.uniform() - 1));
    case 4:  // grazing less or more, from afar too
      return passing(random, spread(random, 0, 20),
                     1 + spread(random, -50, -3) * (random.uniform() < 0.5 ? 1 : -1));
    case 5: {  // nearly touching
      const double gap = spread(random, -50, -5);
      const Vec3 direction = random.direction();
      return {(1 + gap) * direction, {random.normal(), random.normal(), random.normal()}, 1};
    }
    case 6: {  // in tiny and huge units
      Case scaled = passing(random, spread(random, 0, 10), 1.1 * random.uniform());
      const double scale = spread(random, -190, 190);
      return {scale * scaled.separation, spread(random, -190, 190) * scaled.velocity, scale * scaled.reach};
    }
    default: {  // slow across, fast along one axis
      Vec3 velocity = {random.normal(), random.normal() * 1e-8, random.normal() * 1e-16};
      return {{4 * random.normal(), random.normal(), random.normal()}, velocity, 1};
    }
  }
}

// Rounding may change the sign of r.v or of the gap only if they are this small; the error is then less than
// rounding may displace the spheres.
bool is_rounding_noise(const Reference& exact, const Case& c) {
  const double r2 = dot(c.separation, c.separation);
  const Exact approach_noise = 4 * kEpsilon * sqrt(Exact(r2) * exact.speed_squared);
  const Exact excess_noise = 4 * kEpsilon * Exact(r2);
  return abs(exact.approach) < approach_noise || abs(exact.excess) < excess_noise;
}

TEST(TimeToReach, IsAccurateToFourUlpsOfTheDistanceOverTheSpeed) {
  Random random(1);
  std::uint64_t contacts = 0;
  double worst = 0;
  for (std::uint64_t i = 0; i < support::cases(120000); ++i) {
    const Case c = make_case(random, i);
    const Reference exact(c.separation, c.velocity, c.reach);
    const double time = time_to_reach(c.separation, c.velocity, c.reach);
    // Whether there is a contact at all is decided correctly unless the discriminant is almost zero.
    const bool is_graze = abs(exact.discriminant) <= 1e-25 * exact.speed_squared * Exact(c.reach) * c.reach;
    if (is_graze || is_rounding_noise(exact, c)) continue;
    ASSERT_EQ(time < kInfinity, exact.touches()) << "case " << i;
    if (!exact.touches()) continue;
    ++contacts;
    // Rounding r.r and r.v, three products and two sums each, costs up to three epsilons; for distant spheres
    // all of it may add up, and an epsilon may be two units.
    const double scale = length(c.separation) / length(c.velocity);
    const bool is_near = length(c.separation) <= 4 * c.reach;
    const auto error =
        static_cast<double>(abs(exact.time() - time) / (is_near ? ulp(scale) : kEpsilon * scale));
    worst = std::max(worst, error);
    ASSERT_LE(error, 4) << "case " << i;
  }
  EXPECT_GT(contacts, support::cases(120000) / 5);
  RecordProperty("worst_error_in_epsilons", to_text(worst));
}

TEST(TimeToReach, IsTheSameSeenFromEitherSphere) {
  Random random(2);
  for (std::uint64_t i = 0; i < support::cases(50000); ++i) {
    const Case c = make_case(random, i);
    const double time = time_to_reach(c.separation, c.velocity, c.reach);
    ASSERT_TRUE(support::same_bits(time, time_to_reach(-c.separation, -c.velocity, c.reach))) << "case " << i;
  }
}

TEST(TimeToReach, ScalesExactlyWithPowersOfTwo) {
  Random random(3);
  for (std::uint64_t i = 0; i < support::cases(50000); ++i) {
    const Case c = make_case(random, i % 8 == 6 ? 0 : i);
    const double time = time_to_reach(c.separation, c.velocity, c.reach);
    for (const int exponent : {-60, 5, 60}) {
      const double scale = std::ldexp(1, exponent);
      ASSERT_TRUE(
          support::same_bits(scale * time, time_to_reach(scale * c.separation, c.velocity, scale * c.reach)));
      ASSERT_TRUE(support::same_bits(time / scale, time_to_reach(c.separation, scale * c.velocity, c.reach)));
    }
  }
}

TEST(TimeToReach, IsExactForHeadOnContactsInSimpleNumbers) {
  EXPECT_EQ(time_to_reach({3, 0, 0}, {-1, 0, 0}, 1), 2);
  EXPECT_EQ(time_to_reach({0, -5, 0}, {0, 0.5, 0}, 1.25), 7.5);
  EXPECT_EQ(time_to_reach({0, 0, 1e6}, {0, 0, -2}, 1), (1e6 - 1) / 2);
  // 3-4-5: contact where the separation is (3, 4, 0).
  EXPECT_EQ(time_to_reach({10, 4, 0}, {-1, 0, 0}, 5), 7);
}

TEST(TimeToReach, IsNowForOverlappingSpheresThatApproach) {
  Random random(4);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 separation = random.uniform() * random.direction();
    const Vec3 velocity = random.direction();
    const double time = time_to_reach(separation, velocity, 1.000001);
    ASSERT_EQ(time, dot(separation, velocity) < 0 ? 0 : kInfinity);
  }
  EXPECT_EQ(time_to_reach({1, 0, 0}, {-1e-9, 5, 0}, 1), 0) << "touching counts as within reach";
  EXPECT_EQ(time_to_reach({0.5, 0, 0}, {1, 0, 0}, 1), kInfinity) << "overlapping and receding";
}

TEST(TimeToReach, IsNeverWithoutApproach) {
  EXPECT_EQ(time_to_reach({2, 0, 0}, {0, 0, 0}, 1), kInfinity) << "at relative rest";
  EXPECT_EQ(time_to_reach({1, 0, 0}, {0, 0, 0}, 1), kInfinity) << "touching at relative rest";
  EXPECT_EQ(time_to_reach({2, 0, 0}, {0, 1, 0}, 1), kInfinity) << "at right angles";
  EXPECT_EQ(time_to_reach({1, 0, 0}, {0, 1, 0}, 1), kInfinity) << "touching, at right angles";
  EXPECT_EQ(time_to_reach({2, 0, 0}, {1, 0, 0}, 1), kInfinity) << "receding";
  EXPECT_EQ(time_to_reach({0, 0, 0}, {1, 0, 0}, 1), kInfinity) << "coincident";
}

TEST(TimeToReach, IsNeverForAnExactGraze) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    // Impact parameter and reach are the same dyadic number, so that the discriminant is exactly zero.
    const double reach = std::floor(1 + 1000 * random.uniform()) / 64;
    const double distance = std::floor(1 + 1000 * random.uniform()) / 16;
    const double speed = std::floor(1 + 1000 * random.uniform()) / 32;
    ASSERT_EQ(time_to_reach({distance, reach, 0}, {-speed, 0, 0}, reach), kInfinity);
    ASSERT_EQ(time_to_reach({0, distance, -reach}, {0, -speed, 0}, reach), kInfinity);
    // Slightly closer is a contact, slightly farther is not.
    ASSERT_LT(time_to_reach({distance, std::nextafter(reach, 0), 0}, {-speed, 0, 0}, reach), kInfinity);
    ASSERT_EQ(time_to_reach({distance, std::nextafter(reach, 1e9), 0}, {-speed, 0, 0}, reach), kInfinity);
  }
}

TEST(TimeToPlane, IsAccurateToOneUnitInTheLastPlace) {
  Random random(6);
  for (int i = 0; i < 20000; ++i) {
    const double distance = spread(random, -190, 190);
    const double speed = spread(random, -190, 190);
    const double time = time_to_plane(distance, speed);
    const Exact exact = Exact(distance) / speed;
    ASSERT_LE(static_cast<double>(abs(exact - time) / ulp(time)), 0.5);
  }
}

TEST(TimeToPlane, FollowsTheRulesOfContacts) {
  EXPECT_EQ(time_to_plane(3, 2), 1.5);
  EXPECT_EQ(time_to_plane(0, 2), 0) << "there already";
  EXPECT_EQ(time_to_plane(-1e-12, 2), 0) << "beyond and continuing";
  EXPECT_EQ(time_to_plane(3, 0), kInfinity) << "at rest";
  EXPECT_EQ(time_to_plane(3, -1), kInfinity) << "going away";
  EXPECT_EQ(time_to_plane(-3, -1), kInfinity) << "beyond and coming back";
}

TEST(ContactTime, IsComputedFromTheLaterPathAndTheSameInEitherOrder) {
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const auto path = [&random] {
      return Path{3 * random.direction(), random.direction(),
                  Time(random.uniform(), random.normal() * 1e-18)};
    };
    const Path a = path();
    const Path b = path();
    const Vec3 shift{8, 0, -8};
    const Motion motion(i % 2 == 0 ? Vec3{} : random.direction());
    const Time time = contact_time(motion, a, b, shift, 6);
    ASSERT_EQ(time, contact_time(motion, b, a, -shift, 6));
    ASSERT_GE(time, later(a.time, b.time));
    if (time == kNever) continue;
    // They are at reach then; positions of size 10, or as far as they fall, are rounded to some 1e-15 of it,
    // and dt to 4 ulp(12).
    const double fall = motion.is_straight() ? 0 : time.high * time.high;
    ASSERT_LT(length(separation_at(motion, a, b, shift, time)), 6 + 1e-13 + 1e-14 * fall);
  }
}

}  // namespace
}  // namespace hardball::contact_time_test
