// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The tables [[potentials]] and [[bonds]].
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/scenario/make_world.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/world/step_levels.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::potentials_test {
namespace {

using support::ScratchFolder;
using support::write_text;

const std::string kSpheres = R"([box]
size = [20.0, 20.0, 20.0]
boundary = ["wall", "wall", "wall"]
[[species]]
name = "a"
[[species]]
name = "b"
[[spheres]]
radius = 0.5
temperature = 1.0
species = "a"
positions = [[1, 1, 1], [2.1, 1, 1], [3.2, 1, 1], [4.3, 1, 1]]
)";

Scenario read(const std::string& tables) {
  return parse_scenario(kSpheres + tables, "gas.toml");
}

// The message with which a scenario, or its world, is refused.
std::string refusal(const std::string& tables) {
  try {
    make_world(read(tables));
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

void expect_refused(const std::string& tables, const std::string& part) {
  EXPECT_NE(refusal(tables).find(part), std::string::npos) << refusal(tables);
  EXPECT_NE(refusal(tables).find("gas.toml"), std::string::npos) << refusal(tables);
}

TEST(Potentials, AreReadInTheirOrder) {
  const Scenario scenario = read(R"([[potentials]]
between = ["b", "a"]
steps = [{ ratio = 0.5, energy = 2 }, { ratio = 1, energy = 1.5 }]
core = 0
[[potentials]]
steps = [{ ratio = 1.5, energy = -1 }]
)");
  ASSERT_EQ(scenario.potentials.size(), 2U);
  EXPECT_EQ(scenario.potentials[0].between, (std::pair<SpeciesId, SpeciesId>{1, 0}));
  EXPECT_EQ(scenario.potentials[0].rules.core, 0);
  EXPECT_EQ(scenario.potentials[0].rules.steps[1], (Step{1, 1.5}));
  EXPECT_FALSE(scenario.potentials[1].between);
  EXPECT_TRUE(scenario.has_steps());
  const World world = make_world(scenario);
  const StepTable& table = world.interactions().steps();
  EXPECT_EQ(table.of(0, 1), 0);
  EXPECT_EQ(table.of(1, 1), 1);
}

TEST(Bonds, TieChainsAndPairs) {
  const Scenario scenario = read(R"([[bonds]]
chain = [0, 3]
beads = 2
longest = 1.2
core = 0.9
steps = [{ ratio = 1, energy = -1 }]
[[bonds]]
between = [2, 1]
longest = 1.5
)");
  ASSERT_EQ(scenario.bonds.size(), 2U);
  EXPECT_EQ(scenario.bonds[0].pairs, (std::vector<std::pair<SphereId, SphereId>>{{0, 1}, {2, 3}}));
  EXPECT_EQ(scenario.bonds[0].rules.steps.back(), (Step{1.2, 0}));
  World world = make_world(scenario);
  EXPECT_EQ(bonds_of(world), (std::vector<Bond>{{0, 1, 0}, {1, 2, 1}, {2, 3, 0}}));
  assign_levels(world, Time(0));
  EXPECT_EQ(step_energy(world), 0) << "beyond the step, within the tether";
}

TEST(Bonds, AreReadFromFiles) {
  const ScratchFolder folder;
  write_text(folder / "gas.toml", kSpheres + "[[bonds]]\nfile = \"bonds.txt\"\nlongest = 1.2\n");
  const Scenario scenario = load_scenario(folder / "gas.toml");
  const auto refused = [&] {
    try {
      make_world(scenario);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refused().find("cannot be read"), std::string::npos);
  write_text(folder / "bonds.txt", "\n");
  EXPECT_NE(refused().find("no bonds"), std::string::npos);
  write_text(folder / "bonds.txt", "0 1\n1\n");
  EXPECT_NE(refused().find("bonds.txt:2"), std::string::npos) << refused();
  write_text(folder / "bonds.txt", "0 1.5\n");
  EXPECT_NE(refused().find("1.5"), std::string::npos);
  write_text(folder / "bonds.txt", "0 -1\n");
  EXPECT_NE(refused().find("-1 is not the id"), std::string::npos);
  write_text(folder / "bonds.txt", "0 1\n\n 3\t2 \n");
  EXPECT_EQ(bonds_of(make_world(scenario)), (std::vector<Bond>{{0, 1, 0}, {2, 3, 0}}));
}

TEST(Potentials, AreRefusedWithTheirPlace) {
  const std::string well = "steps = [{ ratio = 1.5, energy = -1 }]\n";
  expect_refused("[[potentials]]\nbetween = [\"a\"]\n" + well, "two species");
  expect_refused("[[potentials]]\nbetween = [\"a\", \"c\"]\n" + well, "no species \"c\"");
  expect_refused("[[potentials]]\n", "steps");
  expect_refused("[[potentials]]\nsteps = [{ ratio = 0.5, energy = 1 }]\n", "the ratio 0.5");
  expect_refused("[[potentials]]\nsteps = [{ ratio = 1.5 }]\n", "energy");
  expect_refused("[[potentials]]\n" + well + "[[potentials]]\n" + well, "two potentials");
  expect_refused("[[potentials]]\nbetween = [\"a\", \"b\"]\n" + well +
                     "[[potentials]]\nbetween = [\"b\", \"a\"]\n" + well,
                 "two potentials");
  expect_refused("[[potentials]]\n" + well + "[response]\nkind = \"merge\"\n", "merge");
}

TEST(Bonds, AreRefusedWithTheirPlace) {
  expect_refused("[[bonds]]\nlongest = 1.2\n", "'file' is missing");
  expect_refused("[[bonds]]\nchain = [0, 3]\n", "longest");
  expect_refused("[[bonds]]\nchain = [3, 0]\nlongest = 1.2\n", "not after the first");
  expect_refused("[[bonds]]\nchain = [0, 1.5]\nlongest = 1.2\n", "1.5 is not the id");
  expect_refused("[[bonds]]\nchain = [0, 1, 2]\nlongest = 1.2\n", "two ids");
  expect_refused("[[bonds]]\nchain = [0, 3]\nbeads = 3\nlongest = 1.2\n", "chains of 3");
  expect_refused("[[bonds]]\nbetween = [0, 1]\nbeads = 2\nlongest = 1.2\n", "beads is given without chain");
  expect_refused("[[bonds]]\nchain = [0, 4]\nlongest = 1.2\n", "no sphere 4");
  expect_refused("[[bonds]]\nbetween = [0, 0]\nlongest = 1.2\n", "tied to itself");
  expect_refused("[[bonds]]\nbetween = [0, 1]\nlongest = 1.2\n[[bonds]]\nchain = [0, 1]\nlongest = 1.2\n",
                 "tied already");
  expect_refused("[[bonds]]\nbetween = [0, 1]\nlongest = 0.9\n", "the ratio 0.9");
}

}  // namespace
}  // namespace hardball::potentials_test
