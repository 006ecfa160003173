// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/comparison.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace hardball::comparison_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The first of two domains that meet at x = 10: it owns sphere 0, and holds sphere 1 of the other, as well as
// 2, which is a ghost, too.
class ComparisonTest : public testing::Test {
 protected:
  explicit ComparisonTest(const Box& box = Box::walls({20, 6, 4})) : world_(box) {
    world_.add({.position = {8, 2, 2}, .radius = 0.5});
    world_.add({.position = {11, 2, 2}, .radius = 0.5});
    world_.add({.position = {11, 3.5, 2}, .radius = 0.5});
    ownership_.add_own(1);
    ownership_.add_ghost(1, 0);
    ownership_.add_ghost(2, 0);
    boundary_.begin(0);
  }

  // What a contact with a partner did to a ghost.
  static PathRecord record(SphereId ghost, SphereId partner, double time) {
    const Path path{.position = {11, 2, 2}, .velocity = {1, 0, 0}, .time = Time(time)};
    return {.path = path,
            .spin = {},
            .time = Time(time),
            .sphere = ghost,
            .partner = partner,
            .is_partner_own = partner == 0};
  }
  GhostRecord noted(const PathRecord& record) const {
    const Slot slot = world_.slot_of(record.sphere);
    return {record, world_.path(slot), world_.spin(slot), ownership_.find_ghost(record.sphere)};
  }
  double compare(const std::vector<GhostRecord>& own, const std::vector<PathRecord>& of_owner) {
    Outbox inbox;
    inbox.records = of_owner;
    const Outbox* const inboxes[] = {&inbox};
    outboxes_ = std::vector<Outbox>(1);
    return comparison_.compare(world_, ownership_, boundary_, own, inboxes, 0, 4, outboxes_);
  }

  World world_;
  OwnershipMap ownership_;
  Partition partition_ = Partition::grid(world_.box(), {2, 1, 1}, {});
  BoundaryWatch boundary_{partition_, 0, {.depth = 2, .slack = 0.5, .contact = 1}, Motion()};
  Comparison comparison_;
  std::vector<Outbox> outboxes_;
};

TEST_F(ComparisonTest, FindsNothingWhereBothHaveTheSame) {
  const PathRecord same = record(1, 0, 1);
  EXPECT_EQ(compare({noted(same)}, {same}), kInfinity);
  EXPECT_TRUE(comparison_.corrections().empty());
  EXPECT_EQ(compare({}, {}), kInfinity);
}

TEST_F(ComparisonTest, FindsAContactWithAnOwnSphereThatTheOwnerDoesNotHave) {
  EXPECT_EQ(compare({noted(record(1, 2, 1)), noted(record(1, 0, 3))}, {}), 3);
  ASSERT_EQ(comparison_.corrections().size(), 1U);
  EXPECT_EQ(comparison_.corrections().front().path, world_.path(1)) << "as it was before";
}

TEST_F(ComparisonTest, FindsAContactWithAnOwnSphereThatOnlyTheOwnerHas) {
  EXPECT_EQ(compare({}, {record(1, 7, 1), record(1, 0, 2)}), 2);
  ASSERT_EQ(comparison_.corrections().size(), 1U);
  EXPECT_EQ(comparison_.corrections().front().path, record(1, 0, 2).path) << "as the owner says";
}

// From the first difference on, but not before.
TEST_F(ComparisonTest, TrustsContactsThatBothHave) {
  const PathRecord same = record(1, 0, 1);
  EXPECT_EQ(compare({noted(same), noted(record(1, 0, 2))}, {same}), 2);
  EXPECT_EQ(compare({noted(same)}, {same, record(1, 0, 3)}), 3);
}

// The order in which simultaneous contacts of different spheres are noted says nothing.
TEST_F(ComparisonTest, DoesNotMindTheOrderOfSimultaneousContacts) {
  const PathRecord first = record(1, 0, 2);
  const PathRecord second = record(2, 0, 2);
  EXPECT_EQ(compare({noted(first), noted(second)}, {second, first}), kInfinity);
  EXPECT_TRUE(comparison_.corrections().empty());
  EXPECT_TRUE(outboxes_[0].conflicts.empty());
}

// A ghost that differs takes none of the others with it.
TEST_F(ComparisonTest, CorrectsOnlyWhatDiffers) {
  const PathRecord same = record(2, 0, 2);
  EXPECT_EQ(compare({noted(record(1, 7, 1)), noted(same)}, {record(1, 7, 1.5), same}), kInfinity);
  ASSERT_EQ(comparison_.corrections().size(), 1U);
  EXPECT_EQ(comparison_.corrections().front().ghost, ownership_.find_ghost(1));
}

// A contact of ghosts matters where they come near the block: there the owner is told of the
// conflict, and since when there has been one.
TEST_F(ComparisonTest, ReportsGhostsThatDifferNearTheBlock) {
  EXPECT_EQ(compare({noted(record(1, 2, 1))}, {record(1, 2, 1.5)}), kInfinity);
  ASSERT_EQ(outboxes_[0].conflicts.size(), 1U);
  const Conflict& conflict = outboxes_[0].conflicts.front();
  EXPECT_EQ(conflict.since, 1);
  // It flies from x = 11 on, to x = 13.5 at the end of the window.
  EXPECT_EQ(conflict.center, (Vec3{11, 2, 2}));
  EXPECT_EQ(conflict.extent, 2.5);
}

class ComparisonInPeriodicBoxTest : public ComparisonTest {
 protected:
  ComparisonInPeriodicBoxTest() : ComparisonTest(Box::periodic({20, 6, 4})) {}
};

// It flies by more than half of the box along an axis that is not divided: its place at the end is nearer to
// where it was than it has been.
TEST_F(ComparisonInPeriodicBoxTest, KnowsHowFarAGhostHasFlownAroundTheBox) {
  const PathRecord found = record(1, 2, 1);
  PathRecord told = found;
  told.path.velocity = {0, 1.75, 0};
  EXPECT_EQ(compare({noted(found)}, {told}), kInfinity);
  ASSERT_EQ(outboxes_[0].conflicts.size(), 1U);
  EXPECT_EQ(outboxes_[0].conflicts.front().extent, 5.25);
}

}  // namespace
}  // namespace hardball::comparison_test
