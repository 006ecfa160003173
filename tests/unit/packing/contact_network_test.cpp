// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/contact_network.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hardball/numbers/random.hpp"
#include "hardball/packing/crystalline_share.hpp"

namespace hardball::contact_network_test {
namespace {

// A face-centered cubic crystal of spheres that touch.
PackedSpheres crystal(int cells) {
  PackedSpheres spheres{Container::periodic((cells * std::sqrt(2.0)) * Vec3{1, 1, 1}), {}, {}};
  const double edge = std::sqrt(2.0);
  for (int x = 0; x < cells; ++x) {
    for (int y = 0; y < cells; ++y) {
      for (int z = 0; z < cells; ++z) {
        for (const Vec3& corner : {Vec3{0, 0, 0}, Vec3{0.5, 0.5, 0}, Vec3{0.5, 0, 0.5}, Vec3{0, 0.5, 0.5}}) {
          spheres.positions.push_back(edge * (Vec3{double(x), double(y), double(z)} + corner));
          spheres.radii.push_back(0.5);
        }
      }
    }
  }
  return spheres;
}

TEST(ContactNetwork, FindsTheTwelveNeighborsInACrystal) {
  const PackedSpheres spheres = crystal(3);
  const ContactNetwork network = contact_network(spheres, 1e-6);
  EXPECT_EQ(network.contacts.size(), 6 * spheres.size());
  EXPECT_EQ(network.rattlers, 0U);
  EXPECT_NEAR(network.isostaticity, 6.0 * 108 / (3 * 107 + 1), 1e-12);
  EXPECT_NEAR(spheres.packing_fraction(), 0.7404804896930611, 1e-12);
  EXPECT_EQ(crystalline_share(spheres), 1);
}

// Spheres of one cell meet their neighbors, and themselves, through several images.
TEST(ContactNetwork, CountsEveryImageOnce) {
  const ContactNetwork network = contact_network(crystal(1), 1e-6);
  EXPECT_EQ(network.contacts.size(), 24U);
  PackedSpheres alone{Container::periodic({1, 1, 1}), {{0.5, 0.5, 0.5}}, {0.5}};
  EXPECT_EQ(contact_network(alone, 1e-6).contacts.size(), 3U);
}

TEST(ContactNetwork, RemovesRattlersAgainAndAgain) {
  PackedSpheres spheres = crystal(3);
  // In a chain the last one is held by one, the others by two: none by four.
  spheres.container = Container::periodic({50, 50, 50});
  for (double k = 0; k < 5; ++k) {
    spheres.positions.push_back({20 + k, 30, 30});
    spheres.radii.push_back(0.5);
  }
  const ContactNetwork network = contact_network(spheres, 1e-6);
  EXPECT_TRUE(network.rattles[spheres.size() - 1]);
  EXPECT_TRUE(network.rattles[spheres.size() - 3]);
  EXPECT_FALSE(network.rattles[54]) << "within the crystal";
}

TEST(ContactNetwork, KnowsWallsAndTheirGaps) {
  const Container cylinder{.shape = Container::Shape::cylinder, .size = {4, 4, 3}};
  PackedSpheres spheres{cylinder, {{3.5, 2, 0.5}}, {0.5}};
  ContactNetwork network = contact_network(spheres, 1e-6);
  ASSERT_EQ(network.contacts.size(), 2U);
  EXPECT_TRUE(network.contacts[0].bodies.is_wall);
  EXPECT_EQ(network.contacts[0].bodies.second, 4U) << "the lower face across z";
  EXPECT_EQ(network.contacts[1].bodies.second, kFaces);
  EXPECT_EQ(network.contacts[1].gap, 0);
  spheres.container = {.shape = Container::Shape::sphere, .size = {4, 4, 4}};
  spheres.positions = {{2, 2, 3.25}};
  network = contact_network(spheres, 1);
  ASSERT_EQ(network.contacts.size(), 1U);
  EXPECT_NEAR(network.contacts[0].gap, 0.25, 1e-15);
  // In a cone of 45 degrees, a sphere on the axis at height h is h / sqrt(2) from the mantle.
  spheres.container = {.shape = Container::Shape::cone, .size = {8, 8, 4}};
  spheres.positions = {{4, 4, 1}};
  network = contact_network(spheres, 1);
  ASSERT_EQ(network.contacts.size(), 2U) << "the mantle, and the plane of the apex";
  EXPECT_NEAR(network.contacts[1].gap, std::sqrt(0.5) - 0.5, 1e-15);
}

TEST(ContactNetwork, ScalesForcesByTheirMean) {
  const PackedSpheres spheres{
      Container::periodic({9, 9, 9}), {{1, 1, 1}, {2, 1, 1}, {3, 1, 1}}, {0.5, 0.5, 0.5}};
  const ContactNetwork network = contact_network(spheres, 1e-6, {{{0, 1}, 3.0}, {{1, 2}, 1.0}});
  ASSERT_EQ(network.contacts.size(), 2U);
  EXPECT_EQ(network.contacts[0].force, 1.5);
  EXPECT_EQ(network.contacts[1].force, 0.5);
}

TEST(PackedSpheres, FindsOverlapsSmallerThanCoordinatesAre) {
  const double tiny = 0x1p-50;
  const PackedSpheres spheres{
      Container::periodic({64, 64, 64}), {{63.5, 1, 1}, {0.5, 1, 1}}, {0.5, 0.5 + tiny}};
  EXPECT_NEAR(spheres.largest_overlap(), tiny, 1e-3 * tiny);
}

TEST(CrystallineShare, IsSmallInAFluidAndOneInAHexagonalLattice) {
  PackedSpheres discs{{.dimensions = 2, .size = {8, 4 * std::sqrt(3.0), 0}}, {}, {}};
  for (int row = 0; row < 8; ++row) {
    for (int k = 0; k < 8; ++k) {
      discs.positions.push_back({k + 0.5 * (row % 2), row * std::sqrt(0.75), 0});
      discs.radii.push_back(0.5);
    }
  }
  EXPECT_EQ(crystalline_share(discs), 1);
  PackedSpheres fluid{Container::periodic({10, 10, 10}), {}, {}};
  Random random(4);
  for (int k = 0; k < 1000; ++k) {
    fluid.positions.push_back({10 * random.uniform(), 10 * random.uniform(), 10 * random.uniform()});
    fluid.radii.push_back(0.5);
  }
  EXPECT_LT(crystalline_share(fluid), 0.05);
}

}  // namespace
}  // namespace hardball::contact_network_test
