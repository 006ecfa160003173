// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/interaction/restitution_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hardball/errors/error.hpp"

namespace hardball::restitution_law_test {
namespace {

TEST(ViscoelasticRestitution, HasTheGivenValueAtTheGivenSpeed) {
  for (const double value : {0.01, 0.3, 0.8, 0.999, 1.0}) {
    for (const double speed : {1e-20, 0.1, 1.0, 1e30}) {
      EXPECT_NEAR(ViscoelasticRestitution(value, speed).at(speed), value, 1e-14);
    }
  }
}

TEST(ViscoelasticRestitution, DecreasesFromOneWithTheFifthRootOfTheSpeed) {
  const ViscoelasticRestitution law(0.8, 1);
  EXPECT_EQ(law.at(0), 1);
  double last = 1;
  for (double speed = 1e-30; speed < 1e6; speed *= 3) {
    const double value = law.at(speed);
    EXPECT_LT(value, last);
    last = value;
  }
  // Of slow impacts the loss is proportional to u^(1/5).
  EXPECT_NEAR((1 - law.at(1e-35)) / (1 - law.at(1e-40)), 10, 1e-3);
}

// The first terms of the exact series, 1 - 1.15344 x^2 + 0.79826 x^4, with x^2 = b u^(1/5).
// Source: Schwager and Poeschel, Phys. Rev. E 57 (1998) 650.
TEST(ViscoelasticRestitution, AgreesWithTheSeriesOfSlowImpacts) {
  const double square = 0.01;
  const double series = 1 - 1.15344 * square + 0.79826 * square * square;
  const ViscoelasticRestitution law(series, 1);
  const double smaller = square / 10;
  EXPECT_NEAR(law.at(1e-5), 1 - 1.15344 * smaller + 0.79826 * smaller * smaller, 3e-5);
}

TEST(TabulatedRestitution, IsLinearBetweenPointsAndConstantBeyond) {
  const TabulatedRestitution law({{1, 0.75}, {3, 0.25}, {5, 0.5}});
  EXPECT_EQ(law.at(0), 0.75);
  EXPECT_EQ(law.at(1), 0.75);
  EXPECT_EQ(law.at(2), 0.5);
  EXPECT_EQ(law.at(3), 0.25);
  EXPECT_EQ(law.at(4), 0.375);
  EXPECT_EQ(law.at(5), 0.5);
  EXPECT_EQ(law.at(100), 0.5);
}

TEST(RestitutionLaws, RefuseWhatIsOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ViscoelasticRestitution(1.1, 1), Error);
  EXPECT_THROW(ViscoelasticRestitution(0, 1), Error);
  EXPECT_THROW(ViscoelasticRestitution(0.5, 0), Error);
  EXPECT_THROW(ViscoelasticRestitution(nan, 1), Error);
  EXPECT_THROW(TabulatedRestitution(std::vector<TabulatedRestitution::Point>()), Error);
  EXPECT_THROW(TabulatedRestitution({{0, 1.5}}), Error);
  EXPECT_THROW(TabulatedRestitution({{-1, 0.5}}), Error);
  EXPECT_THROW(TabulatedRestitution({{1, 0.5}, {1, 0.6}}), Error);
  EXPECT_THROW(TabulatedRestitution({{nan, 0.5}}), Error);
}

}  // namespace
}  // namespace hardball::restitution_law_test
