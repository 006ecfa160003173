// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/large_sizes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <vector>

#include "hardball/broadphase/approach_list.hpp"
#include "hardball/numbers/random.hpp"

namespace hardball::large_spheres_test {
namespace {

TEST(LargeSizes, CountTheCellsOfSurfacesOfAnyRadius) {
  constexpr double kThickness = 2 * LargeSizes::kSkin + 0.75;
  for (const double radius : {1e3, 1e6, 1e12, 1e20}) {
    const double ring = LargeSizes::cells_of_surface(radius, 2) / radius;
    const double shell = LargeSizes::cells_of_surface(radius, 3) / (radius * radius);
    EXPECT_NEAR(ring, 4 + 2 * std::numbers::pi * kThickness, 0.02) << radius;
    EXPECT_NEAR(shell, 3 * std::numbers::pi + 4 * std::numbers::pi * kThickness, 0.05) << radius;
  }
}

// One sphere of each of these radii among so many of radius .1.
std::optional<LargeSizes> sizes_in(double box, const std::vector<double>& radii, std::size_t others) {
  World world(Box::periodic({box, box, box}));
  for (const double radius : radii) world.add({{1, 1, 1}, {}, radius, 1});
  for (std::size_t i = 0; i < others; ++i) world.add({{2, 2, 2}, {}, 0.1, 1});
  return LargeSizes::in(world, Subdivision(world.box(), 1));
}

TEST(LargeSizes, AreOfAllThatDoNotFitIfTheseAreFew) {
  const std::optional<LargeSizes> sizes = sizes_in(40, {0.45, 0.7, 3, 2}, 5000);
  ASSERT_TRUE(sizes);
  EXPECT_EQ(sizes->largest_in_grid, 0.45);
  EXPECT_EQ(sizes->largest, 3);
  EXPECT_EQ(sizes->second_largest, 2);
  EXPECT_EQ(sizes->skin, LargeSizes::kSkin);
  EXPECT_EQ(sizes->surfaces, LargeSizes::cells_of_surface(3, 3) + LargeSizes::cells_of_surface(2, 3) +
                                 LargeSizes::cells_of_surface(0.7, 3));
  EXPECT_GT(sizes->farthest, 3 + 2 + 2 * sizes->skin);
}

TEST(LargeSizes, AreOfTheLargestIfManyDoNotFit) {
  const std::optional<LargeSizes> sizes = sizes_in(40, {0.45, 0.7, 3, 2}, 100);
  ASSERT_TRUE(sizes);
  EXPECT_EQ(sizes->largest_in_grid, 0.7);
  EXPECT_EQ(sizes->surfaces, LargeSizes::cells_of_surface(3, 3) + LargeSizes::cells_of_surface(2, 3));
}

TEST(LargeSizes, DoNotExistWhereNoSphereIsLargeOrTheBoxIsSmall) {
  EXPECT_FALSE(sizes_in(40, {}, 100));
  EXPECT_FALSE(sizes_in(40, {0.45}, 5000));
  EXPECT_TRUE(sizes_in(40, {0.7}, 5000));
  EXPECT_FALSE(sizes_in(40, {0.7}, 10)) << "not much larger than a cell, and not few";
  EXPECT_FALSE(sizes_in(40, {3, 3}, 1)) << "more are large than not";
  EXPECT_FALSE(sizes_in(10, {3, 3}, 5000)) << "candidates may be half a box apart";
}

// A part of a world may have none of its large spheres, or nothing else.
TEST(LargeSizes, AreOfAnyPartOfAWorldThatTheCellsSuit) {
  const Subdivision cells(Box::periodic({40, 40, 40}), 1);
  const auto sizes_of_part = [&](const std::vector<double>& radii) {
    World part(Box::periodic({40, 40, 40}));
    for (const double radius : radii) part.add({{1, 1, 1}, {}, radius, 1});
    return LargeSizes::in_part(part, cells);
  };
  EXPECT_EQ(sizes_of_part({0.45, 3, 0.1, 0.1, 0.1}).value().largest, 3);
  EXPECT_EQ(sizes_of_part({3, 3}).value().second_largest, 3);
  EXPECT_EQ(sizes_of_part({0.45, 0.1}).value().largest_in_grid, 0.45);
  EXPECT_EQ(sizes_of_part({0.1, 0.1}).value().largest, 0);
  EXPECT_TRUE(sizes_of_part({}));
  EXPECT_FALSE(sizes_of_part({15, 15})) << "candidates may be half a box apart";
}

TEST(LargeSizes, LeaveLessSkinInASmallBox) {
  const std::optional<LargeSizes> sizes = sizes_in(20, {4.9, 4.9}, 5000);
  ASSERT_TRUE(sizes);
  EXPECT_DOUBLE_EQ(sizes->skin, (0.495 * 20 - 2 * 4.9) / 4);
}

constexpr double kRadius = 5;
constexpr double kSkin = 1;
constexpr double kUsualSpeed = 2;

// A large sphere in slot 0, and others near its surface, slower than the usual speed but for each tenth.
class Approach : public testing::Test {
 protected:
  Approach() {
    Random random(3);
    world_.add({kCenter, {0.1, 0, 0}, kRadius, 1000});
    for (int i = 0; i < 600; ++i) {
      const double distance = kRadius + 0.1 + 2.5 * random.uniform();
      const double speed = (i % 10 == 0 ? 20 : 0.9) * kUsualSpeed * random.uniform();
      world_.add({kCenter + distance * random.direction(), speed * random.direction(), 0.1, 1});
    }
    copies_.reset(world_, 15, Time(0));
    large_.reset(world_.size());
    large_.set(0, true);
  }

  Candidates others(std::size_t count) const {
    Candidates candidates;
    candidates.begin(0, true);
    for (Slot slot = 1; slot <= count; ++slot) candidates.add(slot);
    candidates.end();
    return candidates;
  }
  void make(const Candidates& all) {
    list_.make({world_, copies_, large_, kUsualSpeed, kSkin}, 0, {0.25, 0, 0}, Time(0), all);
  }
  bool has(Slot slot) const { return std::ranges::count(list_.slots(), slot) > 0; }
  // The least gap to the surface of the large one until the list expires [L].
  double least_gap(Slot slot) const {
    double least = kSkin * 100;
    for (int i = 0; i <= 1000; ++i) {
      const Time time(list_.expiry() * i / 1000);
      least =
          std::min(least, length(world_.position(slot, time) - kCenter) - kRadius - world_.base_radius(slot));
    }
    return least;
  }

  static constexpr Vec3 kCenter{20, 20, 20};
  World world_{Box::periodic({40, 40, 40})};
  CompactPaths copies_;
  SlotSet large_;
  ApproachList list_;
};

TEST_F(Approach, IsNotListedForFewCandidates) {
  make(others(ApproachList::kMinToList - 1));
  EXPECT_FALSE(list_.exists());
  list_.add(7);
  EXPECT_FALSE(list_.exists());
  make(others(ApproachList::kMinToList));
  EXPECT_TRUE(list_.exists());
}

TEST_F(Approach, IsListedIfItIsInTime) {
  make(others(600));
  ASSERT_TRUE(list_.exists());
  EXPECT_GT(list_.expiry(), 0);
  EXPECT_EQ(list_.middle(), (Vec3{0.25, 0, 0}));
  EXPECT_GT(list_.skin(), 0);
  EXPECT_LE(list_.skin(), ApproachList::kGreatestDepth * kSkin);
  std::size_t listed = 0;
  for (Slot slot = 1; slot <= 600; ++slot) {
    EXPECT_TRUE(has(slot) || least_gap(slot) >= list_.skin()) << slot;
    listed += has(slot) ? 1U : 0U;
  }
  EXPECT_GT(listed, 0U);
  EXPECT_LT(listed, 300U) << "most are far away";
}

TEST_F(Approach, OfALargeSphereIsAlwaysListed) {
  large_.set(600, true);
  make(others(600));
  EXPECT_TRUE(has(600));
}

TEST_F(Approach, IsListedInWholeVectors) {
  make(others(600));
  for (const Slot added : {1000U, 1001U, 1002U}) {
    list_.add(added);
    EXPECT_EQ(list_.slots().back(), added);
    const Slot* padding = list_.slots().data() + list_.slots().size();
    EXPECT_TRUE(std::all_of(padding, padding + Candidates::kPadding, [](Slot slot) { return slot == 0; }));
  }
  list_.replace(1001, 5000);
  EXPECT_TRUE(has(1000) && has(5000) && !has(1001));
  // The large sphere is in another slot.
  list_.replace(0, 6000);
  list_.add(1003);
  EXPECT_EQ(*(list_.slots().data() + list_.slots().size()), 6000U);
}

TEST_F(Approach, IsListedFartherIfListsAreHardlyUsed) {
  make(others(600));
  const double first = list_.expiry();
  make(others(600));
  EXPECT_DOUBLE_EQ(list_.expiry(), 1.5 * first) << "without a contact, searching was all the cost";
  for (int i = 0; i < 10000; ++i) list_.note_contact();
  make(others(600));
  EXPECT_DOUBLE_EQ(list_.expiry(), first);
}

}  // namespace
}  // namespace hardball::large_spheres_test
