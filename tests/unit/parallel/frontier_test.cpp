// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/parallel/frontier.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "hardball/parallel/comparison.hpp"

namespace hardball::frontier_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Times are rounded down.
constexpr double kRounding = 1e-8;

// Two blocks that meet at x = 5, with halos of depth two; spheres touch at distance one.
class FrontierTest : public testing::Test {
 protected:
  // An own sphere of the first that crosses the frontier from x = 3 at time zero to x = 7 at time two.
  static constexpr Leg kLeg{.begin = 0, .end = 2, .end_position = {7, 2, 2}, .end_velocity = {2, 0, 0}};

  Box box_ = Box::walls({10, 4, 4});
  Halo halo_{.depth = 2, .slack = 0.5, .contact = 1};
  Partition partition_ = Partition::grid(box_, {2, 1, 1}, {});
  Frontier first_{partition_, 0, halo_, Motion()};
  Frontier second_{partition_, 1, halo_, Motion()};
  std::vector<Outbox> outboxes_ = std::vector<Outbox>(1);
};

TEST_F(FrontierTest, KnowsSinceWhenASphereMayHaveMetOneNotHeld) {
  first_.begin(0);
  EXPECT_EQ(first_.far_since(), kInfinity);
  first_.note(kLeg, first_.distances(kLeg.end_position), 1, outboxes_);
  EXPECT_NEAR(first_.far_since(), 1.5, kRounding);
  EXPECT_LT(first_.far_since(), 1.5);
  EXPECT_EQ(first_.excursion(), 2);
  first_.begin(1.75);
  first_.note(kLeg, first_.distances(kLeg.end_position), 1, outboxes_);
  EXPECT_EQ(first_.far_since(), 1.75) << "from the start of the window on";
}

TEST_F(FrontierTest, TellsOfNewcomersThoseWhoDoNotHoldThem) {
  first_.begin(0);
  second_.begin(0);
  first_.note(kLeg, first_.distances(kLeg.end_position), 1, outboxes_);
  EXPECT_TRUE(outboxes_[0].flights.empty());
  first_.note(kLeg, first_.distances(kLeg.end_position), 0, outboxes_);
  ASSERT_EQ(outboxes_[0].flights.size(), 1U);
  const Flight& flight = outboxes_[0].flights.front();
  EXPECT_NEAR(second_.time_within_guard(flight), 0.5, kRounding);
  EXPECT_LT(second_.time_within_guard(flight), 0.5);
  // An own sphere that has been half a unit outside may have met it earlier.
  std::vector<Outbox> others(1);
  const Leg out{.begin = 0, .end = 2, .end_position = {4.5, 2, 2}, .end_velocity = {}};
  second_.note(out, second_.distances(out.end_position), 1, others);
  EXPECT_NEAR(second_.time_within_guard(flight), 0.25, kRounding);
}

TEST_F(FrontierTest, DoesNotTellOfSpheresThatStayAway) {
  first_.begin(0);
  const Leg leg{.begin = 0, .end = 2, .end_position = {2.5, 2, 2}, .end_velocity = {1, 0, 0}};
  first_.note(leg, first_.distances(leg.end_position), 0, outboxes_);
  EXPECT_TRUE(outboxes_[0].flights.empty());
}

// The later of the moments at which two spheres began to differ, if their cubes come within a contact.
TEST(TimeOfDoubt, IsThatOfTwoSpheresThatMayHaveMet) {
  const Box box = Box::periodic({10, 10, 10});
  const Halo halo{.depth = 2, .slack = 0.5, .contact = 1};
  const std::vector<Doubt> own{{.since = 3, .center = {0.5, 5, 5}, .extent = 0.25}};
  const auto time = [&](double x, double since) {
    return time_of_doubt(box, halo, own, std::vector<Doubt>{{since, {x, 5, 5}, 0.5}});
  };
  EXPECT_EQ(time(2.25, 1), 3);
  EXPECT_EQ(time(2.25, 4), 4);
  EXPECT_EQ(time(2.26, 4), kInfinity);
  EXPECT_EQ(time(8.75, 4), 4) << "across the end of the period";
  EXPECT_EQ(time(8.74, 4), kInfinity);
  EXPECT_EQ(time_of_doubt(box, halo, own, {}), kInfinity);
}

}  // namespace
}  // namespace hardball::frontier_test
