// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Sheared boxes in scenarios.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/scenario/make_simulation.hpp"
#include "hardball/scenario/make_world.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/thermostats/thermostat.hpp"

namespace hardball::shear_scenario_test {
namespace {

std::string text_of(const std::string& of_box, const std::string& others = "") {
  return "[box]\nsize = [10.0, 10.0, 10.0]\n" + of_box +
         "\n[[spheres]]\ncount = 500\nradius = 0.3\ntemperature = 1e-6\nplacement = \"random\"\n" + others;
}

const std::string kSheared = "boundary = [\"periodic\", \"periodic\", \"wall\"]\nshear_rate = 0.5\n";

std::string refusal(const std::string& of_box, const std::string& others = "") {
  try {
    make_world(parse_scenario(text_of(of_box, others), "shear.toml"));
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ShearedScenario, GivesDrawnVelocitiesTheFlow) {
  const World world = make_world(parse_scenario(text_of(kSheared + "shear_offset = 3\n"), "shear.toml"));
  EXPECT_EQ(world.box().shear(), (Shear{.rate = 0.5, .offset = 3}));
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const Path& path = world.path(slot);
    EXPECT_NEAR(path.velocity.x, 0.5 * (path.position.y - 5), 0.01);
    EXPECT_NEAR(path.velocity.y, 0, 0.01);
  }
}

TEST(ShearedScenario, LeavesListedVelocitiesAsTheyAre) {
  const World world = make_world(
      parse_scenario("[box]\nsize = [10.0, 10.0, 10.0]\n" + kSheared +
                         "[[spheres]]\nradius = 0.3\npositions = [[1, 1, 1]]\nvelocities = [[1, 2, 3]]\n",
                     "shear.toml"));
  EXPECT_EQ(world.path(0).velocity, (Vec3{1, 2, 3}));
}

// A scenario of this box, which starts from two spheres in a tilted one.
Scenario from_tilted_file(const std::string& of_box) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "tilted.xyz";
  std::ofstream(file) << "2\nLattice=\"10 0 0 -2.5 10 0 0 0 10\" pbc=\"T T T\" "
                         "Properties=pos:R:3:velo:R:3:radius:R:1\n"
                         "1 1 1 0 0 0 0.3\n3.5 9.9 1 0 0 0 0.3\n";
  return parse_scenario("[box]\nsize = [10.0, 10.0, 10.0]\n" + of_box + "[start]\nfile = \"tilted.xyz\"\n",
                        (std::filesystem::path(testing::TempDir()) / "start.toml").string());
}

TEST(ShearedScenario, StartsFromTheTiltOfAFile) {
  const World world = make_world(from_tilted_file(kSheared));
  EXPECT_EQ(world.box().shear(), (Shear{.rate = 0.5, .offset = -2.5}));
  const World given = make_world(from_tilted_file(kSheared + "shear_offset = 1\n"));
  EXPECT_EQ(given.box().shear(), (Shear{.rate = 0.5, .offset = 1}));
}

TEST(ShearedScenario, RefusesTheTiltOfAFileForABoxThatIsNotSheared) {
  try {
    make_world(from_tilted_file("boundary = [\"periodic\", \"periodic\", \"wall\"]\n"));
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(error.problem().find("tilted by -2.5"), std::string::npos) << error.what();
    EXPECT_NE(error.where().find("tilted.xyz"), std::string::npos);
    EXPECT_NE(error.remedy().find("shear_offset = -2.5"), std::string::npos);
  }
}

TEST(ShearedScenario, SaysWhereWhatDoesNotGoTogetherIs) {
  const std::string with_gravity = refusal(kSheared + "gravity = [0, 0, -1]\n");
  EXPECT_NE(with_gravity.find("the box is sheared, and there is gravity"), std::string::npos) << with_gravity;
  EXPECT_NE(with_gravity.find("shear.toml:4"), std::string::npos) << with_gravity;
  const std::string with_steps =
      refusal(kSheared, "[[potentials]]\nsteps = [{ ratio = 1.5, energy = -1 }]\n");
  EXPECT_NE(with_steps.find("shear.toml:4"), std::string::npos) << with_steps;
  const std::string with_walls =
      refusal("boundary = [\"wall\", \"periodic\", \"periodic\"]\nshear_rate = 0.5\n");
  EXPECT_NE(with_walls.find("not periodic along x and y"), std::string::npos) << with_walls;
  EXPECT_NE(with_walls.find("shear.toml:4"), std::string::npos) << with_walls;
}

TEST(ShearedScenario, HasAThermostatWithSlabs) {
  const Scenario scenario = parse_scenario(
      text_of(kSheared, "[thermostat]\nkind = \"rescale\"\ntemperature = 1.0\nevery = 0.5\nslabs = 8\n"),
      "shear.toml");
  EXPECT_EQ(std::get<Rescale>(*scenario.thermostat).slabs(), 8);
}

}  // namespace
}  // namespace hardball::shear_scenario_test
