// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Scenarios of two dimensions.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "hardball/scenario/make_world.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"
#include "hardball/trajectory/trajectory.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/totals.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::flat_scenario_test {
namespace {

World world_of(const std::string& text) {
  return make_world(parse_scenario(text, "discs.toml"));
}

constexpr const char* kSquare = "[box]\ndimensions = 2\nsize = [20, 30]\nboundary = ['periodic', 'wall']\n";

TEST(FlatScenario, MakesAFlatBox) {
  const Scenario scenario =
      parse_scenario(std::string(kSquare) +
                         "gravity = [0, -2]\n[[spheres]]\nradius = 0.5\npositions = [[1, 2], [4, 5, 0]]\n" +
                         "velocities = [[1, 0], [0, 1]]\n[[walls]]\nshape = 'cylinder'\npoint = [10, "
                         "15]\naxis = [0, 0, 2]\n" +
                         "radius = 9\n[[obstacles]]\nposition = [10, 15]\nradius = 2\n",
                     "discs.toml", std::array<std::string, 1>{"box.boundary=['open', 'open']"});
  EXPECT_EQ(scenario.dimensions(), 2U);
  const World world = make_world(scenario);
  EXPECT_TRUE(world.box().is_flat());
  EXPECT_TRUE(world.box().is_open(0));
  EXPECT_EQ(world.motion().gravity(), (Vec3{0, -2, 0}));
  EXPECT_EQ(world.path(1).position, (Vec3{4, 5, 0}));
  EXPECT_EQ(world.path(1).velocity, (Vec3{0, 1, 0}));
  EXPECT_EQ(world.surfaces()[1].point(), (Vec3{10, 15, 0}));
  EXPECT_EQ(parse_scenario(std::string(kSquare) + "[[spheres]]\nradius=1\npositions=[[2,2]]\nspeed=1\n", "x")
                .box[1]
                .size,
            30);
}

TEST(FlatScenario, PlacesDiscsWithTheVelocitiesOfTwoDimensions) {
  const std::string group = "[[spheres]]\ncount = 200\nradius = 0.5\nplacement = 'random'\n";
  const World warm = world_of(kSquare + group + "mass = { density = 2.0 }\ntemperature = 3\n");
  EXPECT_TRUE(audit(warm, Time(0)).is_sound());
  EXPECT_DOUBLE_EQ(warm.mass(7), std::numbers::pi / 2);
  EXPECT_NEAR(kinetic_energy(warm, Time(0)), 200 * 3.0, 1e-9) << "kT for each disc";
  const World moving = world_of(kSquare + group + "mean_speed = 3\n");
  double speeds = 0;
  for (const Path& path : moving.paths()) speeds += length(path.velocity);
  EXPECT_NEAR(speeds / 200, 3, 1e-12);
  const World equal = world_of(kSquare + group + "speed = 3\n");
  for (const Path& path : equal.paths()) {
    ASSERT_NEAR(length(path.velocity), 3, 1e-12);
    ASSERT_EQ(path.velocity.z, 0);
  }
}

// Without sizes, placement fills a tenth of a square around the origin.
TEST(FlatScenario, PlacesDiscsInOpenSpace) {
  const World world = world_of(
      "[box]\ndimensions = 2\nboundary = ['open', 'open']\n"
      "[[spheres]]\ncount = 500\nradius = 1\nplacement = 'hexagonal'\nspeed = 0\n");
  const double half = std::sqrt(500 * std::numbers::pi / 0.1) / 2;
  double farthest = 0;
  for (const Path& path : world.paths()) farthest = std::max(farthest, std::fabs(path.position.x));
  EXPECT_LE(farthest, half - 1 + 1e-9);
  EXPECT_GT(farthest, 0.9 * half);
}

TEST(FlatScenario, WritesAndReadsSnapshotsOfALayer) {
  const support::ScratchFolder folder;
  const World world = world_of(std::string(kSquare) +
                               "[[spheres]]\nradius = 0.5\npositions = [[1, 2]]\nvelocities = [[3, 4]]\n");
  {
    Trajectory file(folder / "discs.xyz");
    file.append(world, Time(0));
  }
  const std::string text = support::read_text(folder / "discs.xyz");
  EXPECT_NE(
      text.find("Lattice=\"20 0 0 0 30 0 0 0 1\" Origin=\"0 0 -0.5\" pbc=\"T F F\" dimensions=2 Time=0 "),
      std::string::npos)
      << text;
  const Snapshot snapshot = read_snapshot(folder / "discs.xyz");
  EXPECT_EQ(snapshot.spheres.at(0).position, (Vec3{1, 2, 0}));
  EXPECT_EQ(snapshot.spheres.at(0).velocity, (Vec3{3, 4, 0}));
}

}  // namespace
}  // namespace hardball::flat_scenario_test
