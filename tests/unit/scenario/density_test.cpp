// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/density.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/scenario/make_world.hpp"
#include "hardball/world/walls.hpp"

namespace hardball::density_test {
namespace {

const std::string kPeriodic = "[box]\nboundary = [\"periodic\", \"periodic\", \"periodic\"]\n";
const std::string kDiscs = "[box]\ndimensions = 2\nboundary = [\"periodic\", \"wall\"]\n";
const std::string kSpheres = "[[spheres]]\nplacement = \"random\"\nspeed = 1\n";

std::string error_of(const std::string& text) {
  try {
    parse_scenario(text, "gas.toml");
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

void expect_refusal(const std::string& text, const std::string& problem, const std::string& remedy) {
  const std::string error = error_of(text);
  EXPECT_NE(error.find("gas.toml:"), std::string::npos) << error;
  EXPECT_NE(error.find(problem), std::string::npos) << error;
  EXPECT_NE(error.find(remedy), std::string::npos) << error;
}

TEST(PackingFraction, GivesTheBoxItsSize) {
  for (const std::string& box : {kPeriodic, kDiscs}) {
    for (const char* radius : {"0.5", "{ distribution = \"uniform\", min = 0.2, max = 0.8 }"}) {
      Scenario scenario =
          parse_scenario(box + "packing_fraction = 0.3\n" + kSpheres + "count = 300\nradius = " + radius +
                             "\n" + kSpheres + "count = 20\nradius = 1\n",
                         "gas.toml");
      for (const std::uint64_t seed : {1U, 2U}) {
        scenario.seed = seed;
        fit_box(scenario);
        const World world = make_world(scenario);
        // Sums of 320 volumes and a root: each is rounded by 2^-53 at most.
        EXPECT_NEAR(packing_fraction(world, Time(0)), 0.3, 0.3 * 400 * 0x1p-53);
        EXPECT_EQ(world.box().size().x, world.box().size().y);
      }
    }
  }
}

TEST(PackingFraction, GivesTheNumberOfSpheres) {
  const std::string box = kPeriodic + "size = [10, 10, 20]\n";
  const Scenario scenario = parse_scenario(
      box + kSpheres + "packing_fraction = 0.2\nradius = 0.5\n" + kSpheres + "count = 3\nradius = 1\n",
      "gas.toml");
  EXPECT_EQ(scenario.spheres[0].count, 764U);  // 400 over pi / 6 is 763.94
  EXPECT_EQ(scenario.spheres[1].count, 3U);
  const Scenario few = parse_scenario(box + kSpheres + "packing_fraction = 1e-9\nradius = 0.5\n", "gas.toml");
  EXPECT_EQ(few.spheres[0].count, 1U);
}

// Files may ask for any number of spheres, and are read at once.
TEST(PackingFraction, IsQuickToReadForManySpheres) {
  for (const std::string& box : {kPeriodic, kDiscs}) {
    const Scenario scenario = parse_scenario(
        box + "packing_fraction = 0.5\n" + kSpheres + "count = 4000000000\nradius = 0.5\n", "gas.toml");
    const double volume = box == kDiscs ? 2e9 * std::numbers::pi : 4e9 / 3 * std::numbers::pi;
    EXPECT_NEAR(std::pow(*scenario.box[0].size, box == kDiscs ? 2 : 3) / volume, 1, 1e-14);
  }
  expect_refusal(kPeriodic + "packing_fraction = 0.5\n" + kSpheres +
                     "count = 4000000000\nradius = { distribution = \"uniform\", min = 0.2, max = 0.8 }\n",
                 "the radii of 4000000000 spheres", "a size");
}

TEST(PackingFraction, RefusesContradictions) {
  const std::string counted = kSpheres + "count = 5\nradius = 0.5\n";
  const std::string filled = kSpheres + "packing_fraction = 0.2\nradius = 0.5\n";
  const std::string fraction = "packing_fraction = 0.3\n";
  const std::string size = "size = [9, 9, 9]\n";
  expect_refusal(kPeriodic + fraction + size + counted, "both size and packing_fraction", "remove one");
  expect_refusal(kPeriodic + fraction + filled, "the box and the spheres both", "give count");
  expect_refusal(kPeriodic + size + filled + "count = 5\n", "both packing_fraction and count", "remove one");
  expect_refusal("[box]\nboundary = [\"open\", \"wall\", \"wall\"]\n" + fraction + counted, "open",
                 "give size");
  expect_refusal("[box]\nboundary = [\"open\", \"open\", \"open\"]\n" + filled, "no size", "give count");
  expect_refusal(kPeriodic + fraction + "[start]\nfile = \"a.xyz\"\n", "come from a file", "give size");
  expect_refusal(kPeriodic + fraction + "[[spheres]]\npositions = [[1, 1, 1]]\nspeed = 1\nradius = 0.5\n",
                 "positions", "give size");
  const std::string wall =
      "[[walls]]\nshape = \"cylinder\"\npoint = [5, 5, 5]\naxis = [0, 0, 1]\nradius = 4\n";
  expect_refusal(kPeriodic + fraction + counted + wall, "[[walls]]", "give size");
  expect_refusal(kPeriodic + size + filled + wall, "[[walls]]", "give count");
  expect_refusal(
      kPeriodic + size + kSpheres +
          "packing_fraction = 0.2\nradius = { distribution = \"uniform\", min = 0.2, max = 0.8 }\n",
      "distributed", "packing_fraction in [box]");
  expect_refusal(kPeriodic + "size = [1e6, 1e6, 1e6]\n" + filled, "spheres to fill", "larger spheres");
}

}  // namespace
}  // namespace hardball::density_test
