// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// hardball check: what it expects of a run.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "cli/program.hpp"

namespace hardball::check_test {
namespace {

using namespace support;

class WhatCheckExpects : public ProgramTest {
 protected:
  // What check prints of a scenario.
  std::string output(const std::string& scenario, const Arguments& more = {}) {
    write_text(folder_ / "scenario.toml", scenario);
    return succeed({"check", "scenario.toml"}, more).output;
  }
};

std::string line_of(const std::string& output, const std::string& name) {
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(name + " ")) return line.substr(24);
  }
  ADD_FAILURE() << "no line '" << name << "' in\n" << output;
  return "";
}

double number_of(const std::string& output, const std::string& name) {
  return std::strtod(line_of(output, name).c_str(), nullptr);
}

std::string notes_of(const std::string& output) {
  std::istringstream lines(output);
  std::string notes;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("note ")) notes += line.substr(24) + "\n";
  }
  return notes;
}

std::string gas(const std::string& count, const std::string& size, const std::string& boundary = "periodic") {
  return "[box]\nsize = [" + size + ", " + size + ", " + size + "]\nboundary = ['" + boundary +
         "', 'periodic', '" + boundary + "']\n[[spheres]]\ncount = " + count +
         "\nradius = 0.5\nplacement = 'random'\ntemperature = 1.0\n[run]\nuntil = 10.0\n";
}

TEST_F(WhatCheckExpects, WarnsOfMotions) {
  write_text(folder_ / "lid.csv", "0,0,0,0\n9,0,0,-19.5\n");
  const std::string scenario = R"([box]
size = [20, 20, 20]
boundary = ["periodic", "periodic", "open"]
[[walls]]
shape = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
[[walls]]
shape = "plane"
point = [0, 0, 20]
normal = [0, 0, -1]
motion = "lid"
[[motions]]
kind = "keyframes"
name = "lid"
file = "lid.csv"
[[motions]]
kind = "rotation"
name = "arm"
point = [10, 10, 5]
axis = [0, 0, 1]
frequency = 10
tolerance = 1e-12
[[spheres]]
kinematic = true
motion = "arm"
radius = 0.5
positions = [[11, 10, 5], [11.5, 10, 5]]
[[spheres]]
radius = 0.5
positions = [[2, 2, 5]]
speed = 1
[run]
until = 10
)";
  const std::string text = output(scenario);
  EXPECT_EQ(line_of(text, "motion lid"), "keyframes, 1 wall, chords of 9");
  EXPECT_EQ(line_of(text, "motion arm").find("rotation, 2 spheres, chords of "), 0U);
  const std::string notes = notes_of(text);
  EXPECT_NE(notes.find("kinematic spheres 0 and 1 overlap"), std::string::npos) << notes;
  EXPECT_NE(notes.find("the chords of the motion arm"), std::string::npos) << notes;
  EXPECT_NE(notes.find("walls come as near to each other as 0.5"), std::string::npos) << notes;
}

// As dense as a gas that it builds, a gas of 10^8 spheres has the same rates.
TEST_F(WhatCheckExpects, TellsWhatTooManySpheresToPlaceWouldTake) {
  const std::string few = output(gas("12500", "40"));
  const std::string many = output(gas("100_000_000", "800"));
  EXPECT_EQ(line_of(many, "spheres"), "100000000");
  EXPECT_EQ(line_of(many, "box"), "800 periodic x 800 periodic x 800 periodic");
  EXPECT_EQ(number_of(many, "packing fraction"), number_of(few, "packing fraction"));
  EXPECT_EQ(number_of(many, "mean free path"), number_of(few, "mean free path"));
  EXPECT_NEAR(number_of(many, "  collisions") / number_of(few, "  collisions"), 8000, 80);
  const double ratio = number_of(many, "memory") / number_of(few, "memory");
  EXPECT_GT(ratio, 8000 * 0.8);
  EXPECT_LT(ratio, 8000 * 1.25);
  EXPECT_GT(std::strtod(line_of(many, "  time on one core").substr(6).c_str(), nullptr), 100);
  EXPECT_NE(notes_of(many).find("too many spheres to place"), std::string::npos);
  EXPECT_EQ(notes_of(few), "");
}

TEST_F(WhatCheckExpects, SaysTheSameAsOneObject) {
  const std::string scenario = gas("1000", "40", "wall") + "[response]\nrestitution = 0.9\n";
  const std::string printed = output(scenario);
  const nlohmann::json json = json_of({"check", "scenario.toml", "--json", "--quiet"});
  const auto expect_near = [&](const nlohmann::json& number, const std::string& name) {
    EXPECT_NEAR(number.get<double>() / number_of(printed, name), 1, 1e-3) << name;
  };
  EXPECT_EQ(json["spheres"], 1000);
  EXPECT_EQ(json["box"],
            nlohmann::json::parse(R"({"boundary": ["wall", "periodic", "wall"], "size": [40, 40, 40]})"));
  EXPECT_EQ(json["radius"], nlohmann::json::parse(R"({"mean": 0.5, "least": 0.5, "most": 0.5})"));
  EXPECT_EQ(json["engine"], line_of(printed, "engine"));
  EXPECT_EQ(json["responses"][0]["what"], line_of(printed, "all contacts"));
  expect_near(json["packing_fraction"], "packing fraction");
  expect_near(json["mean_free_time"], "mean free time");
  expect_near(json["expected"]["collisions"], "  collisions");
  expect_near(json["expected"]["wall_contacts"], "  wall contacts");
  EXPECT_NEAR(json["memory_bytes"].get<double>() / 1e6 / number_of(printed, "memory"), 1, 0.1);
  EXPECT_GT(json["expected"]["seconds"], 0);
  EXPECT_EQ(json["until"], 10);
  // A run that ends so early warns of few contacts.
  EXPECT_EQ(json_of({"check", "scenario.toml", "--json", "--until", "1e-6"})["notes"].size(), 1U);
}

TEST_F(WhatCheckExpects, KnowsTheWallsAndGroupsOfSpheresThatItDoesNotPlace) {
  const std::string common = R"(
[box]
boundary = ["open", "wall", "open"]
size = [3000.0, 2000.0, 2500.0]
[[walls]]
shape = "plane"
point = [0.0, 0.0, 500.0]
normal = [0.0, 0.0, 1.0]
[[species]]
name = "large"
[[species]]
name = "small"
[[spheres]]
species = "large"
count = 10_000_000
radius = { distribution = "uniform", min = 1.0, max = 2.0 }
placement = "random"
speed = 2.0
[[spheres]]
species = "small"
count = 50_000_000
radius = 0.5
placement = "random"
speed = 4.0
[run]
until = 1.0
)";
  const std::string text = output(common);
  // 4 pi / 3 of the mean cubes, 15/4 and 1/8, in 3000 x 2000 x 2000.
  EXPECT_NEAR(number_of(text, "packing fraction"), 4.18879 * (1e7 * 3.75 + 5e7 * 0.125) / 1.2e10, 2e-4);
  EXPECT_NEAR(number_of(text, "mean speed"), (1e7 * 2 + 5e7 * 4) / 6e7, 1e-3);
  EXPECT_EQ(line_of(text, "species"), "large 10000000, small 50000000");
  EXPECT_NE(line_of(text, "plane_0").find("normal (0, 0, 1)"), std::string::npos);
}

TEST_F(WhatCheckExpects, NamesTheFeaturesAndWhatTheyExclude) {
  const std::string usual = output(gas("10", "8"));
  EXPECT_EQ(usual.find("features"), std::string::npos) << usual;
  EXPECT_EQ(usual.find("excluded"), std::string::npos) << usual;
  const std::string falling = output(gas("10", "8", "wall"), {"--set", "box.gravity=[0.0, 0.0, -1.0]"});
  EXPECT_EQ(line_of(falling, "features"), "gravity");
  EXPECT_EQ(line_of(falling, "excluded"),
            "growth, shear, potentials of steps, kinematic spheres without a motion, the engine paper");
  const std::string growing = output(gas("10", "8") + "[growth]\nrate = 0.01\n");
  EXPECT_EQ(line_of(growing, "features"), "growth");
  EXPECT_NE(line_of(growing, "excluded").find("measures"), std::string::npos);
  // Of a sample, too.
  const std::string many = output(gas("100_000_000", "800"), {"--set", "spheres.0.kinematic=true"});
  EXPECT_EQ(line_of(many, "features"), "kinematic spheres, kinematic spheres without a motion");
  EXPECT_EQ(line_of(many, "excluded"), "gravity, growth, measures");
}

TEST_F(WhatCheckExpects, RefusesTooManySpheresForTheBox) {
  write_text(folder_ / "scenario.toml", gas("100_000_000", "300"));
  expect_refusal(run_program(folder_, {"check", "scenario.toml"}), {"cannot exist"});
}

const std::string kCollapse = "by inelastic collapse, unless settle or contact_duration is set";

TEST_F(WhatCheckExpects, WarnsOfSpheresThatComeToRest) {
  const std::string heap = gas("10", "8", "wall") + "[response]\nrestitution = 0.9\n";
  EXPECT_EQ(notes_of(output(heap)), "");
  const Arguments falls{"--set", "box.gravity=[0.0, 0.0, -1.0]"};
  EXPECT_EQ(notes_of(output(heap, falls)), "") << "it settles";
  const Arguments never_settles{falls[0], falls[1], "--set", "response.settle=false"};
  EXPECT_NE(
      notes_of(output(heap, never_settles)).find("come to rest under gravity: the run ends " + kCollapse),
      std::string::npos);
  EXPECT_EQ(notes_of(output(heap, {falls[0], falls[1], "--set", "response.elastic_below=1e-3"})), "");
  EXPECT_EQ(notes_of(output(heap, {falls[0], falls[1], "--set", "response.contact_duration=1e-3"})), "");
  Arguments pressed = never_settles;
  pressed.insert(pressed.end(), {"--set", "response.elastic_below=1e-3"});
  EXPECT_NE(notes_of(output(heap, pressed)).find("elastic_below alone does not bound"), std::string::npos);
  EXPECT_EQ(notes_of(output(heap, {falls[0], falls[1], "--set", "response.restitution=1.0"})), "");
  EXPECT_EQ(notes_of(output(heap, {"--set", "box.gravity=[0.0, -1.0, 0.0]"})), "") << "there is no floor";
  const std::string shaken = heap +
                             "[[walls]]\nshape = 'plane'\npoint = [0.0, 0.0, 0.5]\nnormal = [0.0, 0.0, "
                             "1.0]\namplitude = 0.1\nfrequency = 1.0\n";
  EXPECT_NE(notes_of(output(shaken, falls)).find("the run may end " + kCollapse), std::string::npos);
  const std::string lossy_floor = gas("10", "8", "wall") + "[box.faces]\nz_min = { restitution = 0.8 }\n";
  EXPECT_EQ(notes_of(output(lossy_floor, falls)), "");
  EXPECT_NE(notes_of(output(lossy_floor, never_settles)).find("the run ends " + kCollapse),
            std::string::npos);
  EXPECT_EQ(notes_of(output(lossy_floor)), "");
  const std::string cavity =
      "[box]\nboundary = ['open', 'open', 'open']\n[[walls]]\nshape = 'sphere'\npoint = [0.0, 0.0, 0.0]\n"
      "radius = 9.0\n[[spheres]]\ncount = 10\nradius = 0.5\nplacement = 'random'\nspeed = 1.0\n[run]\nuntil "
      "= 10.0\n"
      "[response]\nrestitution = 0.9\n";
  EXPECT_NE(notes_of(output(cavity)).find("sliding along round walls: the run ends " + kCollapse),
            std::string::npos);
}

TEST_F(WhatCheckExpects, WarnsOfSpheresThatNeverMeet) {
  const auto expect = [&](const std::string& scenario, const Arguments& more, const std::string& note) {
    EXPECT_NE(notes_of(output(scenario, more)).find(note), std::string::npos) << note;
  };
  const std::string never = ": there will be no contact";
  const std::string periodic = gas("10", "8");
  const Arguments at_rest{"--set", "spheres.0.temperature=0.0"};
  expect(periodic, at_rest, "nothing moves" + never);
  expect(periodic, {at_rest[0], at_rest[1], "--set", "box.gravity=[0.0, 0.0, -1.0]"},
         "all spheres fall alike, and there is nothing for them to hit" + never);
  EXPECT_EQ(notes_of(output(gas("10", "8", "wall"),
                            {at_rest[0], at_rest[1], "--set", "box.gravity=[0.0, 0.0, -1.0]"})),
            "");
  expect("[[species]]\nname = 'ghost'\n" + periodic +
             "[[response.pairs]]\nbetween = ['ghost', 'ghost']\nkind = 'pass'\n",
         {"--set", "spheres.0.species='ghost'"}, "all spheres pass through each other");
  expect(gas("2", "1000"), {}, "contacts are expected until then");
  const std::string open =
      "[box]\nboundary = ['open', 'open', 'periodic']\nsize = [9.0, 9.0, 9.0]\n[[spheres]]\ncount = 50\n"
      "radius = 0.5\nplacement = 'random'\nspeed = 1.0\n[run]\nuntil = 100.0\n";
  expect(open, {}, "the space is open along x, y: after a time of 9 the spheres have flown apart");
  EXPECT_EQ(notes_of(output(open, {"--until", "5"})), "");
  expect(open, {"--set", "spheres.0.count=1", "--set", "box.boundary=['open', 'open', 'open']"},
         "there is one sphere, and no wall" + never);
}

}  // namespace
}  // namespace hardball::check_test
