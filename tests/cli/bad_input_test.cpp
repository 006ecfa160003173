// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Every kind of bad input: exit code 2, one line that says what, where and the remedy, and no files.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <ostream>
#include <string>
#include <vector>

#include "cli/program.hpp"

namespace hardball::bad_input_test {
namespace {

using namespace support;

using Fragments = std::vector<std::string>;

struct BadInput {
  std::string name;
  /// A line of the scenario of the small gas, and its replacement.
  std::string line;
  std::string replacement;
  /// In addition to `run gas.toml --out out`.
  Arguments arguments;
  /// What the message contains, in this order.
  Fragments fragments;
};

const std::string kBox = "size = [10.0, 10.0, 10.0]\nboundary = [\"wall\", \"wall\", \"wall\"]";
const std::string kFlatBox = "dimensions = 2\nsize = [10, 10]\nboundary = ['wall', 'wall']";

BadInput replaced(const std::string& name, const std::string& line, const std::string& replacement,
                  const Fragments& fragments) {
  return {name, line, replacement, {}, fragments};
}

BadInput without(const std::string& name, const std::string& line, const Fragments& fragments) {
  return replaced(name, line, "", fragments);
}

// Tables from line 11 on.
BadInput bad_tables(const std::string& name, const std::string& tables, const Fragments& fragments) {
  return replaced(name, "[run]", tables + "\n[run]", fragments);
}

// Keys of a table that begins in line 11: of [output], [[walls]] and so on.
auto bad_keys_of(const std::string& table) {
  return [table](const std::string& name, const std::string& keys, const Fragments& fragments) {
    return bad_tables(name, table + "\n" + keys, fragments);
  };
}
const auto bad_output = bad_keys_of("[output]");
const auto bad_thermostat = bad_keys_of("[thermostat]");
const auto bad_response = bad_keys_of("[response]");
const auto bad_wall = bad_keys_of("[[walls]]");
const auto bad_obstacle = bad_keys_of("[[obstacles]]");

// Keys of spheres from line 10 on.
BadInput bad_spheres(const std::string& name, const std::string& keys, const Fragments& fragments) {
  return replaced(name, "mean_speed = 1.0", "mean_speed = 1.0\n" + keys, fragments);
}

// The radius of the small gas is in line 7, from column 10 on.
BadInput bad_radius(const std::string& name, const std::string& radius, const Fragments& fragments) {
  return replaced(name, "radius = 0.5", "radius = " + radius, fragments);
}

// In two dimensions; tables from line 5 on.
BadInput bad_in_plane(const std::string& name, const std::string& tables, const Arguments& arguments,
                      const Fragments& fragments) {
  return {name, kBox, kFlatBox + tables, arguments, fragments};
}

BadInput bad_options(const std::string& name, const Arguments& options, const Fragments& fragments) {
  return {name, "", "", options, fragments};
}

// How GoogleTest prints a failed case.
void PrintTo(const BadInput& input, std::ostream* out) {
  *out << input.name;
}

std::string scenario_of(const BadInput& input) {
  std::string text = kSmallGas;
  if (!input.line.empty()) text.replace(text.find(input.line), input.line.size(), input.replacement);
  return text;
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
    testing::Values(replaced("NoToml", "[run]", "[run", {"gas.toml:11:5", "TOML", "toml.io"}),
                    replaced("OddBrackets", "[run]", "[.[run]]", {"gas.toml:11:", "TOML", "toml.io"}),
                    replaced("KeyTwice", "seed = 1", "until = 2.0", {"gas.toml:13:", "TOML"}),
                    replaced("TableTwice", "[run]", "[box]", {"gas.toml:11:", "TOML"}),
                    replaced("OpenString", "\"random\"", "\"random", {"gas.toml:8:", "TOML"}),
                    replaced("BareWord", "\"random\"", "random", {"gas.toml:8:13", "TOML"}),
                    replaced("NumberTooLong", "count = 20", "count = 99999999999999999999",
                             {"gas.toml:6:", "TOML"})),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Keys, RefusedInput,
    testing::Values(
        replaced("UnknownTable", "[run]", "[rum]", {"gas.toml:11:2", "'rum'", "did you mean 'run'?"}),
        replaced("UnknownKeyInBox", "size", "sise", {"gas.toml:2:1", "'sise' in [box]", "'size'"}),
        replaced("UnknownKeyInSpheres", "radius", "raduis", {"gas.toml:7:1", "'raduis'", "'radius'"}),
        replaced("UnknownKeyInRun", "seed", "sead", {"gas.toml:13:1", "'sead' in [run]", "'seed'"}),
        replaced("KeyOfAnotherTable", "seed = 1", "directory = 'x'",
                 {"gas.toml:13:1", "'directory' in [run]"}),
        replaced("KeyOutsideTables", "[box]", "gravity = [0, 0, 0]\n[box]", {"gas.toml:1:1", "'gravity'"}),
        without("NoBox", "[box]\n" + kBox, {"gas.toml: ", "[box] is missing", "add"}),
        without("NoBoundary", "boundary = [\"wall\", \"wall\", \"wall\"]", {"gas.toml:1:1", "'boundary'"}),
        without("NoSize", "size = [10.0, 10.0, 10.0]", {"gas.toml:1:1", "'size' is missing", "add it"}),
        without("NoCount", "count = 20", {"gas.toml:5:1", "'count' is missing", "count = 1000"}),
        without("NoRadius", "radius = 0.5", {"gas.toml:5:1", "'radius' is missing", "radius = 1.0"}),
        without("NoPlacement", "placement = \"random\"", {"gas.toml:5:1", "'placement'", "\"random\""}),
        without("NoVelocity", "mean_speed = 1.0", {"gas.toml:5:1", "no velocities", "mean_speed"}),
        replaced("TwoVelocities", "mean_speed = 1.0", "mean_speed = 1.0\nspeed = 2.0",
                 {"gas.toml:10:9", "both mean_speed and speed", "keep one"}),
        without("NoUntil", "until = 5.0", {"gas.toml", "'until' is missing", "--until"}),
        bad_tables("StartAndSpheres", "[start]\nfile = 'x'", {"gas.toml:11:1", "both", "remove"}),
        replaced("PlacementAndPositions", "count = 20", "positions = [[5, 5, 5]]",
                 {"gas.toml:8:13", "both placement and positions", "remove"})),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    TwoDimensions, RefusedInput,
    testing::Values(
        replaced("FourDimensions", "[box]", "[box]\ndimensions = 4", {"gas.toml:2:14", "at most 3"}),
        replaced("ThreeBoundaries", "[box]", "[box]\ndimensions = 2", {"gas.toml:4:12", "3 entries", "two"}),
        replaced("ThreeSizes", kBox, "dimensions = 2\nsize = [10, 10, 10]\nboundary = ['wall', 'wall']",
                 {"gas.toml:3:8", "3 entries", "two numbers"}),
        replaced("TwoNumbersInThreeDimensions", "[box]", "[box]\ngravity = [0, 1]", {"three numbers"}),
        bad_in_plane("CubicLattice", "", {"--set", "spheres.0.placement=fcc"},
                     {"fcc", "two dimensions", "hexagonal"}),
        replaced("HexagonalInThreeDimensions", "\"random\"", "\"hexagonal\"",
                 {"gas.toml:8:13", "three dimensions", "fcc"}),
        bad_in_plane("GravityAcross", "", {"--set", "box.gravity=[0, 0, 1]"},
                     {"box.gravity", "gravity along z is 1", "two dimensions"}),
        bad_in_plane("ObstacleAcross", "\n[[obstacles]]\nradius = 1\nposition = [5, 5, 5]", {},
                     {"gas.toml:5:1", "the position of the obstacle along z is 5", "two dimensions"}),
        bad_in_plane("PlaneAcross", "\n[[walls]]\nshape = 'plane'\npoint = [5, 5]\nnormal = [0, 1, 1]", {},
                     {"gas.toml:5:1", "the normal of the plane along z", "two dimensions"}),
        BadInput{"PlaneInAPeriodicBox",
                 kBox,
                 kFlatBox.substr(0, kFlatBox.find("['wall")) +
                     "['periodic', 'wall']\n[[walls]]\nshape = 'plane'\npoint = [5, 5]\nnormal = [1, 0]",
                 {},
                 {"gas.toml:5:1", "the plane is not periodic along x", "parallel"}},
        bad_in_plane("TooDense", "", {"--set", "spheres.0.count=76", "--set", "spheres.0.radius=0.6"},
                     {"0.86", "hexagonal", "0.9"})),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Thermostats, RefusedInput,
    testing::Values(bad_thermostat("ThermostatWithoutKind", "rate = 1",
                                   {"gas.toml:11:1", "'kind' is missing"}),
                    bad_thermostat("UnknownThermostat", "kind = 'anderson'",
                                   {"gas.toml:12:8", "\"anderson\"", "\"andersen\""}),
                    bad_thermostat("RateOfRescale", "kind = 'rescale'\ntemperature = 1\nrate = 1",
                                   {"gas.toml:14:1", "'rate' does not go with kind"}),
                    bad_thermostat("AndersenWithoutTemperature", "kind = 'andersen'\nrate = 1",
                                   {"gas.toml:11:1", "'temperature' is missing"}),
                    bad_thermostat("AndersenWithoutRate", "kind = 'andersen'\ntemperature = 1",
                                   {"gas.toml:11:1", "'rate' is missing"}),
                    bad_thermostat("RescaleWithoutEvery", "kind = 'rescale'\ntemperature = 1",
                                   {"gas.toml:11:1", "'every' is missing"}),
                    bad_thermostat("HeatingWithoutStrength", "kind = 'heating'\nevery = 1",
                                   {"gas.toml:11:1", "'strength' is missing"}),
                    bad_thermostat("RateZero", "kind = 'andersen'\ntemperature = 1\nrate = 0",
                                   {"gas.toml:14:8", "rate", "0", "positive"}),
                    bad_thermostat("TemperatureNegative", "kind = 'rescale'\ntemperature = -1\nevery = 1",
                                   {"gas.toml:13:15", "temperature", "-1", "positive"}),
                    bad_thermostat("StrengthNoNumber", "kind = 'heating'\nstrength = true\nevery = 1",
                                   {"gas.toml:13:12", "strength"}),
                    bad_thermostat("EveryZero", "kind = 'heating'\nstrength = 1\nevery = 0",
                                   {"gas.toml:14:9", "every", "0", "positive"})),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Types, RefusedInput,
    testing::Values(
        replaced("BoxIsANumber", "[box]\n" + kBox, "box = 3",
                 {"gas.toml:1:7", "'box' is an integer", "[box]"}),
        replaced("SpheresIsATable", "[[spheres]]", "[spheres]", {"gas.toml:5:1", "a table", "[[spheres]]"}),
        replaced("RadiusIsAString", "radius = 0.5", "radius = \"0.5\"",
                 {"gas.toml:7:10", "a string", "number"}),
        replaced("CountIsAFraction", "count = 20", "count = 20.5", {"gas.toml:6:9", "20.5", "integer"}),
        replaced("CountIsTrue", "count = 20", "count = true", {"gas.toml:6:9", "true or false", "integer"}),
        replaced("SizeIsANumber", "[10.0, 10.0, 10.0]", "10.0",
                 {"gas.toml:2:8", "a number", "three numbers"}),
        replaced("SizeHasTwo", "[10.0, 10.0, 10.0]", "[10.0, 10.0]", {"gas.toml:2:8", "2 entries", "three"}),
        replaced("SizeHasAString", "[10.0, 10.0, 10.0]", "[10.0, 'x', 10.0]", {"gas.toml:2:15", "a string"}),
        replaced("BoundaryIsAString", "[\"wall\", \"wall\", \"wall\"]", "\"wall\"",
                 {"gas.toml:3:12", "a string"}),
        replaced("BoundaryHasOne", "[\"wall\", \"wall\", \"wall\"]", "[\"wall\"]",
                 {"gas.toml:3:12", "1 entry"}),
        replaced("PlacementIsANumber", "\"random\"", "1", {"gas.toml:8:13", "an integer", "double quotes"}),
        bad_output("EventLogIsANumber", "event_log = 1", {"gas.toml:12:13", "an integer", "true or false"}),
        replaced("UntilIsADate", "until = 5.0", "until = 1997-06-04", {"gas.toml:12:9", "a date", "number"}),
        replaced("PositionHasTwo", "placement = \"random\"", "positions = [[1, 2]]",
                 {"gas.toml:8:14", "2 entries"})),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Values, RefusedInput,
    testing::Values(
        replaced("BoundaryMisspelt", "[\"wall\", \"wall\"", "[\"wall\", \"perodic\"",
                 {"gas.toml:3:21", "\"perodic\"", "did you mean \"periodic\"?"}),
        replaced("PlacementMisspelt", "\"random\"", "\"fc\"", {"gas.toml:8:13", "\"fc\"", "\"fcc\"?"}),
        replaced("SizeIsZero", "[10.0, 10.0, 10.0]", "[10.0, 0.0, 10.0]",
                 {"gas.toml:2:15", "size is 0", "positive"}),
        replaced("SizeIsNegative", "[10.0, 10.0, 10.0]", "[-10.0, 10.0, 10.0]",
                 {"gas.toml:2:9", "size is -10"}),
        replaced("SizeIsInfinite", "[10.0, 10.0, 10.0]", "[inf, 10.0, 10.0]",
                 {"gas.toml:2:9", "size is inf"}),
        replaced("CountIsZero", "count = 20", "count = 0", {"gas.toml:6:9", "count is 0", "at least 1"}),
        replaced("CountIsNegative", "count = 20", "count = -1",
                 {"gas.toml:6:9", "count is -1", "at least 1"}),
        replaced("CountIsHuge", "count = 20", "count = 4294967295", {"gas.toml:6:9", "at most 4294967294"}),
        replaced("RadiusIsZero", "radius = 0.5", "radius = 0", {"gas.toml:7:10", "radius is 0", "positive"}),
        replaced("RadiusIsNegative", "radius = 0.5", "radius = -1", {"gas.toml:7:10", "radius is -1"}),
        replaced("RadiusIsNaN", "radius = 0.5", "radius = nan",
                 {"gas.toml:7:10", "radius is nan", "positive"}),
        replaced("RadiusIsTiny", "radius = 0.5", "radius = 1e-61", {"gas.toml:7:10", "radius is 1e-61"}),
        replaced("MassIsZero", "mean_speed", "mass = 0\nmean_speed",
                 {"gas.toml:9:8", "mass is 0", "positive"}),
        replaced("MassIsInfinite", "mean_speed", "mass = inf\nmean_speed", {"gas.toml:9:8", "mass is inf"}),
        replaced("SpeedIsNegative", "mean_speed = 1.0", "mean_speed = -1.0",
                 {"gas.toml:9:14", "mean_speed is -1"}),
        replaced("SpeedIsNaN", "mean_speed = 1.0", "speed = nan", {"gas.toml:9:9", "speed is nan", "finite"}),
        replaced("TemperatureIsInfinite", "mean_speed = 1.0", "temperature = inf", {"gas.toml:9:15", "inf"}),
        bad_response("RestitutionAboveOne", "restitution = 1.5",
                     {"gas.toml:12:15", "restitution is 1.5", "between 0 and 1"}),
        bad_response("RestitutionIsNaN", "restitution = nan", {"gas.toml:12:15", "nan"}),
        replaced("GravityIsInfinite", "[[spheres]]", "gravity = [0.0, 0.0, -inf]\n[[spheres]]",
                 {"gas.toml:5:22", "gravity is -inf", "finite"}),
        replaced("GravityIsTiny", "[[spheres]]", "gravity = [0.0, 0.0, 1e-61]\n[[spheres]]",
                 {"gas.toml:5:11", "the magnitude of gravity is 1e-61", "between"}),
        replaced("GravityWhoseSquareIsZero", "[[spheres]]", "gravity = [0.0, 0.0, -1e-300]\n[[spheres]]",
                 {"gas.toml:5:11", "the magnitude of gravity is 1e-300", "between"}),
        bad_response("ElasticBelowIsNegative", "elastic_below = -1",
                     {"gas.toml:12:17", "elastic_below is -1", "zero or a positive"}),
        replaced("UntilIsNegative", "until = 5.0", "until = -5.0",
                 {"gas.toml:12:9", "until is -5", "positive"}),
        replaced("UntilIsInfinite", "until = 5.0", "until = inf",
                 {"gas.toml:12:9", "until is inf", "finite"}),
        replaced("SeedIsNegative", "seed = 1", "seed = -1", {"gas.toml:13:8", "seed is -1", "at least 0"}),
        bad_output("SnapshotsEveryZero", "snapshots_every = 0.0",
                   {"gas.toml:12:19", "snapshots_every is 0", "positive"}),
        bad_output("TwoSchedules", "snapshots_every = 1\nsnapshots_every_contacts = 5",
                   {"gas.toml:13:28", "both snapshots_every and snapshots_every_contacts", "remove one"}),
        bad_output("LinearAndLogarithmic", "snapshots_every = 1\nsnapshots_per_decade = 5",
                   {"gas.toml:13:24", "both snapshots_every and snapshots_per_decade", "remove one"}),
        bad_output("LogarithmicByContacts", "snapshots_every_contacts = 1\nsnapshots_per_decade = 5",
                   {"gas.toml:12:28", "both snapshots_per_decade and snapshots_every_contacts",
                    "remove one"}),
        bad_output("LogarithmicWithoutFirst", "snapshots_per_decade = 5",
                   {"gas.toml:", "'first_snapshot' is missing", "add"}),
        bad_output("FirstSnapshotAlone", "snapshots_every = 1\nfirst_snapshot = 0.1",
                   {"gas.toml:13:18", "first_snapshot is given without snapshots_per_decade", "add"}),
        bad_output("NoContactsBetweenSnapshots", "snapshots_every_contacts = 0",
                   {"gas.toml:12:28", "snapshots_every_contacts is 0", "at least 1"}),
        bad_output("TrajectoryWithoutSnapshots", "trajectory = 'gsd'",
                   {"gas.toml:12:14", "no snapshots are taken", "add snapshots_every"}),
        bad_output("UnknownTrajectory", "snapshots_every = 1\ntrajectory = 'gds'",
                   {"gas.toml:13:14", "trajectory is \"gds\"", "\"gsd\""}),
        bad_output("NoTrajectory", "snapshots_every = 1\ntrajectory = []",
                   {"gas.toml:13:14", "trajectory has 0 entries", "at least one"}),
        bad_output("TrajectoryTwice", "snapshots_every = 1\ntrajectory = ['gsd', 'xyz', 'gsd']",
                   {"gas.toml:13:29", "trajectory has \"gsd\" twice", "remove one"}),
        bad_output("EmptyDirectory", "directory = ''", {"gas.toml:12:13", "is empty"}),
        replaced("SphereTooLarge", "radius = 0.5", "radius = 6", {"gas.toml:5:1", "diameter 12", "enlarge"}),
        replaced("TooManySpheres", "count = 20", "count = 100000",
                 {"gas.toml:5:1", "packing fraction", "enlarge"}),
        replaced("TooDenseForRandom", "count = 20", "count = 1200",
                 {"gas.toml:5:1", "packing fraction", "fcc", "0.74"}),
        replaced("TooDenseForFcc", "count = 20\nradius = 0.5\nplacement = \"random\"",
                 "count = 1400\nradius = 0.5\nplacement = \"fcc\"",
                 {"gas.toml:5:1", "radius can be at most"}),
        replaced("FccOfTwoRadii", "placement = \"random\"\nmean_speed = 1.0",
                 "placement = \"fcc\"\nspeed = 1\n[[spheres]]\ncount = 3\nradius = 1\nplacement = "
                 "\"fcc\"\nspeed = 1",
                 {"gas.toml:10:1", "one radius", "\"random\""}),
        replaced("ListsDisagree", "placement = \"random\"", "positions = [[5, 5, 5]]",
                 {"gas.toml:8:13", "1 entry", "20 spheres"}),
        replaced("InTheWall", "count = 20\nradius = 0.5\nplacement = \"random\"",
                 "radius = 0.5\npositions = [[0.4, 5, 5]]",
                 {"gas.toml:5:1: sphere 0", "through a wall", "0.5"}),
        replaced("Overlap", "count = 20\nradius = 0.5\nplacement = \"random\"",
                 "radius = 0.5\npositions = [[5, 5, 5], [5, 5, 5.9]]",
                 {"gas.toml", "0 and 1 overlap", "apart"})),
    name_of);

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

const std::string kPlane = "shape = 'plane'\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n";
const std::string kBall = "shape = 'sphere'\npoint = [5, 5, 5]\nradius = 4\n";

INSTANTIATE_TEST_SUITE_P(
    Walls, RefusedInput,
    testing::Values(
        bad_tables("WallsIsATable", "[walls]", {"gas.toml:11:1", "a table", "[[walls]]"}),
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
        replaced("DensityIsZero", "mean_speed", "mass = {density = 0}\nmean_speed",
                 {"gas.toml:9:19", "density is 0", "positive"}),
        replaced("MassOfNothing", "mean_speed", "mass = {}\nmean_speed",
                 {"gas.toml:9:8", "'density' is missing in mass", "density = 2.0"}),
        replaced("FccOfDistributedRadii", "radius = 0.5\nplacement = \"random\"",
                 "radius = {distribution = 'uniform', min = 0.1, max = 0.2}\nplacement = \"fcc\"",
                 {"gas.toml:5:1", "one radius", "\"random\""})),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Options, RefusedInput,
    testing::Values(
        bad_options("UnknownOption", {"--untill", "5"}, {"'--untill'", "did you mean '--until'?"}),
        bad_options("UnknownOptionWithValue", {"--sead=5"}, {"'--sead'", "did you mean '--seed'?"}),
        bad_options("SecondScenario", {"other.toml"}, {"'other.toml'", "run --help"}),
        bad_options("UntilIsNegative", {"--until", "-1"}, {"--until: ", "-1", "later"}),
        bad_options("UntilIsNaN", {"--until", "nan"}, {"--until: ", "nan", "finite"}),
        bad_options("UntilIsAWord", {"--until", "soon"}, {"--until: ", "'soon'", "give a time"}),
        bad_options("UntilHasNoValue", {"--until"}, {"--until", "--help"}),
        bad_options("SeedIsNegative", {"--seed", "-1"}, {"--seed: ", "'-1'", "integer"}),
        bad_options("SeedTooLarge", {"--seed", "18446744073709551616"}, {"--seed: ", "integer"}),
        bad_options("NoSuchEngine", {"--engine", "oracle"},
                    {"--engine: ", "'oracle'", "auto, cells, neighbors, all-pairs, paper"}),
        bad_options("NoSuchInstructions", {"--instructions", "mmx"},
                    {"--instructions: ", "'mmx'", "auto, portable, avx2, avx512"}),
        bad_options("ThreadsAreZero", {"--threads", "0"}, {"--threads: ", "'0'", "auto or a positive"}),
        bad_options("ThreadsAreAWord", {"--threads", "all"}, {"--threads: ", "'all'", "auto or a positive"}),
        bad_options("ThreadsOfMergingSpheres", {"--threads", "2", "--set", "response.kind='merge'"},
                    {"--threads: ", "merge", "one thread"}),
        bad_options("CellEdgeIsZero", {"--cell-edge", "0"}, {"--cell-edge: ", "0", "positive"}),
        bad_options("CellEdgeIsTiny", {"--cell-edge", "0.001"}, {"--cell-edge: ", "cells", "at least"}),
        bad_options("CellEdgeOfThePaper", {"--cell-edge", "0.5", "--engine", "paper"},
                    {"--cell-edge: ", "diameter", "at least 1"}),
        bad_options("CellEdgeIsAWord", {"--cell-edge", "large"}, {"--cell-edge: ", "'large'", "auto, paper"}),
        bad_options("UnitCostIsUnknown", {"--unit-costs", "contact=1,enter=1,cell=1,guess=1"},
                    {"--unit-costs: ", "'guess=1'", "contact=", "prediction="}),
        bad_options("UnitCostIsMissing", {"--unit-costs", "contact=1,enter=1,cell=1"},
                    {"--unit-costs: ", "all", "contact=", "prediction="}),
        bad_options("UnitCostIsNegative", {"--unit-costs", "contact=1,enter=-1,cell=1,prediction=1"},
                    {"--unit-costs: ", "'enter=-1'", "negative"}),
        bad_options("UnitCostIsNoNumber", {"--unit-costs", "contact=1,enter=x,cell=1,prediction=1"},
                    {"--unit-costs: ", "'x'"}),
        bad_options("PredictionsCostNothing", {"--unit-costs", "contact=1,enter=1,cell=1,prediction=0"},
                    {"--unit-costs: ", "nothing"}),
        bad_options("JsonTakesNoValue", {"--json=yes"}, {"json", "--help"}),
        bad_options("SetHasNoEquals", {"--set", "run.until"}, {"--set: ", "run.until=5"}),
        bad_options("SetIsUnknown", {"--set", "run.untill=5"}, {"--set run.untill: ", "'until'"}),
        bad_options("SetHasWrongType", {"--set", "spheres.0.count=many"},
                    {"--set spheres.0.count: ", "integer"}),
        bad_options("SetHasTwoLines", {"--set", "run.until=5\nseed=2"}, {"--set run.until: ", "TOML"})),
    name_of);

TEST(RefusedCommand, IsExplainedInOneLine) {
  const ScratchFolder folder;
  expect_refusal(run_program(folder, {"rnu"}), {"'rnu'", "did you mean 'run'?"});
  expect_refusal(run_program(folder, {"simulate"}),
                 {"'simulate'", "choose among 'run', 'resume', 'verify', 'check', 'tune'"});
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
  expect_refusal(Program(folder, {"-c", endless + HARDBALL_PROGRAM " run /dev/stdin"}, "/bin/sh").wait(),
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
  ProgramOutcome start_from(const std::string& snapshot) const {
    write_text(folder_ / "start.xyz", snapshot);
    return run();
  }
  ProgramOutcome run() const {
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
  const ProgramOutcome outcome = start_from(
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
  RefusedDirectory() { write_text(folder_ / "gas.toml", kSmallGas + "[output]\nsnapshots_every = 1\n"); }

  ScratchFolder folder_;
};

TEST_F(RefusedDirectory, IsAFile) {
  write_text(folder_ / "out", "precious");
  expect_refusal(run_program(folder_, {"run", "gas.toml", "--out", "out"}), {"out: ", "directory"});
  expect_refusal(run_program(folder_, {"run", "gas.toml", "--out", "out/deeper"}),
                 {"out/deeper: ", "directory"});
  EXPECT_EQ(read_text(folder_ / "out"), "precious");
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
    EXPECT_EQ(read_text(folder_ / "precious"), "precious") << name;
    EXPECT_EQ(read_text(folder_ / "elsewhere/quantities.csv"), "precious") << name;
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
  const std::string trajectory = read_text(folder_ / "out/trajectory.xyz");
  write_text(folder_ / "again.toml",
             "[box]\nsize = [10, 10, 10]\nboundary = ['wall', 'wall', 'wall']\n"
             "[start]\nfile = 'out/trajectory.xyz'\n[run]\nuntil = 1\n[output]\nsnapshots_every = 1\n");
  expect_refusal(run_program(folder_, {"run", "again.toml", "--out", "out"}),
                 {"trajectory.xyz: ", "overwrite"});
  EXPECT_EQ(read_text(folder_ / "out/trajectory.xyz"), trajectory);
}

}  // namespace
}  // namespace hardball::bad_input_test
