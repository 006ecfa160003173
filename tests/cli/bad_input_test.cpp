// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Every kind of bad input: exit code 2, one line that says what, where and the remedy, and no files.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "cli/program.hpp"

namespace hardball::bad_input_test {
namespace {

using support::Arguments;
using support::Outcome;
using support::run_program;
using support::ScratchFolder;
using support::write_text;

struct BadInput {
  std::string name;
  /// A line of the scenario of the small gas, and its replacement.
  std::string line;
  std::string replacement;
  /// In addition to `run gas.toml --out out`.
  Arguments arguments;
  /// What the message contains, in this order.
  std::vector<std::string> fragments;
};

// How GoogleTest prints a failed case.
void PrintTo(const BadInput& input, std::ostream* out) {
  *out << input.name;
}

std::string scenario_of(const BadInput& input) {
  std::string text = support::kSmallGas;
  if (!input.line.empty()) text.replace(text.find(input.line), input.line.size(), input.replacement);
  return text;
}

void expect_refusal(const Outcome& outcome, const std::vector<std::string>& fragments) {
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.output, "");
  EXPECT_EQ(std::count(outcome.messages.begin(), outcome.messages.end(), '\n'), 1) << outcome.messages;
  EXPECT_TRUE(outcome.messages.starts_with("hardball: ")) << outcome.messages;
  std::size_t at = 0;
  for (const std::string& fragment : fragments) {
    at = outcome.messages.find(fragment, at);
    ASSERT_NE(at, std::string::npos) << "no '" << fragment << "' in: " << outcome.messages;
  }
}

class RefusedInput : public testing::TestWithParam<BadInput> {};

TEST_P(RefusedInput, IsExplainedInOneLine) {
  const ScratchFolder folder;
  write_text(folder / "gas.toml", scenario_of(GetParam()));
  Arguments arguments{"run", "gas.toml", "--out", "out"};
  arguments.insert(arguments.end(), GetParam().arguments.begin(), GetParam().arguments.end());
  expect_refusal(run_program(folder, arguments), GetParam().fragments);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

std::string name_of(const testing::TestParamInfo<BadInput>& test) {
  return test.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Syntax, RefusedInput,
    testing::Values(
        BadInput{"NoToml", "[run]", "[run", {}, {"gas.toml:11:5", "TOML", "toml.io"}},
        BadInput{"OddBrackets", "[run]", "[.[run]]", {}, {"gas.toml:11:", "TOML", "toml.io"}},
        BadInput{"KeyTwice", "seed = 1", "until = 2.0", {}, {"gas.toml:13:", "TOML"}},
        BadInput{"TableTwice", "[run]", "[box]", {}, {"gas.toml:11:", "TOML"}},
        BadInput{"OpenString", "\"random\"", "\"random", {}, {"gas.toml:8:", "TOML"}},
        BadInput{"BareWord", "\"random\"", "random", {}, {"gas.toml:8:13", "TOML"}},
        BadInput{"NumberTooLong", "count = 20", "count = 99999999999999999999", {}, {"gas.toml:6:", "TOML"}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Keys, RefusedInput,
    testing::Values(
        BadInput{"UnknownTable", "[run]", "[rum]", {}, {"gas.toml:11:2", "'rum'", "did you mean 'run'?"}},
        BadInput{"UnknownKeyInBox", "size", "sise", {}, {"gas.toml:2:1", "'sise' in [box]", "'size'"}},
        BadInput{"UnknownKeyInSpheres", "radius", "raduis", {}, {"gas.toml:7:1", "'raduis'", "'radius'"}},
        BadInput{"UnknownKeyInRun", "seed", "sead", {}, {"gas.toml:13:1", "'sead' in [run]", "'seed'"}},
        BadInput{"KeyOfAnotherTable",
                 "seed = 1",
                 "directory = 'x'",
                 {},
                 {"gas.toml:13:1", "'directory' in [run]"}},
        BadInput{
            "KeyOutsideTables", "[box]", "gravity = [0, 0, 0]\n[box]", {}, {"gas.toml:1:1", "'gravity'"}},
        BadInput{"NoBox",
                 "[box]\nsize = [10.0, 10.0, 10.0]\nboundary = [\"wall\", \"wall\", \"wall\"]",
                 "",
                 {},
                 {"gas.toml: ", "[box] is missing", "add"}},
        BadInput{"NoBoundary",
                 "boundary = [\"wall\", \"wall\", \"wall\"]",
                 "",
                 {},
                 {"gas.toml:1:1", "'boundary'"}},
        BadInput{
            "NoSize", "size = [10.0, 10.0, 10.0]", "", {}, {"gas.toml:1:1", "'size' is missing", "add it"}},
        BadInput{"NoCount", "count = 20", "", {}, {"gas.toml:5:1", "'count' is missing", "count = 1000"}},
        BadInput{"NoRadius", "radius = 0.5", "", {}, {"gas.toml:5:1", "'radius' is missing", "radius = 1.0"}},
        BadInput{
            "NoPlacement", "placement = \"random\"", "", {}, {"gas.toml:5:1", "'placement'", "\"random\""}},
        BadInput{"NoVelocity", "mean_speed = 1.0", "", {}, {"gas.toml:5:1", "no velocities", "mean_speed"}},
        BadInput{"TwoVelocities",
                 "mean_speed = 1.0",
                 "mean_speed = 1.0\nspeed = 2.0",
                 {},
                 {"gas.toml:10:9", "both mean_speed and speed", "keep one"}},
        BadInput{"NoUntil", "until = 5.0", "", {}, {"gas.toml", "'until' is missing", "--until"}},
        BadInput{"StartAndSpheres",
                 "[run]",
                 "[start]\nfile = 'x'\n[run]",
                 {},
                 {"gas.toml:11:1", "both", "remove"}},
        BadInput{"PlacementAndPositions",
                 "count = 20",
                 "positions = [[5, 5, 5]]",
                 {},
                 {"gas.toml:8:13", "both placement and positions", "remove"}}),
    name_of);

const std::string kBox = "size = [10.0, 10.0, 10.0]\nboundary = [\"wall\", \"wall\", \"wall\"]";
const std::string kFlatBox = "dimensions = 2\nsize = [10, 10]\nboundary = ['wall', 'wall']";

INSTANTIATE_TEST_SUITE_P(
    TwoDimensions, RefusedInput,
    testing::Values(
        BadInput{"FourDimensions", "[box]", "[box]\ndimensions = 4", {}, {"gas.toml:2:14", "at most 3"}},
        BadInput{
            "ThreeBoundaries", "[box]", "[box]\ndimensions = 2", {}, {"gas.toml:4:12", "3 entries", "two"}},
        BadInput{"ThreeSizes",
                 kBox,
                 "dimensions = 2\nsize = [10, 10, 10]\nboundary = ['wall', 'wall']",
                 {},
                 {"gas.toml:3:8", "3 entries", "two numbers"}},
        BadInput{"TwoNumbersInThreeDimensions", "[box]", "[box]\ngravity = [0, 1]", {}, {"three numbers"}},
        BadInput{"CubicLattice",
                 kBox,
                 kFlatBox,
                 {"--set", "spheres.0.placement=fcc"},
                 {"fcc", "two dimensions", "hexagonal"}},
        BadInput{"HexagonalInThreeDimensions",
                 "\"random\"",
                 "\"hexagonal\"",
                 {},
                 {"gas.toml:8:13", "three dimensions", "fcc"}},
        BadInput{"GravityAcross",
                 kBox,
                 kFlatBox,
                 {"--set", "box.gravity=[0, 0, 1]"},
                 {"box.gravity", "gravity along z is 1", "two dimensions"}},
        BadInput{"ObstacleAcross",
                 kBox,
                 kFlatBox + "\n[[obstacles]]\nradius = 1\nposition = [5, 5, 5]",
                 {},
                 {"gas.toml:5:1", "the position of the obstacle along z is 5", "two dimensions"}},
        BadInput{"PlaneAcross",
                 kBox,
                 kFlatBox + "\n[[walls]]\nshape = 'plane'\npoint = [5, 5]\nnormal = [0, 1, 1]",
                 {},
                 {"gas.toml:5:1", "the normal of the plane along z", "two dimensions"}},
        BadInput{"PlaneInAPeriodicBox",
                 kBox,
                 kFlatBox.substr(0, kFlatBox.find("['wall")) +
                     "['periodic', 'wall']\n[[walls]]\nshape = 'plane'\npoint = [5, 5]\nnormal = [1, 0]",
                 {},
                 {"gas.toml:5:1", "the plane is not periodic along x", "parallel"}},
        BadInput{"TooDense",
                 kBox,
                 kFlatBox,
                 {"--set", "spheres.0.count=76", "--set", "spheres.0.radius=0.6"},
                 {"0.86", "hexagonal", "0.9"}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Thermostats, RefusedInput,
    testing::Values(BadInput{"ThermostatWithoutKind",
                             "[run]",
                             "[thermostat]\nrate = 1\n[run]",
                             {},
                             {"gas.toml:11:1", "'kind' is missing"}},
                    BadInput{"UnknownThermostat",
                             "[run]",
                             "[thermostat]\nkind = 'anderson'\n[run]",
                             {},
                             {"gas.toml:12:8", "\"anderson\"", "\"andersen\""}},
                    BadInput{"RateOfRescale",
                             "[run]",
                             "[thermostat]\nkind = 'rescale'\ntemperature = 1\nrate = 1\n[run]",
                             {},
                             {"gas.toml:14:1", "'rate' does not go with kind"}},
                    BadInput{"AndersenWithoutTemperature",
                             "[run]",
                             "[thermostat]\nkind = 'andersen'\nrate = 1\n[run]",
                             {},
                             {"gas.toml:11:1", "'temperature' is missing"}},
                    BadInput{"AndersenWithoutRate",
                             "[run]",
                             "[thermostat]\nkind = 'andersen'\ntemperature = 1\n[run]",
                             {},
                             {"gas.toml:11:1", "'rate' is missing"}},
                    BadInput{"RescaleWithoutEvery",
                             "[run]",
                             "[thermostat]\nkind = 'rescale'\ntemperature = 1\n[run]",
                             {},
                             {"gas.toml:11:1", "'every' is missing"}},
                    BadInput{"HeatingWithoutStrength",
                             "[run]",
                             "[thermostat]\nkind = 'heating'\nevery = 1\n[run]",
                             {},
                             {"gas.toml:11:1", "'strength' is missing"}},
                    BadInput{"RateZero",
                             "[run]",
                             "[thermostat]\nkind = 'andersen'\ntemperature = 1\nrate = 0\n[run]",
                             {},
                             {"gas.toml:14:8", "rate", "0", "positive"}},
                    BadInput{"TemperatureNegative",
                             "[run]",
                             "[thermostat]\nkind = 'rescale'\ntemperature = -1\nevery = 1\n[run]",
                             {},
                             {"gas.toml:13:15", "temperature", "-1", "positive"}},
                    BadInput{"StrengthNoNumber",
                             "[run]",
                             "[thermostat]\nkind = 'heating'\nstrength = true\nevery = 1\n[run]",
                             {},
                             {"gas.toml:13:12", "strength"}},
                    BadInput{"EveryZero",
                             "[run]",
                             "[thermostat]\nkind = 'heating'\nstrength = 1\nevery = 0\n[run]",
                             {},
                             {"gas.toml:14:9", "every", "0", "positive"}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Types, RefusedInput,
    testing::Values(
        BadInput{"BoxIsANumber",
                 "[box]\nsize = [10.0, 10.0, 10.0]\nboundary = [\"wall\", \"wall\", \"wall\"]",
                 "box = 3",
                 {},
                 {"gas.toml:1:7", "'box' is an integer", "[box]"}},
        BadInput{
            "SpheresIsATable", "[[spheres]]", "[spheres]", {}, {"gas.toml:5:1", "a table", "[[spheres]]"}},
        BadInput{"RadiusIsAString",
                 "radius = 0.5",
                 "radius = \"0.5\"",
                 {},
                 {"gas.toml:7:10", "a string", "number"}},
        BadInput{"CountIsAFraction", "count = 20", "count = 20.5", {}, {"gas.toml:6:9", "20.5", "integer"}},
        BadInput{
            "CountIsTrue", "count = 20", "count = true", {}, {"gas.toml:6:9", "true or false", "integer"}},
        BadInput{
            "SizeIsANumber", "[10.0, 10.0, 10.0]", "10.0", {}, {"gas.toml:2:8", "a number", "three numbers"}},
        BadInput{
            "SizeHasTwo", "[10.0, 10.0, 10.0]", "[10.0, 10.0]", {}, {"gas.toml:2:8", "2 entries", "three"}},
        BadInput{
            "SizeHasAString", "[10.0, 10.0, 10.0]", "[10.0, 'x', 10.0]", {}, {"gas.toml:2:15", "a string"}},
        BadInput{"BoundaryIsAString",
                 "[\"wall\", \"wall\", \"wall\"]",
                 "\"wall\"",
                 {},
                 {"gas.toml:3:12", "a string"}},
        BadInput{"BoundaryHasOne",
                 "[\"wall\", \"wall\", \"wall\"]",
                 "[\"wall\"]",
                 {},
                 {"gas.toml:3:12", "1 entry"}},
        BadInput{
            "PlacementIsANumber", "\"random\"", "1", {}, {"gas.toml:8:13", "an integer", "double quotes"}},
        BadInput{"EventLogIsANumber",
                 "[run]",
                 "[output]\nevent_log = 1\n[run]",
                 {},
                 {"gas.toml:12:13", "an integer", "true or false"}},
        BadInput{
            "UntilIsADate", "until = 5.0", "until = 1997-06-04", {}, {"gas.toml:12:9", "a date", "number"}},
        BadInput{"PositionHasTwo",
                 "placement = \"random\"",
                 "positions = [[1, 2]]",
                 {},
                 {"gas.toml:8:14", "2 entries"}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Values, RefusedInput,
    testing::Values(
        BadInput{"BoundaryMisspelt",
                 "[\"wall\", \"wall\"",
                 "[\"wall\", \"perodic\"",
                 {},
                 {"gas.toml:3:21", "\"perodic\"", "did you mean \"periodic\"?"}},
        BadInput{"PlacementMisspelt", "\"random\"", "\"fc\"", {}, {"gas.toml:8:13", "\"fc\"", "\"fcc\"?"}},
        BadInput{"SizeIsZero",
                 "[10.0, 10.0, 10.0]",
                 "[10.0, 0.0, 10.0]",
                 {},
                 {"gas.toml:2:15", "size is 0", "positive"}},
        BadInput{"SizeIsNegative",
                 "[10.0, 10.0, 10.0]",
                 "[-10.0, 10.0, 10.0]",
                 {},
                 {"gas.toml:2:9", "size is -10"}},
        BadInput{
            "SizeIsInfinite", "[10.0, 10.0, 10.0]", "[inf, 10.0, 10.0]", {}, {"gas.toml:2:9", "size is inf"}},
        BadInput{"CountIsZero", "count = 20", "count = 0", {}, {"gas.toml:6:9", "count is 0", "at least 1"}},
        BadInput{
            "CountIsNegative", "count = 20", "count = -1", {}, {"gas.toml:6:9", "count is -1", "at least 1"}},
        BadInput{
            "CountIsHuge", "count = 20", "count = 4294967295", {}, {"gas.toml:6:9", "at most 4294967294"}},
        BadInput{
            "RadiusIsZero", "radius = 0.5", "radius = 0", {}, {"gas.toml:7:10", "radius is 0", "positive"}},
        BadInput{"RadiusIsNegative", "radius = 0.5", "radius = -1", {}, {"gas.toml:7:10", "radius is -1"}},
        BadInput{"RadiusIsNaN",
                 "radius = 0.5",
                 "radius = nan",
                 {},
                 {"gas.toml:7:10", "radius is nan", "positive"}},
        BadInput{"RadiusIsTiny", "radius = 0.5", "radius = 1e-61", {}, {"gas.toml:7:10", "radius is 1e-61"}},
        BadInput{"MassIsZero",
                 "mean_speed",
                 "mass = 0\nmean_speed",
                 {},
                 {"gas.toml:9:8", "mass is 0", "positive"}},
        BadInput{
            "MassIsInfinite", "mean_speed", "mass = inf\nmean_speed", {}, {"gas.toml:9:8", "mass is inf"}},
        BadInput{"SpeedIsNegative",
                 "mean_speed = 1.0",
                 "mean_speed = -1.0",
                 {},
                 {"gas.toml:9:14", "mean_speed is -1"}},
        BadInput{
            "SpeedIsNaN", "mean_speed = 1.0", "speed = nan", {}, {"gas.toml:9:9", "speed is nan", "finite"}},
        BadInput{
            "TemperatureIsInfinite", "mean_speed = 1.0", "temperature = inf", {}, {"gas.toml:9:15", "inf"}},
        BadInput{"RestitutionAboveOne",
                 "[run]",
                 "[response]\nrestitution = 1.5\n[run]",
                 {},
                 {"gas.toml:12:15", "restitution is 1.5", "between 0 and 1"}},
        BadInput{"RestitutionIsNaN",
                 "[run]",
                 "[response]\nrestitution = nan\n[run]",
                 {},
                 {"gas.toml:12:15", "nan"}},
        BadInput{"GravityIsInfinite",
                 "[[spheres]]",
                 "gravity = [0.0, 0.0, -inf]\n[[spheres]]",
                 {},
                 {"gas.toml:5:22", "gravity is -inf", "finite"}},
        BadInput{"GravityIsTiny",
                 "[[spheres]]",
                 "gravity = [0.0, 0.0, 1e-61]\n[[spheres]]",
                 {},
                 {"gas.toml:5:11", "the magnitude of gravity is 1e-61", "between"}},
        BadInput{"GravityWhoseSquareIsZero",
                 "[[spheres]]",
                 "gravity = [0.0, 0.0, -1e-300]\n[[spheres]]",
                 {},
                 {"gas.toml:5:11", "the magnitude of gravity is 1e-300", "between"}},
        BadInput{"ElasticBelowIsNegative",
                 "[run]",
                 "[response]\nelastic_below = -1\n[run]",
                 {},
                 {"gas.toml:12:17", "elastic_below is -1", "zero or a positive"}},
        BadInput{"UntilIsNegative",
                 "until = 5.0",
                 "until = -5.0",
                 {},
                 {"gas.toml:12:9", "until is -5", "positive"}},
        BadInput{
            "UntilIsInfinite", "until = 5.0", "until = inf", {}, {"gas.toml:12:9", "until is inf", "finite"}},
        BadInput{
            "SeedIsNegative", "seed = 1", "seed = -1", {}, {"gas.toml:13:8", "seed is -1", "at least 0"}},
        BadInput{"SnapshotsEveryZero",
                 "[run]",
                 "[output]\nsnapshots_every = 0.0\n[run]",
                 {},
                 {"gas.toml:12:19", "snapshots_every is 0", "positive"}},
        BadInput{"TwoSchedules",
                 "[run]",
                 "[output]\nsnapshots_every = 1\nsnapshots_every_contacts = 5\n[run]",
                 {},
                 {"gas.toml:13:28", "both snapshots_every and snapshots_every_contacts", "remove one"}},
        BadInput{"LinearAndLogarithmic",
                 "[run]",
                 "[output]\nsnapshots_every = 1\nsnapshots_per_decade = 5\n[run]",
                 {},
                 {"gas.toml:13:24", "both snapshots_every and snapshots_per_decade", "remove one"}},
        BadInput{"LogarithmicByContacts",
                 "[run]",
                 "[output]\nsnapshots_every_contacts = 1\nsnapshots_per_decade = 5\n[run]",
                 {},
                 {"gas.toml:12:28", "both snapshots_per_decade and snapshots_every_contacts", "remove one"}},
        BadInput{"LogarithmicWithoutFirst",
                 "[run]",
                 "[output]\nsnapshots_per_decade = 5\n[run]",
                 {},
                 {"gas.toml:", "'first_snapshot' is missing", "add"}},
        BadInput{"FirstSnapshotAlone",
                 "[run]",
                 "[output]\nsnapshots_every = 1\nfirst_snapshot = 0.1\n[run]",
                 {},
                 {"gas.toml:13:18", "first_snapshot is given without snapshots_per_decade", "add"}},
        BadInput{"NoContactsBetweenSnapshots",
                 "[run]",
                 "[output]\nsnapshots_every_contacts = 0\n[run]",
                 {},
                 {"gas.toml:12:28", "snapshots_every_contacts is 0", "at least 1"}},
        BadInput{"TrajectoryWithoutSnapshots",
                 "[run]",
                 "[output]\ntrajectory = 'gsd'\n[run]",
                 {},
                 {"gas.toml:12:14", "no snapshots are taken", "add snapshots_every"}},
        BadInput{"UnknownTrajectory",
                 "[run]",
                 "[output]\nsnapshots_every = 1\ntrajectory = 'gds'\n[run]",
                 {},
                 {"gas.toml:13:14", "trajectory is \"gds\"", "\"gsd\""}},
        BadInput{"NoTrajectory",
                 "[run]",
                 "[output]\nsnapshots_every = 1\ntrajectory = []\n[run]",
                 {},
                 {"gas.toml:13:14", "trajectory has 0 entries", "at least one"}},
        BadInput{"TrajectoryTwice",
                 "[run]",
                 "[output]\nsnapshots_every = 1\ntrajectory = ['gsd', 'xyz', 'gsd']\n[run]",
                 {},
                 {"gas.toml:13:29", "trajectory has \"gsd\" twice", "remove one"}},
        BadInput{
            "EmptyDirectory", "[run]", "[output]\ndirectory = ''\n[run]", {}, {"gas.toml:12:13", "is empty"}},
        BadInput{
            "SphereTooLarge", "radius = 0.5", "radius = 6", {}, {"gas.toml:5:1", "diameter 12", "enlarge"}},
        BadInput{"TooManySpheres",
                 "count = 20",
                 "count = 100000",
                 {},
                 {"gas.toml:5:1", "packing fraction", "enlarge"}},
        BadInput{"TooDenseForRandom",
                 "count = 20",
                 "count = 1200",
                 {},
                 {"gas.toml:5:1", "packing fraction", "fcc", "0.74"}},
        BadInput{"TooDenseForFcc",
                 "count = 20\nradius = 0.5\nplacement = \"random\"",
                 "count = 1400\nradius = 0.5\nplacement = \"fcc\"",
                 {},
                 {"gas.toml:5:1", "radius can be at most"}},
        BadInput{"FccOfTwoRadii",
                 "placement = \"random\"\nmean_speed = 1.0",
                 "placement = \"fcc\"\nspeed = 1\n[[spheres]]\ncount = 3\nradius = 1\nplacement = "
                 "\"fcc\"\nspeed = 1",
                 {},
                 {"gas.toml:10:1", "one radius", "\"random\""}},
        BadInput{"ListsDisagree",
                 "placement = \"random\"",
                 "positions = [[5, 5, 5]]",
                 {},
                 {"gas.toml:8:13", "1 entry", "20 spheres"}},
        BadInput{"InTheWall",
                 "count = 20\nradius = 0.5\nplacement = \"random\"",
                 "radius = 0.5\npositions = [[0.4, 5, 5]]",
                 {},
                 {"gas.toml:5:1: sphere 0", "through a wall", "0.5"}},
        BadInput{"Overlap",
                 "count = 20\nradius = 0.5\nplacement = \"random\"",
                 "radius = 0.5\npositions = [[5, 5, 5], [5, 5, 5.9]]",
                 {},
                 {"gas.toml", "0 and 1 overlap", "apart"}}),
    name_of);

// Tables from line 11 on.
BadInput bad_tables(const std::string& name, const std::string& tables,
                    const std::vector<std::string>& fragments) {
  return {name, "[run]", tables + "\n[run]", {}, fragments};
}

BadInput bad_response(const std::string& name, const std::string& keys,
                      const std::vector<std::string>& fragments) {
  return bad_tables(name, "[response]\n" + keys, fragments);
}

// Keys of spheres from line 10 on.
BadInput bad_spheres(const std::string& name, const std::string& keys,
                     const std::vector<std::string>& fragments) {
  return {name, "mean_speed = 1.0", "mean_speed = 1.0\n" + keys, {}, fragments};
}

const std::string kSpecies = "[[species]]\nname = 'steel'\n";
const std::string kPair = kSpecies + "[[response.pairs]]\n";

INSTANTIATE_TEST_SUITE_P(
    Responses, RefusedInput,
    testing::Values(
        bad_response("UnknownLaw", "restitution = {law = 'viscous'}",
                     {"gas.toml:12:22", "law is \"viscous\"", "viscoelastic"}),
        bad_response("NoLaw", "restitution = {value = 1}", {"gas.toml:12:15", "'law' is missing"}),
        bad_response("LawWithoutValue", "restitution = {law = 'viscoelastic', speed = 1}",
                     {"gas.toml:12:15", "'value' is missing in restitution"}),
        bad_response("ValueOfATable", "restitution = {law = 'tabulated', value = 1}",
                     {"gas.toml:12:35", "'value' does not go with law"}),
        bad_response("ViscoelasticAndSticky", "restitution = {law = 'viscoelastic', value = 0, speed = 1}",
                     {"gas.toml:12:15", "a viscoelastic restitution of 0", "at least"}),
        bad_response("SpeedsDecrease", "restitution = {law = 'tabulated', speeds = [1, 0], values = [1, 1]}",
                     {"gas.toml:12:15", "speed 0 is out of order", "increase"}),
        bad_response("FewerValues", "restitution = {law = 'tabulated', speeds = [1, 2], values = [1]}",
                     {"gas.toml:12:61", "values has 1 entry", "each of the speeds"}),
        bad_response("NoSpeeds", "restitution = {law = 'tabulated', speeds = [], values = []}",
                     {"gas.toml:12:15", "is empty", "at least one"}),
        bad_response("TooRough", "tangential_restitution = -1.5",
                     {"gas.toml:12:26", "-1.5", "between -1 and 1"}),
        bad_response("NegativeDuration", "contact_duration = -1",
                     {"gas.toml:12:20", "-1", "zero or a positive"}),
        bad_response("AllPass", "kind = 'pass'", {"gas.toml:12:8", "kind is \"pass\"", "\"merge\""}),
        bad_response("PairsIsANumber", "pairs = 3", {"gas.toml:12:9", "an integer", "[[response.pairs]]"}),
        bad_response("MeasuresOfMergingSpheres", "kind = 'merge'\n[measures]\nnames = ['pressure']",
                     {"gas.toml:14:9", "spheres that merge", "names = []"}),
        bad_tables("PairWithoutKind", kPair + "between = ['steel', 'steel']",
                   {"gas.toml:13:1", "'kind' is missing in [[response.pairs]]"}),
        bad_tables("PairOfUnknownSpecies", kPair + "kind = 'pass'\nbetween = ['steel', 'stel']",
                   {"gas.toml:15:21", "no species \"stel\"", "\"steel\"?"}),
        bad_tables("PairWithoutSpecies", "[[response.pairs]]\nkind = 'pass'\nbetween = ['a', 'b']",
                   {"gas.toml:13:12", "no species \"a\"", "add [[species]]"}),
        bad_tables("PairOfThree", kPair + "kind = 'pass'\nbetween = ['steel', 'steel', 'steel']",
                   {"gas.toml:15:11", "3 entries", "two species"}),
        bad_tables("PairOfWalls", kPair + "kind = 'bounce'\nbetween = ['wall', 'wall']",
                   {"gas.toml:15:20", "no species \"wall\""}),
        bad_tables("MergingWithWalls", kPair + "kind = 'merge'\nbetween = ['wall', 'steel']",
                   {"gas.toml:15:11", "only bounce off walls", "\"bounce\""}),
        bad_tables("TwoRulesForAPair",
                   kPair + "kind = 'pass'\nbetween = ['steel', 'steel']\n[[response.pairs]]\n" +
                       "kind = 'bounce'\nbetween = ['steel', 'steel']",
                   {"gas.toml:18:11", "two rules for the same species", "remove one"}),
        bad_tables("RestitutionOfMerging",
                   kPair + "kind = 'merge'\nbetween = ['steel', 'steel']\nrestitution = 1",
                   {"gas.toml:16:1", "'restitution' does not go with kind"}),
        bad_tables("PairWithANumber", kPair + "kind = 'merge'\nbetween = ['steel', 1]",
                   {"gas.toml:15:21", "an integer", "a string"}),
        bad_tables("SpeciesTwice", kSpecies + kSpecies,
                   {"gas.toml:14:8", "two species \"steel\"", "another"}),
        bad_tables("SpeciesNamedWall", "[[species]]\nname = 'wall'",
                   {"gas.toml:12:8", "\"wall\"", "another"}),
        bad_tables("SpeciesWithoutName", "[[species]]\nmoment = 1", {"gas.toml:11:1", "'name' is missing"}),
        bad_tables("MomentIsZero", kSpecies + "moment = 0", {"gas.toml:13:10", "moment is 0", "positive"}),
        bad_spheres("SpheresOfUnknownSpecies", "species = 'b'", {"gas.toml:10:11", "no species \"b\""}),
        bad_spheres("KinematicWithMass", "mass = 1\nkinematic = true",
                    {"gas.toml:10:8", "both mass and kinematic", "remove one"}),
        bad_spheres("KinematicIsANumber", "kinematic = 1", {"gas.toml:10:13", "an integer", "true or false"}),
        bad_spheres("TooFewSpins", "spins = [[0, 0, 1]]", {"gas.toml:10:9", "1 entry", "20 spheres"}),
        bad_spheres("SpinsAndTemperature", "spins = [[0, 0, 1]]\nrotational_temperature = 1",
                    {"gas.toml:10:9", "both rotational_temperature and spins"}),
        bad_spheres("NegativeRotationalTemperature", "rotational_temperature = -1",
                    {"gas.toml:10:26", "-1", "zero or a positive"}),
        BadInput{"KinematicUnderGravity",
                 "boundary = [\"wall\", \"wall\", \"wall\"]",
                 "boundary = [\"wall\", \"wall\", \"wall\"]\ngravity = [0, 0, -1]",
                 {"--set", "spheres.0.kinematic=true"},
                 {"gas.toml:6:1", "does not fall", "remove gravity"}}),
    name_of);

// The keys of the wall begin in line 12.
BadInput bad_wall(const std::string& name, const std::string& keys,
                  const std::vector<std::string>& fragments) {
  return {name, "[run]", "[[walls]]\n" + keys + "\n[run]", {}, fragments};
}

BadInput bad_obstacle(const std::string& name, const std::string& keys,
                      const std::vector<std::string>& fragments) {
  return {name, "[run]", "[[obstacles]]\n" + keys + "\n[run]", {}, fragments};
}

const std::string kPlane = "shape = 'plane'\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n";
const std::string kBall = "shape = 'sphere'\npoint = [5, 5, 5]\nradius = 4\n";

INSTANTIATE_TEST_SUITE_P(
    Walls, RefusedInput,
    testing::Values(
        BadInput{"WallsIsATable", "[run]", "[walls]\n[run]", {}, {"gas.toml:11:1", "a table", "[[walls]]"}},
        bad_wall("NoShape", "point = [0, 0, 0]",
                 {"gas.toml:11:1", "'shape' is missing in [[walls]]", "plane"}),
        bad_wall("ShapeMisspelt", "shape = 'plan'", {"gas.toml:12:9", "\"plan\"", "\"plane\"?"}),
        bad_wall("NoPoint", "shape = 'plane'", {"gas.toml:11:1", "'point' is missing"}),
        bad_wall("NoNormal", "shape = 'plane'\npoint = [0, 0, 0]", {"gas.toml:11:1", "'normal' is missing"}),
        bad_wall("NoAxis", "shape = 'cylinder'\npoint = [0, 0, 0]", {"gas.toml:11:1", "'axis' is missing"}),
        bad_wall("NoRadius", "shape = 'sphere'\npoint = [0, 0, 0]", {"gas.toml:11:1", "'radius' is missing"}),
        bad_wall("UnknownKey", kPlane + "norml = 3", {"gas.toml:15:1", "'norml' in [[walls]]", "'normal'"}),
        bad_wall("RadiusOfAPlane", kPlane + "radius = 1",
                 {"gas.toml:15:1", "'radius' does not go with shape = \"plane\"", "remove it"}),
        bad_wall("NormalOfASphere", kBall + "normal = [0, 0, 1]",
                 {"gas.toml:15:1", "'normal' does not go with"}),
        bad_wall("AxisOfASphere", kBall + "axis = [0, 0, 1]", {"gas.toml:15:1", "'axis' does not go with"}),
        bad_wall("SphereOscillates", kBall + "amplitude = 1",
                 {"gas.toml:15:1", "'amplitude' does not go with"}),
        bad_wall("NormalIsZero", "shape = 'plane'\npoint = [0, 0, 0]\nnormal = [0, 0, 0]",
                 {"gas.toml:14:10", "the length of normal is 0", "positive"}),
        bad_wall("AxisIsZero", "shape = 'cylinder'\npoint = [0, 0, 0]\naxis = [0, 0, 0]\nradius = 1",
                 {"gas.toml:14:8", "the length of axis is 0"}),
        bad_wall("RadiusIsZero", "shape = 'sphere'\npoint = [0, 0, 0]\nradius = 0",
                 {"gas.toml:14:10", "radius is 0", "positive"}),
        bad_wall("PointHasTwo", "shape = 'plane'\npoint = [0, 0]", {"gas.toml:13:9", "2 entries", "three"}),
        bad_wall("RestitutionAboveOne", kPlane + "restitution = 2",
                 {"gas.toml:15:15", "restitution is 2", "between 0 and 1"}),
        bad_wall("TemperatureIsNegative", kPlane + "temperature = -1",
                 {"gas.toml:15:15", "temperature is -1", "zero or"}),
        bad_wall("RestitutionAndTemperature", kPlane + "restitution = 1\ntemperature = 1",
                 {"gas.toml:16:15", "both restitution and temperature", "remove one"}),
        bad_wall("AmplitudeAlone", kPlane + "amplitude = 1",
                 {"gas.toml:11:1", "'frequency' is missing", "add it"}),
        bad_wall("FrequencyAlone", kPlane + "frequency = 1", {"gas.toml:11:1", "'amplitude' is missing"}),
        bad_wall("AmplitudeIsZero", kPlane + "amplitude = 0\nfrequency = 1",
                 {"gas.toml:15:13", "amplitude is 0", "positive"}),
        bad_wall("VelocityAndAmplitude", kPlane + "amplitude = 1\nfrequency = 1\nvelocity = [0, 0, 1]",
                 {"gas.toml:17:12", "both velocity and amplitude", "remove one"}),
        bad_wall("VelocityIsANumber", kPlane + "velocity = 1",
                 {"gas.toml:15:12", "an integer", "three numbers"}),
        bad_obstacle("ObstacleNowhere", "radius = 1", {"gas.toml:11:1", "'position' is missing", "add it"}),
        bad_obstacle("ObstacleWithoutRadius", "position = [5, 5, 5]",
                     {"gas.toml:11:1", "'radius' is missing"}),
        bad_obstacle("ObstacleTwice", "radius = 1\nposition = [5, 5, 5]\npositions = [[5, 5, 5]]",
                     {"gas.toml:14:13", "both position and positions", "remove one"}),
        bad_obstacle("ObstacleRadiusIsNegative", "radius = -1\nposition = [5, 5, 5]",
                     {"gas.toml:12:10", "radius is -1", "positive"}),
        bad_obstacle("ObstacleUnknownKey", "radius = 1\nposition = [5, 5, 5]\nmass = 1",
                     {"gas.toml:14:1", "'mass' in [[obstacles]]", "choose among"}),
        bad_obstacle("ObstacleRestitutionAndTemperature",
                     "radius = 1\nposition = [5, 5, 5]\nrestitution = 1\ntemperature = 1",
                     {"gas.toml:15:15", "both restitution and temperature"})),
    name_of);

// The radius of the small gas is in line 7, from column 10 on.
BadInput bad_radius(const std::string& name, const std::string& radius,
                    const std::vector<std::string>& fragments) {
  return {name, "radius = 0.5", "radius = " + radius, {}, fragments};
}

INSTANTIATE_TEST_SUITE_P(
    Radii, RefusedInput,
    testing::Values(
        bad_radius("IsAList", "[0.5, 1.0]", {"gas.toml:7:10", "an array", "a number, or a table"}),
        bad_radius("NoDistribution", "{min = 1, max = 2}",
                   {"gas.toml:7:10", "'distribution' is missing in radius"}),
        bad_radius("DistributionMisspelt", "{distribution = 'unifrom'}",
                   {"gas.toml:7:26", "\"unifrom\"", "\"uniform\"?"}),
        bad_radius("UnknownKey", "{distribution = 'uniform', min = 1, mx = 2}",
                   {"gas.toml:7:46", "'mx' in radius", "'max'?"}),
        bad_radius("NoMax", "{distribution = 'uniform', min = 1}",
                   {"gas.toml:7:10", "'max' is missing in radius"}),
        bad_radius("MinAboveMax", "{distribution = 'powerlaw', exponent = 1, min = 2, max = 1}",
                   {"gas.toml:7:10", "min is 2 and max is 1", "not less"}),
        bad_radius("MeanOfAPowerLaw", "{distribution = 'powerlaw', exponent = 1, min = 1, max = 2, mean = 1}",
                   {"gas.toml:7:70", "'mean' does not go with distribution = \"powerlaw\"", "remove it"}),
        bad_radius("SigmaIsZero", "{distribution = 'lognormal', mean = 1, sigma = 0}",
                   {"gas.toml:7:57", "sigma is 0", "positive"}),
        bad_radius("WeightIsNegative", "{distribution = 'discrete', values = [1], weights = [-1]}",
                   {"gas.toml:7:63", "weights is -1", "positive"}),
        bad_radius("OneWeightForTwo", "{distribution = 'discrete', values = [1, 2], weights = [1]}",
                   {"gas.toml:7:65", "weights has 1 entry", "as many"}),
        bad_radius("NoSuchFile", "{distribution = 'file', file = 'missing.txt'}",
                   {"gas.toml:7:10", "missing.txt cannot be read"}),
        BadInput{"DensityIsZero",
                 "mean_speed",
                 "mass = {density = 0}\nmean_speed",
                 {},
                 {"gas.toml:9:19", "density is 0", "positive"}},
        BadInput{"MassOfNothing",
                 "mean_speed",
                 "mass = {}\nmean_speed",
                 {},
                 {"gas.toml:9:8", "'density' is missing in mass", "density = 2.0"}},
        BadInput{"FccOfDistributedRadii",
                 "radius = 0.5\nplacement = \"random\"",
                 "radius = {distribution = 'uniform', min = 0.1, max = 0.2}\nplacement = \"fcc\"",
                 {},
                 {"gas.toml:5:1", "one radius", "\"random\""}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Options, RefusedInput,
    testing::Values(
        BadInput{"UnknownOption", "", "", {"--untill", "5"}, {"'--untill'", "did you mean '--until'?"}},
        BadInput{"UnknownOptionWithValue", "", "", {"--sead=5"}, {"'--sead'", "did you mean '--seed'?"}},
        BadInput{"SecondScenario", "", "", {"other.toml"}, {"'other.toml'", "run --help"}},
        BadInput{"UntilIsNegative", "", "", {"--until", "-1"}, {"--until: ", "-1", "later"}},
        BadInput{"UntilIsNaN", "", "", {"--until", "nan"}, {"--until: ", "nan", "finite"}},
        BadInput{"UntilIsAWord", "", "", {"--until", "soon"}, {"--until: ", "'soon'", "give a time"}},
        BadInput{"UntilHasNoValue", "", "", {"--until"}, {"--until", "--help"}},
        BadInput{"SeedIsNegative", "", "", {"--seed", "-1"}, {"--seed: ", "'-1'", "integer"}},
        BadInput{"SeedTooLarge", "", "", {"--seed", "18446744073709551616"}, {"--seed: ", "integer"}},
        BadInput{"NoSuchEngine",
                 "",
                 "",
                 {"--engine", "oracle"},
                 {"--engine: ", "'oracle'", "auto, cells, neighbors, all-pairs, paper"}},
        BadInput{"NoSuchInstructions",
                 "",
                 "",
                 {"--instructions", "mmx"},
                 {"--instructions: ", "'mmx'", "auto, portable, avx2, avx512"}},
        BadInput{"ThreadsAreZero", "", "", {"--threads", "0"}, {"--threads: ", "'0'", "auto or a positive"}},
        BadInput{
            "ThreadsAreAWord", "", "", {"--threads", "all"}, {"--threads: ", "'all'", "auto or a positive"}},
        BadInput{"ThreadsOfMergingSpheres",
                 "",
                 "",
                 {"--threads", "2", "--set", "response.kind='merge'"},
                 {"--threads: ", "merge", "one thread"}},
        BadInput{"CellEdgeIsZero", "", "", {"--cell-edge", "0"}, {"--cell-edge: ", "0", "positive"}},
        BadInput{"CellEdgeIsTiny", "", "", {"--cell-edge", "0.001"}, {"--cell-edge: ", "cells", "at least"}},
        BadInput{"CellEdgeOfThePaper",
                 "",
                 "",
                 {"--cell-edge", "0.5", "--engine", "paper"},
                 {"--cell-edge: ", "diameter", "at least 1"}},
        BadInput{
            "CellEdgeIsAWord", "", "", {"--cell-edge", "large"}, {"--cell-edge: ", "'large'", "auto, paper"}},
        BadInput{"UnitCostIsUnknown",
                 "",
                 "",
                 {"--unit-costs", "contact=1,enter=1,cell=1,guess=1"},
                 {"--unit-costs: ", "'guess=1'", "contact=", "prediction="}},
        BadInput{"UnitCostIsMissing",
                 "",
                 "",
                 {"--unit-costs", "contact=1,enter=1,cell=1"},
                 {"--unit-costs: ", "all", "contact=", "prediction="}},
        BadInput{"UnitCostIsNegative",
                 "",
                 "",
                 {"--unit-costs", "contact=1,enter=-1,cell=1,prediction=1"},
                 {"--unit-costs: ", "'enter=-1'", "negative"}},
        BadInput{"UnitCostIsNoNumber",
                 "",
                 "",
                 {"--unit-costs", "contact=1,enter=x,cell=1,prediction=1"},
                 {"--unit-costs: ", "'x'"}},
        BadInput{"PredictionsCostNothing",
                 "",
                 "",
                 {"--unit-costs", "contact=1,enter=1,cell=1,prediction=0"},
                 {"--unit-costs: ", "nothing"}},
        BadInput{"JsonTakesNoValue", "", "", {"--json=yes"}, {"json", "--help"}},
        BadInput{"SetHasNoEquals", "", "", {"--set", "run.until"}, {"--set: ", "run.until=5"}},
        BadInput{"SetIsUnknown", "", "", {"--set", "run.untill=5"}, {"--set run.untill: ", "'until'"}},
        BadInput{"SetHasWrongType",
                 "",
                 "",
                 {"--set", "spheres.0.count=many"},
                 {"--set spheres.0.count: ", "integer"}},
        BadInput{"SetHasTwoLines", "", "", {"--set", "run.until=5\nseed=2"}, {"--set run.until: ", "TOML"}}),
    name_of);

TEST(RefusedCommand, IsExplainedInOneLine) {
  const ScratchFolder folder;
  expect_refusal(run_program(folder, {"rnu"}), {"'rnu'", "did you mean 'run'?"});
  expect_refusal(run_program(folder, {"sweep"}),
                 {"'sweep'", "choose among 'run', 'resume', 'verify', 'check', 'tune'"});
  expect_refusal(run_program(folder, {"run"}), {"SCENARIO", "--help"});
  expect_refusal(run_program(folder, {"--json", "run", "gas.toml"}), {"'--json'", "after the command"});
  expect_refusal(run_program(folder, {"verify", "gas.toml", "--json"}), {"'--json'"});
  expect_refusal(run_program(folder, {"completion", "tcsh"}), {"'tcsh'", "bash, zsh, fish"});
  expect_refusal(run_program(folder, {"completion", "bash", "zsh"}), {"unexpected argument", "'zsh'"});
  expect_refusal(run_program(folder, {"manual", "run"}), {"'run'"});
}

TEST(RefusedScenario, IsNamed) {
  const ScratchFolder folder;
  for (const std::string command : {"run", "verify", "check"}) {
    expect_refusal(run_program(folder, {command, "missing.toml"}),
                   {"missing.toml: ", "cannot be read", "scenario file"});
    expect_refusal(run_program(folder, {command, "."}), {"cannot be read"});
  }
  write_text(folder / "empty.toml", "");
  expect_refusal(run_program(folder, {"run", "empty.toml"}), {"empty.toml: ", "[box]", "add"});
  write_text(folder / "binary.toml", "\xff\xfe\x00");
  expect_refusal(run_program(folder, {"run", "binary.toml"}), {"binary.toml:1:1", "TOML"});
}

TEST(RefusedScenario, IsEndless) {
  if (!std::filesystem::exists("/dev/zero")) GTEST_SKIP() << "there is no /dev/zero";
  const ScratchFolder folder;
  for (const std::string command : {"run", "verify", "check", "tune"}) {
    expect_refusal(run_program(folder, {command, "/dev/zero"}), {"/dev/zero: ", "16 MiB", "[start]"});
  }
  const std::string endless =
      "while :; do printf '# nothing but comments, for ever and ever\\n'; done | exec ";
  expect_refusal(
      support::Program(folder, {"-c", endless + HARDBALL_PROGRAM " run /dev/stdin"}, "/bin/sh").wait(),
      {"/dev/stdin: ", "16 MiB"});
}

TEST(RefusedScenario, HasAKeyThatNeedsQuotes) {
  const ScratchFolder folder;
  const auto refused = [&](const std::string& text, const std::string& place, const std::string& remedy) {
    write_text(folder / "gas.toml", text);
    expect_refusal(run_program(folder, {"check", "gas.toml"}), {place, "invalid TOML", remedy});
  };
  refused(
      "[gr\xc3\xb6\xc3\x9f"
      "e]\n",
      "gas.toml:1:4: ", "toml.io");
  refused("[box]\nsize = [1, 1, 1]\n\n  [\xc3\xb6l]\n", "gas.toml:4:4: ", "quotes");
  refused("[box]\n[[ \xe6\x97\xa5\xe6\x9c\xac ]]\n", "gas.toml:2:", "quotes");
}

class RefusedStart : public testing::Test {
 protected:
  Outcome start_from(const std::string& snapshot) const {
    write_text(folder_ / "start.xyz", snapshot);
    return run();
  }
  Outcome run() const {
    write_text(folder_ / "gas.toml",
               "[box]\nsize = [10, 10, 10]\nboundary = ['wall', 'wall', 'wall']\n"
               "[start]\nfile = 'start.xyz'\n[run]\nuntil = 1\n");
    return run_program(folder_, {"run", "gas.toml", "--out", "out"});
  }

  ScratchFolder folder_;
};

TEST_F(RefusedStart, NamesTheLineOfTheStartFile) {
  const std::string head = "2\nProperties=pos:R:3:velo:R:3:radius:R:1\n5 5 5 0 0 0 0.5\n";
  expect_refusal(run(), {"start.xyz: ", "cannot be read"});
  expect_refusal(start_from("many\n"), {"start.xyz:1:1: ", "number of its spheres"});
  expect_refusal(start_from("1\nno columns\n5 5 5\n"), {"start.xyz:2: ", "Properties"});
  expect_refusal(start_from(head), {"start.xyz:3: ", "ends after 1 of the 2", "incomplete"});
  expect_refusal(start_from(head + "5 5 x 0 0 0 0.5\n"), {"start.xyz:4:5: ", "'x'", "finite"});
  expect_refusal(start_from(head + "5 5 9.9 0 0 0 0.5\n"), {"start.xyz:4: sphere 1: ", "wall"});
  expect_refusal(start_from(head + "5 5 8 0 0 0 -0.5\n"), {"start.xyz:4: ", "radius is -0.5"});
  expect_refusal(start_from(head + "5 5 5.5 0 0 0 0.5\n"), {"gas.toml: ", "spheres 0 and 1 overlap"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(RefusedStart, HasABoxThatIsNotUnderstood) {
  const std::string columns = " Properties=pos:R:3:velo:R:3:radius:R:1\n5 5 5 0 0 0 0.5\n";
  expect_refusal(start_from("1\nLattice=\"9 0 0 0 9 0 0 0 9\" pbc=\"yes yes no\"" + columns),
                 {"start.xyz:2:34: ", "pbc is 'yes'", "T or F"});
  expect_refusal(start_from("1\nLattice=\"9 0 0 0 9 0 0 0.9\"" + columns), {"start.xyz:2:10: ", "8 values"});
}

// The run uses the box of the scenario.
TEST_F(RefusedStart, SaysThatItsBoxIsAnother) {
  const Outcome outcome = start_from(
      "1\nLattice=\"9 0 0 0 9 0 0 0 9\" Properties=pos:R:3:velo:R:3:radius:R:1\n5 5 5 0 0 0 0.5\n");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  const std::string note =
      "hardball: the box of start.xyz, 9 x 9 x 9, periodic along x, y, z, is not that of [box], which is "
      "used\n";
  EXPECT_EQ(outcome.messages, note);
  EXPECT_EQ(run_program(folder_, {"check", "gas.toml"}).messages, note);
}

TEST_F(RefusedStart, IsNotARegularFile) {
  std::filesystem::create_symlink("/dev/zero", folder_ / "start.xyz");
  expect_refusal(run(), {"start.xyz: ", "not a regular file"});
  std::filesystem::remove(folder_ / "start.xyz");
  ASSERT_EQ(mkfifo((folder_ / "start.xyz").c_str(), 0600), 0);
  expect_refusal(run(), {"start.xyz: ", "not a regular file"});
  std::filesystem::remove(folder_ / "start.xyz");
  std::filesystem::create_directory(folder_ / "start.xyz");
  expect_refusal(run(), {"start.xyz: ", "not a regular file"});
}

TEST_F(RefusedStart, HasNoKnownName) {
  write_text(folder_ / "gas.toml",
             "[box]\nsize = [10, 10, 10]\nboundary = ['wall', 'wall', 'wall']\n"
             "[start]\nfile = 'start.pdb'\n[run]\nuntil = 1\n");
  expect_refusal(run_program(folder_, {"run", "gas.toml"}), {"gas.toml:5:8: ", "start.pdb", ".gsd"});
}

TEST_F(RefusedStart, HasNoVelocities) {
  write_text(folder_ / "start.sph", "1\n10 10 10\na 5 5 5 0.5\n");
  const std::string scenario =
      "[box]\nsize = [10, 10, 10]\nboundary = ['wall', 'wall', 'wall']\n[run]\nuntil = 1\n"
      "[start]\nfile = 'start.sph'\n";
  write_text(folder_ / "gas.toml", scenario);
  expect_refusal(run_program(folder_, {"run", "gas.toml"}), {"start.sph: ", "no velocities", "temperature"});
  write_text(folder_ / "gas.toml", scenario + "temperature = 1\nmean_speed = 1\n");
  expect_refusal(run_program(folder_, {"run", "gas.toml"}),
                 {"gas.toml:8:15", "both mean_speed and temperature"});
  write_text(folder_ / "gas.toml", scenario + "temperature = 1\n");
  EXPECT_EQ(run_program(folder_, {"run", "gas.toml", "--quiet"}).exit_code, 0);
}

class RefusedDirectory : public testing::Test {
 protected:
  RefusedDirectory() {
    write_text(folder_ / "gas.toml", support::kSmallGas + "[output]\nsnapshots_every = 1\n");
  }

  ScratchFolder folder_;
};

TEST_F(RefusedDirectory, IsAFile) {
  write_text(folder_ / "out", "precious");
  expect_refusal(run_program(folder_, {"run", "gas.toml", "--out", "out"}), {"out: ", "directory"});
  expect_refusal(run_program(folder_, {"run", "gas.toml", "--out", "out/deeper"}),
                 {"out/deeper: ", "directory"});
  EXPECT_EQ(support::read_text(folder_ / "out"), "precious");
}

TEST_F(RefusedDirectory, HoldsADirectoryWhereAFileShouldBe) {
  std::filesystem::create_directories(folder_ / "out/events.npy");
  expect_refusal(run_program(folder_, {"run", "gas.toml", "--out", "out"}), {"events.npy: ", "directory"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/trajectory.xyz"));
}

TEST_F(RefusedDirectory, LeadsNowhere) {
  std::filesystem::create_symlink("missing/trajectory.xyz", folder_ / "link");
  std::filesystem::create_directories(folder_ / "out");
  std::filesystem::create_symlink("../missing/file", folder_ / "out/trajectory.xyz");
  expect_refusal(run_program(folder_, {"run", "gas.toml", "--out", "out"}),
                 {"trajectory.xyz: ", "No such file"});
}

TEST_F(RefusedDirectory, HoldsLinksToFilesOfOthers) {
  std::filesystem::create_directory(folder_ / "out");
  std::filesystem::create_directory(folder_ / "elsewhere");
  const auto expect_kept = [&](const std::string& name, const Arguments& arguments) {
    write_text(folder_ / "elsewhere/quantities.csv", "precious");
    write_text(folder_ / "precious", "precious");
    std::filesystem::remove(folder_ / name);
    const bool is_folder = name.ends_with("measures") || name.ends_with("checkpoints");
    std::filesystem::create_symlink(folder_ / (is_folder ? "elsewhere" : "precious"), folder_ / name);
    expect_refusal(run_program(folder_, arguments), {name + ": ", "symbolic link", "remove the link"});
    EXPECT_EQ(support::read_text(folder_ / "precious"), "precious") << name;
    EXPECT_EQ(support::read_text(folder_ / "elsewhere/quantities.csv"), "precious") << name;
    std::filesystem::remove(folder_ / name);
  };
  for (const std::string name : {"trajectory.xyz", "trajectory.gsd", "events.npy", "summary.json",
                                 "checkpoint.hbc", "report.html", "run.lock", "measures", "checkpoints"}) {
    expect_kept("out/" + name, {"run", "gas.toml", "--out", "out", "--overwrite"});
  }
  ASSERT_EQ(run_program(folder_, {"run", "gas.toml", "--out", "out", "--quiet"}).exit_code, 0);
  expect_kept("link.csv", {"convert", "out/trajectory.xyz", "link.csv", "--overwrite"});
  expect_kept("link.xyz", {"pack", "--count", "10", "--phi", "0.1", "--out", "link.xyz", "--overwrite"});
}

TEST_F(RefusedDirectory, HoldsTheStartFile) {
  ASSERT_EQ(run_program(folder_, {"run", "gas.toml", "--out", "out"}).exit_code, 0);
  const std::string trajectory = support::read_text(folder_ / "out/trajectory.xyz");
  write_text(folder_ / "again.toml",
             "[box]\nsize = [10, 10, 10]\nboundary = ['wall', 'wall', 'wall']\n"
             "[start]\nfile = 'out/trajectory.xyz'\n[run]\nuntil = 1\n[output]\nsnapshots_every = 1\n");
  expect_refusal(run_program(folder_, {"run", "again.toml", "--out", "out"}),
                 {"trajectory.xyz: ", "overwrite"});
  EXPECT_EQ(support::read_text(folder_ / "out/trajectory.xyz"), trajectory);
}

}  // namespace
}  // namespace hardball::bad_input_test
