// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "bench/discrete_checks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "bench/power_law.hpp"
#include "bench/time_stepped.hpp"
#include "hardball/numbers/random.hpp"

namespace hardball::bench::bench_test {
namespace {

Contact collision(const Vec3& normal, double reach, const Vec3& first, const Vec3& second) {
  Contact contact;
  contact.separation = reach * normal;
  contact.reach = reach;
  contact.before = {first, second};
  return contact;
}

TEST(OverlapDuration, OfAHeadOnCollisionIsTwoDiameters) {
  EXPECT_DOUBLE_EQ(overlap_duration(collision({1, 0, 0}, 2, {3, 0, 0}, {-1, 0, 0})), 2 * 2 / 4.);
}

TEST(OverlapDuration, EndsWhereTheSpheresPartAgain) {
  const Contact contact = collision({0.6, 0.8, 0}, 3, {2, 1, 0.5}, {-1, 0.25, 2});
  const Vec3 velocity = contact.before.second - contact.before.first;
  const double duration = overlap_duration(contact);
  EXPECT_GT(duration, 0);
  EXPECT_NEAR(length(contact.separation + duration * velocity), 3, 1e-14);
}

TEST(IsSeen, RequiresACheckDuringTheOverlap) {
  EXPECT_TRUE(is_seen(0.9, 0.2, 0.5));
  EXPECT_FALSE(is_seen(0.6, 0.3, 0.5));
  EXPECT_TRUE(is_seen(0.6, 0.5, 0.5)) << "no overlap longer than a step is missed";
  EXPECT_TRUE(is_seen(-0.1, 0.2, 0.5));
}

TEST(ExpectedMissedShare, IsThatOfTheCriterion) {
  // Random collisions: flux-weighted relative speeds, impact parameters uniform in area. Four standard
  // errors.
  constexpr int kCollisions = 100'000;
  Random random(1);
  for (const double advance : {0.3, 1.0, 4.0}) {
    int missed = 0;
    for (int i = 0; i < kCollisions; ++i) {
      // u^3 exp(-u^2) is the distribution of the length of a vector of four normal components of variance
      // 1/2.
      double square = 0;
      for (int k = 0; k < 4; ++k) {
        const double component = random.normal();
        square += component * component / 2;
      }
      const double cosine = std::sqrt(random.uniform());
      const Vec3 direction{-cosine, std::sqrt(1 - cosine * cosine), 0};
      const Contact contact = collision({1, 0, 0}, 1, {}, advance * std::sqrt(square) * direction);
      if (!is_seen(random.uniform(), overlap_duration(contact), 1)) ++missed;
    }
    const double expected = expected_missed_share(advance);
    EXPECT_NEAR(missed / static_cast<double>(kCollisions), expected, 4 * std::sqrt(expected / kCollisions));
  }
}

TEST(ExpectedMissedShare, GrowsWithTheSquareOfASmallStep) {
  // For steps so small that no pair passes in one: <u^2> = 2, and so 2 (advance / 2)^2 / 3.
  EXPECT_NEAR(expected_missed_share(0.01), 0.01 * 0.01 / 6, 1e-9);
}

TEST(MissedCounter, CountsCollisionsByStep) {
  MissedCounter counter({0.1, 10});
  Contact contact = collision({1, 0, 0}, 1, {1, 0, 0}, {-1, 0, 0});
  contact.time = Time(3);
  counter.record(contact);
  contact.kind = EventKind::wall;
  counter.record(contact);
  MissedCounter sum({0.1, 10});
  sum.add(counter);
  sum.add(counter);
  EXPECT_EQ(sum.collisions(), 2U);
  EXPECT_EQ(sum.missed()[0], 0U);
  EXPECT_EQ(sum.missed()[1], 2U);
  EXPECT_DOUBLE_EQ(sum.share(1), 1);
}

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

World two_spheres(const Vec3& first_velocity, const Vec3& second_velocity) {
  World world(Box::walls({20, 10, 10}));
  world.add({.position = {5, 5, 5}, .velocity = first_velocity, .radius = 1});
  world.add({.position = {8, 5, 5}, .velocity = second_velocity, .radius = 1});
  return world;
}

TEST(TimeStepped, ResolvesACollisionOnce) {
  TimeStepped simulation(two_spheres({1, 0, 0}, {}), Time(0));
  EXPECT_EQ(simulation.step(0.9), 0U) << "not there yet";
  EXPECT_EQ(simulation.step(0.2), 1U);
  EXPECT_EQ(simulation.step(0.05), 0U) << "they overlap but part";
}

TEST(TimeStepped, StepsOverACollisionThatIsTooShort) {
  TimeStepped simulation(two_spheres({10, 0, 0}, {}), Time(0));
  EXPECT_EQ(simulation.step(0.6), 0U);
}

TEST(TimeStepped, ReflectsAtWalls) {
  // The first goes to the wall at 0 and back, and meets the second where it was.
  TimeStepped simulation(two_spheres({-4, 0, 0}, {}), Time(0));
  EXPECT_EQ(simulation.step(1), 0U);
  EXPECT_EQ(simulation.step(1), 0U);
  EXPECT_EQ(simulation.step(0.4), 1U);
}

}  // namespace
}  // namespace hardball::bench::bench_test
