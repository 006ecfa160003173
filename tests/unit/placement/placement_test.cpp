// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/placement/placement.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/world.hpp"
#include "support/refusal.hpp"

namespace hardball::placement_test {
namespace {

constexpr std::array<std::array<Boundary, kAxes>, 3> kBoundaries = {
    {{Boundary::wall, Boundary::wall, Boundary::wall},
     {Boundary::periodic, Boundary::periodic, Boundary::periodic},
     {Boundary::wall, Boundary::periodic, Boundary::open}}};

// World::add and the audit refuse spheres that do not fit.
Audit audit_of(const Box& box, const std::vector<Vec3>& centers, const std::vector<double>& radii) {
  World world(box);
  for (std::size_t i = 0; i < centers.size(); ++i) world.add({centers[i], {}, radii[i], 1});
  return audit(world, Time(0));
}

TEST(PlaceRandomly, PlacesSpheresOfManySizesWithoutOverlap) {
  const Vec3 size{12, 10, 8};
  std::vector<double> radii;
  for (int i = 0; i < 600; ++i) radii.push_back(0.05 + 0.6 * (i % 11 == 0) + 0.02 * (i % 7));
  for (const auto& boundary : kBoundaries) {
    const Box box(boundary, size);
    Random random(5);
    const std::vector<Vec3> centers = place_randomly(box, {{}, size}, radii, random, "here");
    ASSERT_EQ(centers.size(), radii.size());
    EXPECT_EQ(audit_of(box, centers, radii).max_overlap, 0);
    for (std::size_t i = 0; i < centers.size(); ++i) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const double inset = box.is_periodic(axis) ? 0 : radii[i];
        ASSERT_GE(centers[i][axis], inset);
        ASSERT_LE(centers[i][axis], size[axis] - inset);
      }
    }
    Random again(5);
    EXPECT_EQ(place_randomly(box, {{}, size}, radii, again, "here"), centers);
  }
}

TEST(PlaceRandomly, FillsTheRegionEvenly) {
  const Box box = Box::periodic({10, 10, 10});
  Random random(6);
  const std::vector<double> radii(20000, 0.01);
  Vec3 sum;
  for (const Vec3& center : place_randomly(box, {{}, box.size()}, radii, random, "here")) sum += center;
  // The standard error of the mean of 20,000 uniform numbers up to 10 is 0.0204; five of them.
  for (std::size_t axis = 0; axis < kAxes; ++axis) EXPECT_NEAR(sum[axis] / 20000, 5, 0.102);
}

// One center after another, anywhere until it overlaps no other.
std::vector<Vec3> place_slowly(const Box& box, const Vec3& size, const std::vector<double>& radii,
                               Random& random) {
  std::vector<Vec3> centers;
  while (centers.size() < radii.size()) {
    const double radius = radii[centers.size()];
    Vec3 center;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double inset = box.is_periodic(axis) ? 0 : radius;
      center[axis] = inset + random.uniform() * (size[axis] - inset - inset);
    }
    bool overlaps = false;
    for (std::size_t i = 0; i < centers.size() && !overlaps; ++i) {
      const Vec3 apart = centers[i] - center;
      const double reach = radius + radii[i];
      const Vec3 nearest = apart - box.shift(box.nearest_image(apart));
      overlaps = dot(nearest, nearest) < reach * reach;
    }
    if (!overlaps) centers.push_back(center);
  }
  return centers;
}

TEST(PlaceRandomly, GivesThePositionsOfTheSlowWay) {
  const Vec3 size{12, 10, 8};
  std::vector<double> equal(450, 0.5);
  std::vector<double> unequal;
  for (int i = 0; i < 150; ++i) unequal.push_back(0.8 - 0.001 * i);
  for (const std::vector<double>& radii : {equal, unequal}) {
    for (const auto& boundary : kBoundaries) {
      const Box box(boundary, size);
      Random slow(8);
      Random fast(8);
      const std::vector<Vec3> expected = place_slowly(box, size, radii, slow);
      const std::vector<Vec3> centers = place_randomly(box, {{}, size}, radii, fast, "here");
      for (std::size_t i = 0; i < radii.size(); ++i) ASSERT_LT(length(centers[i] - expected[i]), 1e-12) << i;
      EXPECT_EQ(slow.bits(), fast.bits()) << "as many random numbers are drawn";
    }
  }
}

TEST(PlaceRandomly, ComesCloseToSaturation) {
  const Vec3 size{20, 20, 20};
  std::vector<double> equal(5470, 0.5);  // a packing fraction of 0.358
  std::vector<double> mixed(200, 1);     // together 0.40
  mixed.insert(mixed.end(), 36000, 0.2);
  mixed.insert(mixed.end(), 60000, 0.1);
  mixed.insert(mixed.end(), 10000, 0.109);
  for (const std::vector<double>& radii : {equal, mixed}) {
    for (const auto& boundary : {kBoundaries[1], kBoundaries[2]}) {
      const Box box(boundary, size);
      Random random(9);
      const std::vector<Vec3> centers = place_randomly(box, {{}, size}, radii, random, "here");
      EXPECT_EQ(audit_of(box, centers, radii).max_overlap, 0);
    }
  }
}

TEST(PlaceRandomly, FindsTheLastRoom) {
  // Around a sphere in a box, only places near its corners are left.
  const Box box = Box::walls({2.4, 2.4, 2.4});
  std::array<int, 8> in_corner{};
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Random random(seed);
    const auto is_allowed = [](const Vec3& center, double radius) {
      return radius < 1 || length(center - Vec3{1.2, 1.2, 1.2}) < 0.05;
    };
    const std::vector<double> radii{1, 0.25};
    const std::vector<Vec3> centers =
        place_randomly(box, {{}, {2.4, 2.4, 2.4}}, radii, random, "here", {}, is_allowed);
    ASSERT_GE(length(centers[1] - centers[0]), 1.25);
    ++in_corner[static_cast<std::size_t>(centers[1].x > 1.2) +
                2 * static_cast<std::size_t>(centers[1].y > 1.2) +
                4 * static_cast<std::size_t>(centers[1].z > 1.2)];
  }
  // 50 in each on average; the large sphere is within 0.05 of the middle.
  for (const int count : in_corner) EXPECT_NEAR(count, 50, 35);
}

TEST(PlaceRandomly, AvoidsSpheresThatAreThere) {
  const Vec3 size{10, 10, 10};
  const Box box = Box::periodic(size);
  const std::vector<PlacedSphere> placed{{{0.5, 5, 5}, 2}, {{5, 5, 9.9}, 1}, {{5, 5, 2}, 0.01}};
  std::vector<double> radii(4000, 0.25);  // together 0.30
  Random random(11);
  std::vector<Vec3> centers = place_randomly(box, {{}, size}, radii, random, "here", {}, IsAllowed(), placed);
  ASSERT_EQ(centers.size(), radii.size());
  for (const PlacedSphere& sphere : placed) {
    centers.push_back(sphere.center);
    radii.push_back(sphere.radius);
  }
  EXPECT_EQ(audit_of(box, centers, radii).max_overlap, 0);
}

TEST(FindRandomPlaces, FindsNoneWhereSpheresAreTooDense) {
  const Vec3 size{10, 10, 10};
  const Box box = Box::periodic(size);
  Random random(12);
  const std::vector<double> equal(750, 0.5);  // 0.39
  EXPECT_FALSE(find_random_places(box, {{}, size}, equal, random, "here"));
  std::vector<double> mixed(500, 0.5);
  mixed.insert(mixed.end(), 600, 0.45);  // together 0.49
  EXPECT_FALSE(find_random_places(box, {{}, size}, mixed, random, "here"));
  EXPECT_THROW(place_randomly(box, {{}, size}, mixed, random, "here"), Error);
}

TEST(PlaceRandomly, KeepsToWhatIsAllowed) {
  const Vec3 size{10, 10, 10};
  const Box box = Box::walls(size);
  // Inside a cylinder.
  const auto is_allowed = [](const Vec3& center, double radius) {
    return length(Vec3{center.x - 5, center.y - 5, 0}) + radius <= 4;
  };
  const std::vector<double> radii(280, 0.5);  // 0.29 of the cylinder
  Random random(10);
  const std::vector<Vec3> centers = place_randomly(box, {{}, size}, radii, random, "here", {}, is_allowed);
  EXPECT_EQ(audit_of(box, centers, radii).max_overlap, 0);
  for (const Vec3& center : centers) EXPECT_TRUE(is_allowed(center, 0.5));
  const auto is_nothing_allowed = [](const Vec3&, double) { return false; };
  EXPECT_THROW(place_randomly(box, {{}, size}, radii, random, "here", {}, is_nothing_allowed), Error);
}

TEST(PlaceRandomly, RefusesWhatCannotBeReached) {
  const Box box = Box::periodic({10, 10, 10});
  Random random(7);
  const auto place = [&](std::size_t count, double radius) {
    return place_randomly(box, {{}, box.size()}, std::vector<double>(count, radius), random, "[[spheres]] 2");
  };
  const Error error = support::error_of([&] { place(800, 0.5); });  // a packing fraction of 0.42
  EXPECT_EQ(error.where(), "[[spheres]] 2");
  EXPECT_NE(error.remedy().find("fcc"), std::string::npos);
  EXPECT_THROW(place(2000, 0.5), Error) << "beyond close packing";
  EXPECT_EQ(place(0, 0.5).size(), 0U);
  std::vector<double> unequal(900, 0.5);
  unequal[0] = 0.4;
  EXPECT_THROW(place_randomly(box, {{}, box.size()}, unequal, random, "here"), Error) << "no room is found";
}

TEST(Placement, RefusesNumbersOutOfRange) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Box box = Box::periodic({10, 10, 10});
  const Region region{{}, box.size()};
  Random random(1);
  for (const double radius : {nan, kInfinity, -kInfinity, 0.0, -1.0, 1e61, 1e-61}) {
    EXPECT_THROW(place_randomly(box, region, std::vector<double>{0.5, radius}, random, "here"), Error);
    EXPECT_THROW(place_on_lattice(box, region, 4, radius, "here"), Error);
  }
  for (const Region& bad : {Region{{0, 0, nan}, {10, 10, 10}}, Region{{0, 0, 0}, {10, kInfinity, 10}},
                            Region{{0, 0, 0}, {10, 0, 10}}, Region{{5, 0, 0}, {4, 10, 10}}}) {
    EXPECT_THROW(place_randomly(box, bad, std::vector<double>{0.5}, random, "here"), Error);
    EXPECT_THROW(place_on_lattice(box, bad, 4, 0.5, "here"), Error);
  }
}

TEST(Placement, RefusesSpheresLargerThanTheRegion) {
  Random random(1);
  const Box box = Box::periodic({100, 100, 1});
  EXPECT_THROW(place_randomly(box, {{}, box.size()}, std::vector<double>{0.1, 0.6}, random, "here"), Error);
  EXPECT_THROW(place_on_lattice(box, {{}, box.size()}, 4, 0.6, "here"), Error);
  EXPECT_EQ(place_randomly(box, {{}, box.size()}, std::vector<double>{0.1, 0.5}, random, "here").size(), 2U);
}

TEST(PlaceOnLattice, MakesDenseCrystals) {
  for (const auto& boundary : kBoundaries) {
    for (const std::size_t count : {std::size_t{1}, std::size_t{7}, std::size_t{256}, std::size_t{500}}) {
      const Vec3 size{10, 10, 10};
      const Box box(boundary, size);
      // About 70 percent of the radius at close packing in a periodic box of whole cubes.
      const double radius =
          0.7 * std::cbrt(1000 * kClosePacking / (4.18879 * static_cast<double>(count + 200)));
      const std::vector<Vec3> centers = place_on_lattice(box, {{}, size}, count, radius, "here");
      ASSERT_EQ(centers.size(), count);
      EXPECT_LT(audit_of(box, centers, std::vector<double>(count, radius)).max_overlap, 1e-12);
    }
  }
}

TEST(PlaceOnLattice, ReachesClosePackingAndNoFarther) {
  // 4 * 5^3 spheres: with cubes of edge 2, neighbors are sqrt(2) apart.
  const Box box = Box::periodic({10, 10, 10});
  const double most = std::sqrt(0.5);
  EXPECT_EQ(place_on_lattice(box, {{}, box.size()}, 500, most * (1 - 1e-12), "here").size(), 500U);
  const Error error = support::error_of([&] {
    place_on_lattice(box, {{}, box.size()}, 500, most * (1 + 1e-9), "here");
  });
  EXPECT_NE(error.remedy().find("0.7071067811865"), std::string::npos);
}

TEST(PlaceOnLattice, SpreadsVacanciesEvenly) {
  const Box box = Box::periodic({10, 10, 10});
  int lower_half = 0;
  for (const Vec3& center : place_on_lattice(box, {{}, box.size()}, 250, 0.4, "here"))
    lower_half += center.x < 5;
  EXPECT_NEAR(lower_half, 125, 26) << "to within a layer of sites";
}

}  // namespace
}  // namespace hardball::placement_test
