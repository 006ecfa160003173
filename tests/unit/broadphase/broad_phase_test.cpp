// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What both broad phases owe the engine, on worlds in which spheres fly about and change their paths at will.
#include "hardball/broadphase/broad_phase.hpp"

#include <gtest/gtest.h>

#include <set>

#include "hardball/broadphase/all_pairs.hpp"
#include "hardball/broadphase/cell_grid.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/prediction/predictor.hpp"
#include "support/effort.hpp"
#include "support/random_world.hpp"

namespace hardball {
namespace {

using Partner = std::pair<Slot, std::array<std::int32_t, kAxes>>;

// What has been collected for a sphere at `now`, each with its copy. These worlds are so small that nothing
// may be collected twice.
std::set<Partner> partners(const Candidates& candidates, const World& world, const Time& now) {
  std::set<Partner> found;
  const Slot slot = candidates.self();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Slot other = candidates.slot(i);
    const Image image =
        candidates.are_nearest() ? nearest_image(world, slot, other, now) : candidates.image(i);
    EXPECT_NE(other, slot);
    EXPECT_TRUE(found.emplace(other, image.boxes).second) << "collected twice";
  }
  return found;
}

template <BroadPhase Phase>
std::set<Partner> candidates_of(const Phase& phase, const World& world, Slot slot,
                                const Time& now = Time(0)) {
  Candidates candidates;
  phase.collect(world, slot, candidates);
  EXPECT_EQ(candidates.self(), slot);
  return partners(candidates, world, now);
}

// All spheres and copies that touch the sphere now, found by looking at several boxes to all sides.
std::set<Partner> touching(const World& world, Slot slot, const Time& now) {
  std::set<Partner> found;
  for (Slot other = 0; other < world.size(); ++other) {
    if (other == slot) continue;
    const Vec3 apart = position_at(world.path(other), now) - position_at(world.path(slot), now);
    const double reach = world.radius(slot) + world.radius(other);
    Image middle;
    Image span;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!world.box().is_periodic(axis)) continue;
      middle[axis] = static_cast<std::int32_t>(-std::round(apart[axis] / world.box().size()[axis]));
      span[axis] = 2;
    }
    for (std::int32_t x = -span[0]; x <= span[0]; ++x) {
      for (std::int32_t y = -span[1]; y <= span[1]; ++y) {
        for (std::int32_t z = -span[2]; z <= span[2]; ++z) {
          const Image image = middle + Image{{x, y, z}};
          if (length(apart + world.box().shift(image)) <= reach) found.emplace(other, image.boxes);
        }
      }
    }
  }
  return found;
}

// Lets spheres cross cells and change direction for a while, through each other. Whenever a sphere comes to
// touch another, they must be candidates of each other, and crossings must have shown every candidate that is
// new.
template <BroadPhase Phase>
void fly_about(Phase phase, World world, double until, std::uint64_t seed) {
  Random random(seed);
  Time now(0);
  phase.build(world, now);
  std::vector<std::set<Partner>> known;
  std::vector<Time> crossings;
  Candidates entered;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    known.push_back(candidates_of(phase, world, slot, now));
    crossings.push_back(phase.next_crossing(world, slot, now));
  }
  const auto mirror = [](Slot slot, const Partner& partner) {
    return Partner{slot, {-partner.second[0], -partner.second[1], -partner.second[2]}};
  };
  constexpr int kSteps = 60;
  for (int step = 0; step < kSteps && world.size() > 0; ++step) {
    // The next crossing, or a change of path before it.
    Slot slot = 0;
    for (Slot other = 1; other < world.size(); ++other) {
      if (crossings[other] < crossings[slot]) slot = other;
    }
    const Time turn = after(now, until * random.uniform() / kSteps);
    ASSERT_GE(crossings[slot], now);
    if (crossings[slot] <= turn) {
      now = crossings[slot];
      phase.cross(world, slot, now, entered);
      ASSERT_EQ(entered.self(), slot);
      const std::set<Partner> shown = partners(entered, world, now);
      for (const Partner& partner : candidates_of(phase, world, slot, now)) {
        ASSERT_TRUE(known[slot].contains(partner) || known[partner.first].contains(mirror(slot, partner)) ||
                    shown.contains(partner));
      }
    } else {
      now = turn;
      slot = static_cast<Slot>(random.uniform() * static_cast<double>(world.size()));
      Vec3 velocity = world.path(slot).velocity;
      if (velocity == Vec3{}) velocity = {1, 0, 0};
      const Image folded = world.change_velocity(slot, now, length(velocity) * random.direction());
      phase.refresh(world, slot, now, folded);
    }
    crossings[slot] = phase.next_crossing(world, slot, now);
    phase.validate(world, now);
    for (Slot each = 0; each < world.size(); ++each) known[each] = candidates_of(phase, world, each, now);
    for (Slot each = 0; each < world.size(); ++each) {
      for (const Partner& partner : known[each]) {
        ASSERT_TRUE(known[partner.first].contains(mirror(each, partner))) << "one knows of the other";
      }
      for (const Partner& partner : touching(world, each, now)) {
        ASSERT_TRUE(known[each].contains(partner)) << "spheres " << each << " and " << partner.first;
      }
    }
  }
}

TEST(AllPairs, KnowsWhoMayTouch) {
  for (std::uint64_t seed = 0; seed < support::cases(300); ++seed) {
    const support::RandomWorld made = support::make_random_world(seed);
    SCOPED_TRACE(made.name);
    fly_about(AllPairs(), made.world, made.until, seed);
    if (HasFailure()) return;
  }
}

TEST(CellGrid, KnowsWhoMayTouch) {
  for (std::uint64_t seed = 0; seed < support::cases(300); ++seed) {
    const support::RandomWorld made = support::make_random_world(seed);
    SCOPED_TRACE(made.name);
    const double diameter = made.world.size() > 0 ? 2 * made.world.largest_radius() : 1;
    fly_about(CellGrid(diameter * (0.5 + static_cast<double>(seed % 7))), made.world, made.until, seed);
    if (HasFailure()) return;
  }
}

TEST(AllPairs, HasAllOthersAsCandidatesInABoxWithWalls) {
  World world(Box::walls({50, 50, 50}));
  for (int i = 0; i < 5; ++i) world.add({{5.0 + 9 * i, 25, 25}, {1, 0, 0}, 1, 1});
  AllPairs phase;
  phase.build(world, Time(0));
  for (Slot slot = 0; slot < 5; ++slot) {
    EXPECT_EQ(candidates_of(phase, world, slot).size(), 4U);
    EXPECT_EQ(phase.next_crossing(world, slot, Time(0)), kNever);
  }
}

TEST(CellGrid, HasOnlyNeighborsAsCandidates) {
  World world(Box::walls({50, 50, 50}));
  for (int i = 0; i < 5; ++i) world.add({{5.0 + 9 * i, 25, 25}, {1, 0, 0}, 1, 1});
  CellGrid grid(3);
  grid.build(world, Time(0));
  for (Slot slot = 0; slot < 5; ++slot) EXPECT_EQ(candidates_of(grid, world, slot).size(), 0U);
  CellGrid coarse(1000);
  coarse.build(world, Time(0));
  for (Slot slot = 0; slot < 5; ++slot) EXPECT_EQ(candidates_of(coarse, world, slot).size(), 4U);
}

TEST(CellGrid, CountsTheRowsOfCellsThatSpheresLeave) {
  World world;
  world.add({{0.5, 0.5, 0.5}, {1, 0, 0}, 0.25, 1});
  CellGrid grid(1);
  grid.build(world, Time(0));
  constexpr int kCrossings = 10;
  Candidates entered;
  Time next = grid.next_crossing(world, 0, Time(0));
  for (int i = 0; i < kCrossings; ++i) {
    grid.cross(world, 0, next, entered);
    next = grid.next_crossing(world, 0, next);
  }
  // It enters cell 10 when its front reaches 10; by then it has left cells 0 to 8.
  EXPECT_NEAR(next.value(), 10.25, 1e-6);
  EXPECT_EQ(grid.left_count(), 9U);
}

TEST(CellGrid, CountsNoRowAsLeftBecauseAPathIsFolded) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{9.5, 5.5, 5.5}, {1, 0, 0}, 0.25, 1});
  CellGrid grid(1);
  grid.build(world, Time(0));
  Candidates entered;
  for (Time next = grid.next_crossing(world, 0, Time(0)); next < Time(2);) {
    grid.cross(world, 0, next, entered);
    next = grid.next_crossing(world, 0, next);
  }
  // At 2 it stands at 11.5: in cell 11, having left cells 9 and, as soon as somebody looks, 10.
  const Image folded = world.change_velocity(0, Time(2), {0, 1, 0});
  ASSERT_EQ(folded, (Image{{1, 0, 0}}));
  const std::uint64_t left = grid.left_count();
  grid.refresh(world, 0, Time(2), folded);
  EXPECT_EQ(grid.left_count(), left);
  grid.validate(world, Time(2));
}

TEST(BroadPhase, NextCrossingIsNeverBeforeNow) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{5, 5, 5}, {1, 0, 0}, 0.25, 1});
  CellGrid grid(1);
  grid.build(world, Time(0));
  AllPairs pairs;
  pairs.build(world, Time(0));
  for (const Time& now : {Time(0), Time(9), Time(9, 1e-20)}) {
    EXPECT_GE(grid.next_crossing(world, 0, now), now);
    EXPECT_GE(pairs.next_crossing(world, 0, now), now);
  }
}

TEST(CellGrid, TakesNearestCopiesOnlyWhereTheBoxIsManyCellsWide) {
  // A sphere of diameter 1 touches at most two cells of edge 1.5 along an axis: two that share one lie less
  // than three cells apart, which is less than half a box of seven.
  const auto nearest_in = [](const Vec3& size, const std::array<Boundary, kAxes>& boundary) {
    World world(Box(boundary, size));
    world.add({{1, 1, 1}, {1, 0, 0}, 0.5, 1});
    CellGrid grid(1.5);
    grid.build(world, Time(0));
    return grid.has_nearest_images();
  };
  constexpr std::array kPeriodic = {Boundary::periodic, Boundary::periodic, Boundary::periodic};
  EXPECT_TRUE(nearest_in({10.5, 10.5, 10.5}, kPeriodic));
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (const double size : {1.5, 3.0, 4.5, 9.0, 10.4}) {
      Vec3 small{10.5, 10.5, 10.5};
      small[axis] = size;
      EXPECT_FALSE(nearest_in(small, kPeriodic)) << size;
      std::array<Boundary, kAxes> walled = kPeriodic;
      walled[axis] = Boundary::wall;
      EXPECT_TRUE(nearest_in(small, walled)) << "no copies along this axis";
      walled[axis] = Boundary::open;
      EXPECT_TRUE(nearest_in(small, walled));
    }
  }
}

// Where a box is only a few cells wide a sphere may meet several copies of another, or one that is not the
// nearest: each contact that all pairs know of before one of the two crosses must be known to the grid.
TEST(CellGrid, FindsEveryCopyInASmallBox) {
  std::uint64_t contacts = 0;
  std::uint64_t with_far_copies = 0;
  std::uint64_t with_several_copies = 0;
  for (std::uint64_t seed = 0; seed < support::cases(2000); ++seed) {
    const support::RandomWorld made =
        support::make_random_gas(seed, {Boundary::periodic, Boundary::periodic, Boundary::periodic}, 5);
    const World& world = made.world;
    if (world.size() == 0) continue;
    SCOPED_TRACE(made.name);
    CellGrid grid(2 * world.largest_radius() * (0.4 + 0.3 * static_cast<double>(seed % 7)));
    AllPairs pairs;
    grid.build(world, Time(0));
    pairs.build(world, Time(0));
    if (grid.has_nearest_images()) continue;
    std::vector<Time> crossings;
    for (Slot slot = 0; slot < world.size(); ++slot) {
      crossings.push_back(
          earlier(grid.next_crossing(world, slot, Time(0)), pairs.next_crossing(world, slot, Time(0))));
    }
    for (Slot slot = 0; slot < world.size(); ++slot) {
      const std::set<Partner> known = candidates_of(grid, world, slot);
      for (const auto& [other, boxes] : known)
        with_several_copies += known.count({other, {boxes[0] + 1, boxes[1], boxes[2]}});
      Candidates all;
      pairs.collect(world, slot, all);
      for (std::size_t i = 0; i < all.size(); ++i) {
        const Slot other = all.slot(i);
        const Time contact = contact_time(world, slot, other, all.image(i));
        if (contact == kNever || contact > earlier(crossings[slot], crossings[other])) continue;
        ++contacts;
        with_far_copies += all.image(i) == nearest_image(world, slot, other, Time(0)) ? 0U : 1U;
        ASSERT_TRUE(known.contains({other, all.image(i).boxes})) << "spheres " << slot << " and " << other;
      }
    }
  }
  // The worlds are such that all this happens.
  EXPECT_GT(contacts, support::cases(2000) / 4);
  EXPECT_GT(with_far_copies, support::cases(2000) / 100);
  EXPECT_GT(with_several_copies, support::cases(2000));
}

TEST(CellGrid, RefusesCellsThatAreTooSmall) {
  World world(Box::walls({10, 10, 10}));
  world.add({{5, 5, 5}, {}, 1, 1});
  for (const double edge : {0.0, -1.0, 0.01, std::numeric_limits<double>::quiet_NaN()}) {
    CellGrid grid(edge);
    EXPECT_THROW(grid.build(world, Time(0)), Error);
  }
  CellGrid grid(0.4);  // the remedy that the message names
  EXPECT_NO_THROW(grid.build(world, Time(0)));
}

TEST(CellGrid, NoticesASphereThatLeftItsCellsUnseen) {
  World world(Box::periodic({20, 20, 20}));
  world.add({{5, 5, 5}, {1, 0, 0}, 0.5, 1});
  CellGrid grid(1);
  grid.build(world, Time(0));
  EXPECT_NO_THROW(grid.validate(world, Time(0)));
  EXPECT_THROW(grid.validate(world, Time(3)), BrokenInvariant);
}

}  // namespace
}  // namespace hardball
