// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/scenario.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::scenario_test {
namespace {

using namespace support;

const std::string kText = R"([box]
size = [10, 20.5, 30]
boundary = ["wall", "periodic", "open"]
gravity = [0.0, 0, -9.81]

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

[[walls]]
shape = "plane"
point = [1, 2, 3]
normal = [0, 0, 2]
temperature = 1.5
amplitude = 0.25
frequency = 3

[[walls]]
shape = "cylinder"
point = [5, 5, 5]
axis = [1, 1, 0]
radius = 4
restitution = 0.75
velocity = [0, 1, 0]

[[walls]]
shape = "sphere"
point = [5, 6, 7]
radius = 8

[[obstacles]]
position = [1, 1, 1]
radius = 0.5
temperature = 0

[[obstacles]]
positions = [[2, 2, 2], [3, 3, 3]]
radius = 0.25
restitution = 0

[response]
restitution = 0.5
elastic_below = 0.125

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
  EXPECT_EQ(scenario.gravity, (Vec3{0, 0, -9.81}));
  ASSERT_EQ(scenario.surfaces.size(), 6U);
  const Surface& plane = scenario.surfaces[0].surface;
  const OscillatingPlane& moving = std::get<OscillatingPlane>(plane.shape());
  EXPECT_EQ(plane.point(), (Vec3{1, 2, 3}));
  EXPECT_EQ(moving.normal(), (Vec3{0, 0, 1}));
  EXPECT_EQ(plane.material().temperature, 1.5);
  EXPECT_FALSE(plane.material().restitution);
  EXPECT_EQ(moving.amplitude(), 0.25);
  EXPECT_EQ(moving.frequency(), 3);
  EXPECT_EQ(scenario.surfaces[0].where, "gas.toml:18:1");
  const Surface& cylinder = scenario.surfaces[1].surface;
  const Vec3 axis = std::get<Cylinder>(cylinder.shape()).axis();
  EXPECT_NEAR(length(axis - std::sqrt(0.5) * Vec3{1, 1, 0}), 0, 1e-15);
  EXPECT_EQ(std::get<Cylinder>(cylinder.shape()).radius(), 4);
  EXPECT_EQ(cylinder.material().restitution, 0.75);
  EXPECT_FALSE(cylinder.material().temperature);
  EXPECT_EQ(cylinder.velocity(), (Vec3{0, 1, 0}));
  const Surface& sphere = scenario.surfaces[2].surface;
  EXPECT_EQ(sphere.point(), (Vec3{5, 6, 7}));
  EXPECT_EQ(std::get<HollowSphere>(sphere.shape()).radius(), 8);
  EXPECT_EQ(sphere.velocity(), Vec3{});
  const Surface& obstacle = scenario.surfaces[3].surface;
  EXPECT_TRUE(scenario.surfaces[3].is_obstacle());
  EXPECT_EQ(obstacle.point(), (Vec3{1, 1, 1}));
  EXPECT_EQ(std::get<Obstacle>(obstacle.shape()).radius(), 0.5);
  EXPECT_EQ(obstacle.material().temperature, 0);
  EXPECT_EQ(scenario.surfaces[4].surface.point(), (Vec3{2, 2, 2}));
  EXPECT_EQ(scenario.surfaces[5].surface.point(), (Vec3{3, 3, 3}));
  EXPECT_EQ(scenario.surfaces[5].surface.material().restitution, 0);
  EXPECT_EQ(scenario.surfaces[5].where, "gas.toml:44:1");
  EXPECT_EQ(scenario.restitution(), 0.5);
  EXPECT_EQ(scenario.bounce.elastic_below, 0.125);
  EXPECT_EQ(scenario.run.until, 12);
  EXPECT_EQ(scenario.run.seed, 7U);
  EXPECT_EQ(scenario.output.directory, "out");
  EXPECT_EQ(scenario.output.snapshots().time(3), 1.5);
  EXPECT_EQ(scenario.output.trajectory, std::vector{SnapshotFormat::extended_xyz});
  EXPECT_TRUE(scenario.output.event_log);
  EXPECT_FALSE(scenario.output.report);
  EXPECT_TRUE(scenario.output.recording);
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

TEST(ParseScenario, ReadsGrowthAndCones) {
  const std::string start =
      "[box]\nsize = [9.0, 9.0, 9.0]\nboundary = [\"wall\", \"wall\", \"wall\"]\n"
      "[[spheres]]\ncount = 1\nradius = 0.5\nplacement = \"random\"\ntemperature = 1.0\n";
  const Scenario scenario =
      parse(start +
            "[growth]\nrate = -0.25\npacking_fraction = 0.125\ncompressibility = 50.0\n"
            "[[walls]]\nshape = \"cone\"\npoint = [1.0, 2.0, 3.0]\naxis = [0.0, 0.0, 2.0]\n"
            "slope = 0.75\n");
  ASSERT_TRUE(scenario.growth);
  EXPECT_EQ(scenario.growth->rate, -0.25);
  EXPECT_EQ(scenario.growth->until_packing_fraction, 0.125);
  EXPECT_EQ(scenario.growth->until_compressibility, 50);
  EXPECT_TRUE(scenario.measures.names.empty());
  ASSERT_EQ(scenario.surfaces.size(), 1U);
  const Cone& cone = std::get<Cone>(scenario.surfaces[0].surface.shape());
  EXPECT_EQ(cone.axis(), (Vec3{0, 0, 1}));
  EXPECT_EQ(cone.slope(), 0.75);
  EXPECT_EQ(*parse(start + "[growth]\n").growth, GrowthRules());
  EXPECT_FALSE(parse(start).growth);
  EXPECT_THROW(parse(start + "[growth]\nrate = -0.1\n"), Error);
  EXPECT_THROW(parse(start + "[growth]\n[measures]\nnames = [\"pressure\"]\n"), Error);
}

TEST(ParseScenario, HasDefaults) {
  const Scenario scenario = parse(kLeast);
  EXPECT_EQ(scenario.spheres.at(0).mass, 1);
  EXPECT_EQ(scenario.gravity, Vec3{});
  EXPECT_TRUE(scenario.surfaces.empty());
  EXPECT_EQ(scenario.bounce.elastic_below, 0);
  EXPECT_EQ(scenario.restitution(), 1);
  EXPECT_FALSE(scenario.run.until);
  EXPECT_EQ(scenario.run.seed, 1U);
  EXPECT_FALSE(scenario.output.directory);
  EXPECT_TRUE(scenario.output.snapshots().is_never());
  EXPECT_TRUE(scenario.output.trajectory.empty());
  EXPECT_FALSE(scenario.output.event_log);
  EXPECT_TRUE(scenario.output.report);
  EXPECT_FALSE(scenario.output.recording);
  EXPECT_EQ(scenario.measures.names, std::vector<std::string>{"all"});
  EXPECT_FALSE(scenario.measures.every);
  EXPECT_EQ(scenario.measures.from, 0);
  EXPECT_FALSE(scenario.start_file);
}

TEST(ParseScenario, SamplesInTimeInItsLogarithmAndByContacts) {
  const Scenario logarithmic =
      parse(kLeast, {"output.snapshots_per_decade=2", "output.first_snapshot=0.5", "output.trajectory=gsd"});
  EXPECT_EQ(logarithmic.output.snapshots().time(0), 0);
  EXPECT_EQ(logarithmic.output.snapshots().time(1), 0.5);
  EXPECT_EQ(logarithmic.output.snapshots().time(3), 5);
  EXPECT_EQ(logarithmic.output.trajectory, std::vector{SnapshotFormat::gsd});
  const Scenario by_contacts = parse(
      kLeast, {"output.snapshots_every_contacts=100", R"(output.trajectory=["vtp", "xyz.zst", "lammps"])"});
  EXPECT_EQ(by_contacts.output.snapshots().contacts(2), 200U);
  EXPECT_EQ(by_contacts.output.trajectory,
            (std::vector{SnapshotFormat::vtp, SnapshotFormat::extended_xyz_zst, SnapshotFormat::lammps}));
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

RadiusDistribution distribution_of(const std::string& radius) {
  return parse_scenario(kLeast, "some/gas.toml", std::vector<std::string>{"spheres.0.radius=" + radius})
      .spheres.at(0)
      .distribution.value();
}

TEST(ParseScenario, ReadsDistributionsOfRadii) {
  using Kind = RadiusDistribution::Kind;
  const RadiusDistribution uniform = distribution_of("{distribution = \"uniform\", min = 1, max = 2}");
  EXPECT_EQ(uniform.kind, Kind::uniform);
  EXPECT_EQ(uniform.min, 1);
  EXPECT_EQ(uniform.max, 2);
  EXPECT_EQ(uniform.where, "--set spheres.0.radius");
  const RadiusDistribution lognormal =
      distribution_of("{distribution = \"lognormal\", mean = 2, sigma = 0.5, max = 3}");
  EXPECT_EQ(lognormal.kind, Kind::lognormal);
  EXPECT_EQ(lognormal.mean, 2);
  EXPECT_EQ(lognormal.sigma, 0.5);
  EXPECT_EQ(lognormal.min, 1e-60);
  EXPECT_EQ(lognormal.max, 3);
  const RadiusDistribution powerlaw =
      distribution_of("{distribution = \"powerlaw\", exponent = -3, min = 1, max = 2}");
  EXPECT_EQ(powerlaw.kind, Kind::powerlaw);
  EXPECT_EQ(powerlaw.exponent, -3);
  EXPECT_EQ(powerlaw.min, 1);
  const RadiusDistribution discrete =
      distribution_of("{distribution = \"discrete\", values = [1, 2], weights = [3, 4]}");
  EXPECT_EQ(discrete.kind, Kind::discrete);
  EXPECT_EQ(discrete.values, (std::vector<double>{1, 2}));
  EXPECT_EQ(discrete.weights, (std::vector<double>{3, 4}));
  const RadiusDistribution file = distribution_of("{distribution = \"file\", file = \"radii.txt\"}");
  EXPECT_EQ(file.kind, Kind::file);
  EXPECT_EQ(file.file, "some/radii.txt");
}

TEST(ParseScenario, TakesADensityAsMass) {
  const SphereGroup group = parse(kLeast, {"spheres.0.mass.density=3", "spheres.0.radius=2"}).spheres.at(0);
  EXPECT_EQ(group.density, 3);
  EXPECT_NEAR(group.mass_of(5), 32 * 3.14159265358979, 1e-10);
}

TEST(ParseScenario, TakesWholeNumbersInAnyForm) {
  EXPECT_EQ(parse(kLeast, {"spheres.0.count=1e3"}).spheres.at(0).count, 1000U);
  EXPECT_EQ(parse(kLeast, {"spheres.0.count=1_000"}).spheres.at(0).count, 1000U);
}

TEST(Overrides, ReplaceValues) {
  const Scenario scenario =
      parse(kText, {"run.until=5", "spheres.0.count=20", "spheres.1.positions.1.2=7", "box.size.0=11"});
  EXPECT_EQ(scenario.run.until, 5);
  EXPECT_EQ(scenario.spheres.at(0).count, 20U);
  EXPECT_EQ(scenario.spheres.at(1).positions.at(1), (Vec3{4, 5, 7}));
  EXPECT_EQ(scenario.box[0].size, 11);
}

TEST(Overrides, AddKeysAndTables) {
  const Scenario scenario = parse(kLeast, {"response.restitution=0.25", "run.until=5", "run.seed=9"});
  EXPECT_EQ(scenario.restitution(), 0.25);
  EXPECT_EQ(scenario.run.until, 5);
  EXPECT_EQ(scenario.run.seed, 9U);
}

TEST(Overrides, TakePlainWordsAsStrings) {
  EXPECT_EQ(parse(kLeast, {"spheres.0.placement=fcc"}).spheres.at(0).placement, Placement::fcc);
  EXPECT_EQ(parse(kLeast, {"spheres.0.placement=\"fcc\""}).spheres.at(0).placement, Placement::fcc);
  EXPECT_EQ(parse(kLeast, {"output.directory=some/folder-2"}).output.directory, "some/folder-2");
}

TEST(Overrides, ApplyInOrder) {
  EXPECT_EQ(parse(kLeast, {"run.until=5", "run.until=6"}).run.until, 6);
  EXPECT_EQ(parse(kLeast, {"run.until=.5"}).run.until, 0.5);
  EXPECT_EQ(parse(kLeast, {"run.until=5."}).run.until, 5);
  EXPECT_EQ(parse(kLeast, {"run.until=5.e2"}).run.until, 500);
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
  const Error error = error_of([&] { parse(kLeast, {GetParam().override_text}); });
  EXPECT_EQ(error.where(), GetParam().where) << error.what();
  EXPECT_NE(std::string(error.what()).find(GetParam().message), std::string::npos) << error.what();
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

// The parser calls itself for each level.
TEST(ParseScenario, RefusesMoreLevelsThanTheStackHolds) {
  const std::size_t many = 200'000;
  std::string dotted = "a";
  for (std::size_t i = 0; i < many; ++i) dotted += ".a";
  std::string spaced = "\"a.b\"";
  for (std::size_t i = 0; i < many; ++i) spaced += " . 'a'";
  std::string tables;
  for (std::size_t i = 0; i < many; ++i) tables += "{a = ";
  const std::string arrays(many, '[');
  for (const std::string& text :
       {dotted + " = 1", spaced + " = 1", "[" + dotted + "]", "[[" + dotted + "]]", "a = " + tables,
        "a = " + arrays, "x = {" + dotted + " = 1}", "a = \"\\\"\" # [\n" + dotted + " = 1"}) {
    const Error error = error_of([&] { parse_scenario(text, "gas.toml"); });
    EXPECT_NE(error.problem().find("more than 32 levels"), std::string::npos) << error.what();
    EXPECT_LT(std::string(error.what()).size(), 400U);
  }
  EXPECT_THROW(parse_scenario("", "gas.toml", std::vector<std::string>{dotted + "=1"}), Error);
}

// Brackets and dots that are none of keys and values.
TEST(ParseScenario, DoesNotCountLevelsInStringsAndComments) {
  const std::string brackets(100, '[');
  const std::string dots(100, '.');
  const std::string thrice(3, '\'');
  for (const std::string& value : {"\"" + brackets + dots + "\"", "'" + brackets + dots + "'",
                                   "1 # " + brackets + dots, "\"\"\"\n" + brackets + "\"" + dots + "\n\"\"\"",
                                   thrice + brackets + "\n" + dots + thrice, "\"\\\"" + brackets + "\""}) {
    const Error error = error_of([&] { parse_scenario("name = " + value, "gas.toml"); });
    EXPECT_NE(error.problem().find("unknown key 'name'"), std::string::npos) << error.what();
  }
}

TEST(ParseScenario, ShortensWhatItQuotes) {
  const std::string endless(5'000'000, 'k');
  for (const std::string& text :
       {endless + " = 1", "[box]\nboundary = [\"" + endless + "\"]", endless + " = 1\n" + endless + " = 2"}) {
    const Error error = error_of([&] { parse_scenario(text, "gas.toml"); });
    EXPECT_LT(std::string(error.what()).size(), 800U) << error.what();
  }
}

}  // namespace
}  // namespace hardball::scenario_test
