// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/scenario.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "support/scratch_folder.hpp"

namespace hardball {
namespace {

using support::ScratchFolder;
using support::write_text;

const std::string kText = R"([box]
size = [10, 20.5, 30]
boundary = ["wall", "periodic", "open"]
gravity = [0.0, 0, 0]

[[spheres]]
count = 10
radius = 1.5
mass = 2
placement = "fcc"
mean_speed = 3

[[spheres]]
radius = 1
positions = [[1, 2, 3], [4, 5, 6]]
velocities = [[0, 0, 0], [1, 0, 0]]

[response]
restitution = 0.5

[run]
until = 12
seed = 7

[output]
directory = "out"
snapshots_every = 0.5
event_log = true
report = false
recording = true

[measures]
names = ["pressure", "bond_order"]
every = 0.25
from = 2
)";

Scenario parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_scenario(text, "gas.toml", overrides);
}

TEST(ParseScenario, ReadsEveryKey) {
  const Scenario scenario = parse(kText);
  EXPECT_EQ(scenario.name, "gas.toml");
  EXPECT_EQ(scenario.box[0].boundary, Boundary::wall);
  EXPECT_EQ(scenario.box[1].boundary, Boundary::periodic);
  EXPECT_EQ(scenario.box[2].boundary, Boundary::open);
  EXPECT_EQ(scenario.box[0].size, 10);
  EXPECT_EQ(scenario.box[1].size, 20.5);
  EXPECT_EQ(scenario.box[2].size, 30);
  ASSERT_EQ(scenario.spheres.size(), 2U);
  const SphereGroup& first = scenario.spheres[0];
  EXPECT_EQ(first.count, 10U);
  EXPECT_EQ(first.radius, 1.5);
  EXPECT_EQ(first.mass, 2);
  EXPECT_EQ(first.placement, Placement::fcc);
  EXPECT_EQ(first.velocity_rule, VelocityRule::mean_speed);
  EXPECT_EQ(first.velocity_scale, 3);
  EXPECT_EQ(first.where, "gas.toml:6:1");
  const SphereGroup& second = scenario.spheres[1];
  EXPECT_EQ(second.count, 2U);
  EXPECT_EQ(second.mass, 1);
  EXPECT_EQ(second.placement, Placement::listed);
  EXPECT_EQ(second.positions, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(second.velocity_rule, VelocityRule::listed);
  EXPECT_EQ(second.velocities, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}));
  EXPECT_EQ(scenario.restitution, 0.5);
  EXPECT_EQ(scenario.until, 12);
  EXPECT_EQ(scenario.seed, 7U);
  EXPECT_EQ(scenario.output_directory, "out");
  EXPECT_EQ(scenario.snapshots_every, 0.5);
  EXPECT_TRUE(scenario.event_log);
  EXPECT_FALSE(scenario.report);
  EXPECT_TRUE(scenario.recording);
  EXPECT_EQ(scenario.measures.names, (std::vector<std::string>{"pressure", "bond_order"}));
  EXPECT_EQ(scenario.measures.every, 0.25);
  EXPECT_EQ(scenario.measures.from, 2);
}

const std::string kLeast = R"(
[box]
size = [10, 10, 10]
boundary = ["wall", "wall", "wall"]
[[spheres]]
count = 10
radius = 1
placement = "random"
speed = 0
)";

TEST(ParseScenario, HasDefaults) {
  const Scenario scenario = parse(kLeast);
  EXPECT_EQ(scenario.spheres.at(0).mass, 1);
  EXPECT_EQ(scenario.restitution, 1);
  EXPECT_FALSE(scenario.until);
  EXPECT_EQ(scenario.seed, 1U);
  EXPECT_FALSE(scenario.output_directory);
  EXPECT_FALSE(scenario.snapshots_every);
  EXPECT_FALSE(scenario.event_log);
  EXPECT_TRUE(scenario.report);
  EXPECT_FALSE(scenario.recording);
  EXPECT_EQ(scenario.measures.names, std::vector<std::string>{"all"});
  EXPECT_FALSE(scenario.measures.every);
  EXPECT_EQ(scenario.measures.from, 0);
  EXPECT_FALSE(scenario.start_file);
}

TEST(ParseScenario, KeepsTheTextWithoutOverrides) {
  EXPECT_EQ(parse(kLeast, {"run.seed=9"}).text, kLeast);
}

TEST(ParseScenario, TakesSizesOfBoundedAxesAlone) {
  const Scenario slab = parse(kLeast, {R"(box.boundary=["wall", "open", "periodic"])", "box.size=[3, 5]"});
  EXPECT_EQ(slab.box[0].size, 3);
  EXPECT_FALSE(slab.box[1].size);
  EXPECT_EQ(slab.box[2].size, 5);
}

TEST(ParseScenario, NeedsNoSizeInOpenSpace) {
  const Scenario scenario = parse(R"(
    box.boundary = ["open", "open", "open"]
    spheres = [{count = 1, radius = 1, placement = "random", speed = 1}]
  )");
  for (const Scenario::Axis& axis : scenario.box) EXPECT_FALSE(axis.size);
}

TEST(ParseScenario, FindsTheStartFileBesideTheScenario) {
  const std::string text = R"(
    [box]
    size = [10, 10, 10]
    boundary = ["wall", "wall", "wall"]
    [start]
    file = "start.xyz"
  )";
  EXPECT_EQ(parse_scenario(text, "some/where/gas.toml").start_file, "some/where/start.xyz");
  EXPECT_EQ(parse_scenario(text, "gas.toml").start_file, "start.xyz");
  EXPECT_EQ(parse(text, {"start.file=/tmp/start.xyz"}).start_file, "/tmp/start.xyz");
}

TEST(ParseScenario, TakesWholeNumbersInAnyForm) {
  EXPECT_EQ(parse(kLeast, {"spheres.0.count=1e3"}).spheres.at(0).count, 1000U);
  EXPECT_EQ(parse(kLeast, {"spheres.0.count=1_000"}).spheres.at(0).count, 1000U);
}

TEST(Overrides, ReplaceValues) {
  const Scenario scenario =
      parse(kText, {"run.until=5", "spheres.0.count=20", "spheres.1.positions.1.2=7", "box.size.0=11"});
  EXPECT_EQ(scenario.until, 5);
  EXPECT_EQ(scenario.spheres.at(0).count, 20U);
  EXPECT_EQ(scenario.spheres.at(1).positions.at(1), (Vec3{4, 5, 7}));
  EXPECT_EQ(scenario.box[0].size, 11);
}

TEST(Overrides, AddKeysAndTables) {
  const Scenario scenario = parse(kLeast, {"response.restitution=0.25", "run.until=5", "run.seed=9"});
  EXPECT_EQ(scenario.restitution, 0.25);
  EXPECT_EQ(scenario.until, 5);
  EXPECT_EQ(scenario.seed, 9U);
}

TEST(Overrides, TakePlainWordsAsStrings) {
  EXPECT_EQ(parse(kLeast, {"spheres.0.placement=fcc"}).spheres.at(0).placement, Placement::fcc);
  EXPECT_EQ(parse(kLeast, {"spheres.0.placement=\"fcc\""}).spheres.at(0).placement, Placement::fcc);
  EXPECT_EQ(parse(kLeast, {"output.directory=some/folder-2"}).output_directory, "some/folder-2");
}

TEST(Overrides, ApplyInOrder) {
  EXPECT_EQ(parse(kLeast, {"run.until=5", "run.until=6"}).until, 6);
}

TEST(LoadScenario, ReadsAFile) {
  const ScratchFolder folder;
  write_text(folder / "gas.toml", kLeast);
  const Scenario scenario = load_scenario(folder / "gas.toml");
  EXPECT_EQ(scenario.spheres.at(0).count, 10U);
  EXPECT_EQ(scenario.name, (folder / "gas.toml").string());
  EXPECT_THROW(load_scenario(folder / "missing.toml"), Error);
  EXPECT_THROW(load_scenario(folder.path()), Error);
}

struct Refusal {
  std::string name;
  std::string override_text;
  std::string where;
  std::string message;
};

class RefusedOverride : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedOverride, NamesPlaceAndProblem) {
  try {
    parse(kLeast, {GetParam().override_text});
    FAIL() << "the override was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), GetParam().where) << error.what();
    EXPECT_NE(std::string(error.what()).find(GetParam().message), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, RefusedOverride,
    testing::Values(
        Refusal{"NoEquals", "run.until", "--set", "key=value"}, Refusal{"NoKey", "=5", "--set", "key=value"},
        Refusal{"EndsInADot", "run.=5", "--set", "key=value"},
        Refusal{"NoValue", "run.until=", "--set run.until", "not valid TOML"},
        Refusal{"TwoLines", "run.until=1\nx=2", "--set run.until", "not valid TOML"},
        Refusal{"BadValue", "run.until=1x", "--set run.until", "not valid TOML"},
        Refusal{"WrongType", "run.until=soon", "--set run.until", "until is a string"},
        Refusal{"UnknownKey", "run.untill=5", "--set run.untill", "did you mean 'until'?"},
        Refusal{"UnknownTable", "rum.until=5", "--set rum.until", "did you mean 'run'?"},
        Refusal{"NoSuchGroup", "spheres.1.count=5", "--set spheres.1.count", "no entry '1'"},
        Refusal{"NoIndex", "spheres.first.count=5", "--set spheres.first.count", "no entry 'first'"},
        Refusal{"InsideAValue", "spheres.0.radius.x=5", "--set spheres.0.radius.x", "inside a plain value"},
        Refusal{"PartOfAnArray", "box.size.1=-4", "--set box.size.1", "size is -4"},
        Refusal{"WholeArray", "box.size=[1, 2]", "--set box.size", "size has 2 entries"},
        Refusal{"UnknownMeasure", "measures.names=[\"presure\"]", "--set measures.names",
                "did you mean \"pressure\"?"},
        Refusal{"MeasuresInThePast", "measures.from=-1", "--set measures.from", "from is -1"},
        Refusal{"MeasuresEveryZero", "measures.every=0", "--set measures.every", "every is 0"},
        Refusal{"TableAsNumber", "run=5", "--set run", "make it a table, [run]"}),
    [](const testing::TestParamInfo<Refusal>& test) { return test.param.name; });

}  // namespace
}  // namespace hardball
