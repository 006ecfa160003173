// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/contact_extrapolation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hardball::contact_extrapolation_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The means of a density over bins, weighted with (radius + gap)^2, by the midpoint rule.
template <class Density>
ContactExtrapolation::Bins means(const ContactExtrapolation& contact, double radius, const Density& density) {
  constexpr int kSteps = 1000;
  ContactExtrapolation::Bins means{};
  for (std::size_t bin = 0; bin < means.size(); ++bin) {
    double sum = 0;
    double weights = 0;
    for (int step = 0; step < kSteps; ++step) {
      const double gap = (static_cast<double>(bin) + (step + 0.5) / kSteps) * contact.bin_width();
      const double weight = std::isinf(radius) ? 1 : (radius + gap) * (radius + gap);
      sum += weight * density(gap);
      weights += weight;
    }
    means[bin] = sum / weights;
  }
  return means;
}

TEST(ContactExtrapolation, IsExactForCubics) {
  const auto cubic = [](double gap) { return 5 - 30 * gap + 80 * gap * gap - 90 * gap * gap * gap; };
  for (const double radius : {1.0, 0.3, kInfinity}) {
    const ContactExtrapolation contact(0.3, radius, 3);
    EXPECT_NEAR(contact.at_contact(means(contact, radius, cubic)), 5, 1e-5) << radius;
  }
}

// As steep as the pair density of the fluid at freezing, which falls by the factor exp(-8 gap / diameter).
TEST(ContactExtrapolation, FollowsTheSteepestFluid) {
  const ContactExtrapolation contact(ContactExtrapolation::kReach, 1, 3);
  const auto steep = [](double gap) { return 5.7 * std::exp(-8 * gap); };
  EXPECT_NEAR(contact.at_contact(means(contact, 1, steep)) / 5.7, 1, 1e-3);
}

TEST(ContactExtrapolation, KnowsTheBinOfAGap) {
  const ContactExtrapolation contact(0.3, kInfinity, 3);
  EXPECT_DOUBLE_EQ(contact.bin_width(), 0.02);
  EXPECT_EQ(contact.bin(0.01), 0U);
  EXPECT_EQ(contact.bin(0.05), 2U);
  EXPECT_EQ(contact.bin(-1e-15), 0U) << "an overlap by rounding";
  EXPECT_EQ(contact.bin(-0.01), ContactExtrapolation::kBins);
  EXPECT_EQ(contact.bin(0.299), 14U);
  EXPECT_EQ(contact.bin(0.3), ContactExtrapolation::kBins);
}

}  // namespace
}  // namespace hardball::contact_extrapolation_test
