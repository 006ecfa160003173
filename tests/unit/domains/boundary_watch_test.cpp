// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/boundary_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "hardball/domains/comparison.hpp"
#include "hardball/domains/wakeups.hpp"
#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"

namespace hardball::boundary_watch_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Times are rounded down.
constexpr double kRounding = 1e-8;

// Two blocks that meet at x = 5, with halos of depth two; spheres touch at distance one.
class BoundaryWatchTest : public testing::Test {
 protected:
  // An own sphere of the first that crosses the boundary from x = 3 at time zero to x = 7 at time two.
  static constexpr Leg kLeg{.begin = 0, .end = 2, .end_position = {7, 2, 2}, .end_velocity = {2, 0, 0}};

  Box box_ = Box::walls({10, 4, 4});
  Halo halo_{.depth = 2, .slack = 0.5, .contact = 1};
  Partition partition_ = Partition::grid(box_, {2, 1, 1}, {});
  BoundaryWatch first_{partition_, 0, halo_, Motion()};
  BoundaryWatch second_{partition_, 1, halo_, Motion()};
  std::vector<Outbox> outboxes_ = std::vector<Outbox>(1);
};

TEST_F(BoundaryWatchTest, KnowsSinceWhenASphereMayHaveMetOneNotHeld) {
  first_.begin(0);
  EXPECT_EQ(first_.far_since(), kInfinity);
  first_.record(kLeg, first_.distances(kLeg.end_position), 1, outboxes_);
  EXPECT_NEAR(first_.far_since(), 1.5, kRounding);
  EXPECT_LT(first_.far_since(), 1.5);
  EXPECT_EQ(first_.excursion(), 2);
  first_.begin(1.75);
  first_.record(kLeg, first_.distances(kLeg.end_position), 1, outboxes_);
  EXPECT_EQ(first_.far_since(), 1.75) << "from the start of the window on";
}

TEST_F(BoundaryWatchTest, TellsOfNewcomersThoseWhoDoNotHoldThem) {
  first_.begin(0);
  second_.begin(0);
  first_.record(kLeg, first_.distances(kLeg.end_position), 1, outboxes_);
  EXPECT_TRUE(outboxes_[0].near_passes.empty());
  first_.record(kLeg, first_.distances(kLeg.end_position), 0, outboxes_);
  ASSERT_EQ(outboxes_[0].near_passes.size(), 1U);
  const NearPass& pass = outboxes_[0].near_passes.front();
  EXPECT_NEAR(second_.time_within_guard(pass), 0.5, kRounding);
  EXPECT_LT(second_.time_within_guard(pass), 0.5);
  // An own sphere that has been half a unit outside may have met it earlier.
  std::vector<Outbox> others(1);
  const Leg out{.begin = 0, .end = 2, .end_position = {4.5, 2, 2}, .end_velocity = {}};
  second_.record(out, second_.distances(out.end_position), 1, others);
  EXPECT_NEAR(second_.time_within_guard(pass), 0.25, kRounding);
}

TEST_F(BoundaryWatchTest, DoesNotTellOfSpheresThatStayAway) {
  first_.begin(0);
  const Leg leg{.begin = 0, .end = 2, .end_position = {2.5, 2, 2}, .end_velocity = {1, 0, 0}};
  first_.record(leg, first_.distances(leg.end_position), 0, outboxes_);
  EXPECT_TRUE(outboxes_[0].near_passes.empty());
}

// A box of random boundaries, its partition, and a leg that may go around the box several times.
struct RandomLeg {
  explicit RandomLeg(std::uint64_t seed) : random(seed) {
    std::array<Boundary, kAxes> boundary;
    Vec3 size;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      boundary[axis] = random.uniform() < 0.7 ? Boundary::periodic : Boundary::open;
      size[axis] = 4 + 12 * random.uniform();
    }
    box = Box(boundary, size);
    std::vector<Vec3> centers(64);
    for (Vec3& center : centers) center = random_place(size);
    partition = Partition::bisection(box, 2 + random.bits() % 7, centers);
    halo.depth = 0.5 + 2 * random.uniform();
    halo.slack = 0.25;
    halo.contact = halo.depth * random.uniform();
    if (random.uniform() < 0.3) motion = Motion(0.5 * random.direction());
    leg.end = std::exp2(-3 + 6 * random.uniform());
    leg.end_position = random_place(size);
    leg.end_velocity = 4 * random.uniform() * random.direction();
  }

  Vec3 random_place(const Vec3& size) {
    return {size.x * random.uniform(), size.y * random.uniform(), size.z * random.uniform()};
  }
  Vec3 position(double time) const {
    const double wait = leg.end - time;
    Vec3 place = leg.end_position - wait * (leg.end_velocity - (0.5 * wait) * motion.gravity());
    box.fold(place);
    return place;
  }

  Random random;
  Box box = Box::periodic({1, 1, 1});
  Partition partition = Partition::grid(box, {1, 1, 1}, {});
  Halo halo;
  Motion motion;
  Leg leg;
};

// Many points of a leg, one by one.
TEST(BoundaryWatch, MissesNothingOnLegsOfAnyLength) {
  constexpr double kError = 1e-9;
  constexpr int kPoints = 500;
  std::uint64_t far = 0;
  std::uint64_t newcomers = 0;
  for (std::uint64_t seed = 0; seed < support::cases(10000); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomLeg made(seed);
    const auto own = static_cast<DomainNumber>(made.random.bits() % made.partition.size());
    BoundaryWatch boundary(made.partition, own, made.halo, made.motion);
    const std::vector<DomainNumber>& neighbors = boundary.neighbors();
    const auto holders = static_cast<NeighborSet>(made.random.bits());
    std::vector<Outbox> outboxes(neighbors.size());
    boundary.begin(0);
    boundary.record(made.leg, boundary.distances(made.leg.end_position), holders, outboxes);
    std::vector<BoundaryWatch> others;
    for (const DomainNumber neighbor : neighbors) {
      others.emplace_back(made.partition, neighbor, made.halo, made.motion).begin(0);
    }
    for (int point = 0; point <= kPoints; ++point) {
      const double time = made.leg.end * point / kPoints;
      const Vec3 place = made.position(time);
      const double outside = boundary.block().distance(place);
      ASSERT_LE(outside, std::max(0.0, boundary.excursion()) + kError);
      if (outside > made.halo.farthest() + kError) {
        ASSERT_LE(boundary.far_since(), time);
        ++far;
      }
      if (boundary.far_since() <= time) break;
      for (std::size_t k = 0; k < neighbors.size(); ++k) {
        if ((holders >> k & 1) != 0) continue;
        if (others[k].block().distance(place) > others[k].guard() - kError) continue;
        ASSERT_FALSE(outboxes[k].near_passes.empty());
        ASSERT_LE(others[k].time_within_guard(outboxes[k].near_passes.front()), time);
        ++newcomers;
      }
    }
  }
  EXPECT_GT(far, support::cases(10000) / 10);
  EXPECT_GT(newcomers, support::cases(10000) / 10);
}

// The later of the moments at which two spheres began to differ, if their cubes come within a contact.
TEST(TimeOfConflict, IsThatOfTwoSpheresThatMayHaveMet) {
  const Box box = Box::periodic({10, 10, 10});
  const Halo halo{.depth = 2, .slack = 0.5, .contact = 1};
  const std::vector<Conflict> own{{.since = 3, .center = {0.5, 5, 5}, .extent = 0.25}};
  const auto time = [&](double x, double since) {
    return time_of_conflict(box, halo, own, std::vector<Conflict>{{since, {x, 5, 5}, 0.5}});
  };
  EXPECT_EQ(time(2.25, 1), 3);
  EXPECT_EQ(time(2.25, 4), 4);
  EXPECT_EQ(time(2.26, 4), kInfinity);
  EXPECT_EQ(time(8.75, 4), 4) << "across the end of the period";
  EXPECT_EQ(time(8.74, 4), kInfinity);
  EXPECT_EQ(time_of_conflict(box, halo, own, {}), kInfinity);
}

Wakeups::Wakeup wakeup(Slot slot, double time) {
  return {.time = time, .slot = slot, .path = Time(0)};
}

std::vector<Slot> taken_by(Wakeups& wakeups, double until) {
  std::vector<Wakeups::Wakeup> taken;
  wakeups.take(until, taken);
  std::vector<Slot> slots;
  for (const Wakeups::Wakeup& each : taken) slots.push_back(each.slot);
  std::ranges::sort(slots);
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
  return slots;
}

TEST(Wakeups, AreTakenOnceWhenTheyAreDue) {
  Wakeups wakeups;
  wakeups.restart(0, 10);
  wakeups.set(wakeup(0, 5));
  wakeups.set(wakeup(1, 1));
  wakeups.set(wakeup(2, 5.001));
  EXPECT_EQ(taken_by(wakeups, 0.5), std::vector<Slot>{});
  EXPECT_EQ(taken_by(wakeups, 5), (std::vector<Slot>{0, 1}));
  EXPECT_EQ(taken_by(wakeups, 10), std::vector<Slot>{2});
  EXPECT_EQ(taken_by(wakeups, 10), std::vector<Slot>{});
}

TEST(Wakeups, AreSetUpToNoTimeBeforeTheFirstStart) {
  EXPECT_LT(Wakeups().horizon(), std::numeric_limits<double>::lowest());
}

TEST(Wakeups, OfASphereAreAsEarlyAsTheFirst) {
  Wakeups wakeups;
  wakeups.restart(0, 10);
  wakeups.set(wakeup(0, 3));
  wakeups.set(wakeup(0, 8));
  EXPECT_EQ(taken_by(wakeups, 4), std::vector<Slot>{0});
  EXPECT_EQ(taken_by(wakeups, 10), std::vector<Slot>{}) << "whoever takes a wakeup sets the next";
  wakeups.set(wakeup(1, 9.5));
  wakeups.restart(10, 20);
  wakeups.set(wakeup(1, 18));
  wakeups.set(wakeup(1, 12));
  EXPECT_EQ(taken_by(wakeups, 13), std::vector<Slot>{1});
  EXPECT_EQ(taken_by(wakeups, 20), std::vector<Slot>{}) << "the later one no longer counts";
}

// No sphere is looked at too late, whatever is set, taken and set again; against the least time
// that was set for each.
TEST(Wakeups, AreNeverLate) {
  constexpr Slot kSlots = 40;
  constexpr double kHorizon = 100;
  Random random(1);
  Wakeups wakeups;
  wakeups.restart(0, kHorizon);
  std::vector<double> due(kSlots, 2 * kHorizon);
  double now = 0;
  while (now < kHorizon) {
    for (int k = 0; k < 30; ++k) {
      const auto slot = static_cast<Slot>(random.uniform() * kSlots);
      const double time = now + random.uniform() * random.uniform() * (kHorizon - now);
      wakeups.set(wakeup(slot, time));
      due[slot] = std::min(due[slot], time);
    }
    now = std::min(now + random.uniform(), kHorizon);
    for (const Slot slot : taken_by(wakeups, now)) due[slot] = 2 * kHorizon;
    for (Slot slot = 0; slot < kSlots; ++slot) ASSERT_GT(due[slot], now) << slot;
  }
}

}  // namespace
}  // namespace hardball::boundary_watch_test
