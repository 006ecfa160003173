// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/placement/free_space.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace hardball::free_space_test {
namespace {

constexpr std::size_t kMany = 1000000;

struct Ball {
  Vec3 center;
  double radius;
};

// A box of one kind with some spheres in it, which may overlap, and where one more may be.
struct Crowd {
  Box box;
  Region centers;
  double least_radius = 0.5;
  std::vector<Ball> balls;

  Crowd(Boundary boundary, const Vec3& size, std::size_t count, Random& random)
      : box({boundary, boundary, boundary}, size) {
    const double inset = boundary == Boundary::periodic ? 0 : least_radius;
    centers = {{inset, inset, inset}, size - Vec3{inset, inset, inset}};
    for (std::size_t i = 0; i < count; ++i) balls.push_back({place(random), 0.5 + random.uniform()});
  }

  Vec3 place(Random& random) const {
    Vec3 place;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      place[axis] = centers.low[axis] + random.uniform() * (centers.high[axis] - centers.low[axis]);
    }
    return place;
  }

  Vec3 separation(const Ball& ball, const Vec3& place) const {
    const Vec3 apart = ball.center - place;
    return apart - box.shift(box.nearest_image(apart));
  }

  // A ball that leaves no room for a sphere of this radius; null if there is none.
  const Ball* overlapping(const Vec3& place, double radius) const {
    for (const Ball& ball : balls) {
      if (length(separation(ball, place)) < ball.radius + radius) return &ball;
    }
    return nullptr;
  }

  FreeSpace make_space(double edge, std::size_t most_voxels = kMany) const {
    FreeSpace space(box, centers, least_radius, edge, most_voxels);
    for (const Ball& ball : balls) space.exclude(ball.center, ball.radius);
    return space;
  }
};

TEST(FreeSpace, ExcludesNoCenterWithRoomAndMostOfTheOthers) {
  for (const Boundary boundary : {Boundary::periodic, Boundary::wall}) {
    // The first box is so small that spheres touch their own images.
    for (const Vec3& size : {Vec3{2.5, 2.6, 2.7}, Vec3{5, 9, 7}, Vec3{40, 3, 3}}) {
      Random random(21);
      const Crowd crowd(boundary, size, size.x < 3 ? 1 : 25, random);
      const FreeSpace space = crowd.make_space(0.1);
      int without_room = 0;
      int excluded = 0;
      for (int i = 0; i < 20000; ++i) {
        const Vec3 place = crowd.place(random);
        const bool has_room = crowd.overlapping(place, crowd.least_radius) == nullptr;
        ASSERT_FALSE(has_room && space.is_excluded(place));
        without_room += has_room ? 0 : 1;
        excluded += space.is_excluded(place) ? 1 : 0;
      }
      EXPECT_GT(without_room, 2000);
      EXPECT_GT(excluded, 0.8 * without_room);
    }
  }
}

TEST(FreeSpace, HasNoMoreVoxelsThanAllowed) {
  Random random(22);
  const Crowd crowd(Boundary::wall, {9, 9, 9}, 5, random);
  FreeSpace space = crowd.make_space(1e-9, 1);
  EXPECT_FALSE(space.is_excluded({4, 4, 4})) << "one voxel, which no sphere covers";
  space.list();
  for (int i = 0; i < 100; ++i) {
    const FreeSpace::Draw draw = space.draw(random);
    EXPECT_EQ(draw.level, 0U);
    EXPECT_EQ(draw.index, 0U);
  }
}

TEST(FreeSpace, DrawsEvenlyAmongTheCentersWithRoom) {
  constexpr std::size_t kParts = 4;
  for (const Boundary boundary : {Boundary::periodic, Boundary::wall}) {
    Random random(23);
    const Crowd crowd(boundary, {6, 6, 6}, 30, random);
    FreeSpace space = crowd.make_space(1.5);
    space.list();
    // Counts of centers in parts of the region: by voxels, and by trying anywhere.
    std::array<double, kParts * kParts * kParts> by_voxels{};
    std::array<double, kParts * kParts * kParts> anywhere{};
    const auto part = [&](const Vec3& place) {
      std::size_t index = 0;
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const double width = crowd.centers.high[axis] - crowd.centers.low[axis];
        index = kParts * index +
                static_cast<std::size_t>(kParts * (place[axis] - crowd.centers.low[axis]) / width);
      }
      return index;
    };
    constexpr int kCenters = 40000;
    int draws = 0;
    for (int found = 0; found < kCenters; ++draws) {
      const FreeSpace::Draw draw = space.draw(random);
      const Ball* const ball = crowd.overlapping(draw.center, crowd.least_radius);
      if (ball) {
        space.refine(draw, {crowd.separation(*ball, draw.center), ball->radius});
      } else {
        ++by_voxels[part(draw.center)];
        ++found;
      }
    }
    EXPECT_LT(draws, 2 * kCenters) << "most of the listed volume has room in the end";
    int tries = 0;
    for (int found = 0; found < kCenters; ++tries) {
      const Vec3 place = crowd.place(random);
      if (crowd.overlapping(place, crowd.least_radius)) continue;
      ++anywhere[part(place)];
      ++found;
    }
    EXPECT_GT(tries, 4 * kCenters) << "there is little room";
    double squares = 0;
    double degrees = -1;
    for (std::size_t i = 0; i < by_voxels.size(); ++i) {
      const double both = by_voxels[i] + anywhere[i];
      if (both == 0) continue;
      squares += (by_voxels[i] - anywhere[i]) * (by_voxels[i] - anywhere[i]) / both;
      ++degrees;
    }
    EXPECT_GT(degrees, 10);
    // Chi-squared has this mean and a variance of twice as much; four standard deviations.
    EXPECT_LT(squares, degrees + 4 * std::sqrt(2 * degrees));
  }
}

TEST(FreeSpace, KeepsRoomForTheLeastRadiusWhenALargerSphereIsRefused) {
  const Box box = Box::walls({4, 4, 4});
  FreeSpace space(box, {{0.5, 0.5, 0.5}, {3.5, 3.5, 3.5}}, 0.5, 10, 1);
  space.list();
  Random random(24);
  const FreeSpace::Draw draw = space.draw(random);
  space.refine(draw, {{1.2, 0, 0}, 0.5});
  EXPECT_EQ(space.draw(random).level, 0U);
  space.refine(draw, {{0.9, 0, 0}, 0.5});
  EXPECT_EQ(space.draw(random).level, 1U);
}

TEST(FreeSpace, BecomesEmptyWhereThereIsNoRoom) {
  // Spheres at the corners of a cube and in the middle of it leave no room, but no voxel is excluded at
  // first.
  const Box box = Box::periodic({2, 2, 2});
  FreeSpace space(box, {{}, {2, 2, 2}}, 0.5, 10, 1);
  const std::array<Ball, 2> balls{{{{0, 0, 0}, 0.8}, {{1, 1, 1}, 0.8}}};
  space.list();
  Random random(25);
  int draws = 0;
  for (; !space.is_empty(); ++draws) {
    ASSERT_LT(draws, 100000);
    const FreeSpace::Draw draw = space.draw(random);
    std::vector<FreeSpace::Overlap> overlaps;
    for (const Ball& ball : balls) {
      const Vec3 apart = ball.center - draw.center;
      const Vec3 separation = apart - box.shift(box.nearest_image(apart));
      if (length(separation) < ball.radius + 0.5) overlaps.push_back({separation, ball.radius});
    }
    ASSERT_FALSE(overlaps.empty());
    const bool is_second = overlaps.size() > 1 && space.covers(draw, overlaps[1]);
    space.refine(draw, overlaps[is_second ? 1 : 0]);
  }
  EXPECT_GT(draws, 10);
}

}  // namespace
}  // namespace hardball::free_space_test
