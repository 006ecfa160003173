// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The table [box.faces] of a scenario.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/recording/recording.hpp"
#include "hardball/scenario/make_world.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/thermostats/thermostat.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"
#include "hardball/trajectory/trajectory.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/step_levels.hpp"
#include "hardball/world/totals.hpp"
#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::features_test {
namespace {

using namespace support;

constexpr Face kFloor = face_of(2, false);
constexpr Face kCeiling = face_of(2, true);

std::string text_with(const std::string& more) {
  return R"([box]
boundary = ["wall", "periodic", "wall"]
size = [10, 10, 10]
[run]
seed = 7
[[spheres]]
count = 3
radius = 0.5
placement = "random"
temperature = 1
)" + more;
}

Box box_of(const std::string& more) {
  return make_world(parse_scenario(text_with(more), "slab.toml")).box();
}

std::string refusal_of_faces(const std::string& more) {
  return refusal_of([&] { box_of(more); });
}

TEST(BoxFaces, AreReadFromATableOrOneByOne) {
  for (const char* text :
       {"[box.faces]\nz_min = { temperature = 2.0, velocity = [1, 0, 0] }\nz_max = { restitution = 0.5 }",
        "[box.faces.z_min]\ntemperature = 2.0\nvelocity = [1, 0, 0]\n[box.faces.z_max]\nrestitution = 0.5"}) {
    const Box box = box_of(text);
    EXPECT_EQ(box.face(kFloor), (FaceProperties{{.temperature = 2, .seed = 7}, {1, 0, 0}}))
        << "the seed is that of the run";
    EXPECT_EQ(box.face(kCeiling).material.restitution, 0.5);
    EXPECT_FALSE(box.has_own_properties(face_of(0, false)));
  }
  EXPECT_TRUE(box_of("").has_plain_faces());
}

TEST(BoxFaces, AreRefusedWithTheirPlace) {
  const auto expect = [](const std::string& text, const std::string& where, const std::string& what) {
    const std::string found = refusal_of_faces(text);
    EXPECT_EQ(found.find(where), 0U) << found;
    EXPECT_NE(found.find(what), std::string::npos) << found;
  };
  expect("[box.faces]\ny_min = { temperature = 2.0 }", "slab.toml:12:9", "along y a wall");
  expect("[box.faces]\nz_min = { velocity = [0, 0, 1] }", "slab.toml:12:9", "[[walls]]");
  expect("[box.faces]\nz_min = { temperature = 1, restitution = 1 }", "slab.toml:12:25",
         "remove one of the two");
  expect("[box.faces]\nz_min = { temprature = 1 }", "slab.toml:12:11", "did you mean 'temperature'?");
  expect("[box.faces]\nz_lower = { temperature = 1 }", "slab.toml:12:1", "z_m");
  expect("[box.faces]\nz_min = { restitution = 2 }", "slab.toml:12:25", "restitution is 2");
}

TEST(BoxFaces, AreNamedWhereAPlaneIsHiddenByThem) {
  const std::string found = refusal_of_faces(
      "[[walls]]\nshape = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\ntemperature = 2");
  EXPECT_EQ(found.find("slab.toml:11:1"), 0U) << found;
  EXPECT_NE(found.find("[box.faces]"), std::string::npos) << found;
}

TEST(BoxFaces, AreRecorded) {
  const RecordingHeader header{
      .spheres = 1,
      .box = box_of("[box.faces]\nx_max = { restitution = 0.25, velocity = [0, 1, 2] }\n"
                    "z_min = { temperature = 2 }")};
  const Box read = parse_recording_header(to_json(header), "test").box;
  EXPECT_EQ(read.face(face_of(0, true)), (FaceProperties{{.restitution = 0.25}, {0, 1, 2}}));
  EXPECT_EQ(read.face(kFloor).material.temperature, 2);
  EXPECT_FALSE(read.has_own_properties(kCeiling));
  const std::string damaged =
      R"({"spheres": 1, "box": {"size": [1, 1, 1], "boundary": ["wall", "wall", "open"],
    "faces": {"z_min": {"temperature": 2}}}})";
  EXPECT_THROW(parse_recording_header(damaged, "test"), Error);
}

// Scenarios of two dimensions.

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
  const ScratchFolder folder;
  const World world = world_of(std::string(kSquare) +
                               "[[spheres]]\nradius = 0.5\npositions = [[1, 2]]\nvelocities = [[3, 4]]\n");
  {
    Trajectory file(folder / "discs.xyz");
    file.append(world, Time(0));
  }
  const std::string text = read_text(folder / "discs.xyz");
  EXPECT_NE(
      text.find("Lattice=\"20 0 0 0 30 0 0 0 1\" Origin=\"0 0 -0.5\" pbc=\"T F F\" dimensions=2 Time=0 "),
      std::string::npos)
      << text;
  const Snapshot snapshot = read_snapshot(folder / "discs.xyz");
  EXPECT_EQ(snapshot.spheres.at(0).position, (Vec3{1, 2, 0}));
  EXPECT_EQ(snapshot.spheres.at(0).velocity, (Vec3{3, 4, 0}));
}

// Sheared boxes in scenarios.

std::string text_of(const std::string& of_box, const std::string& others = "") {
  return "[box]\nsize = [10.0, 10.0, 10.0]\n" + of_box +
         "\n[[spheres]]\ncount = 500\nradius = 0.3\ntemperature = 1e-6\nplacement = \"random\"\n" + others;
}

const std::string kSheared = "boundary = [\"periodic\", \"periodic\", \"wall\"]\nshear_rate = 0.5\n";

std::string refusal_of_shear(const std::string& of_box, const std::string& others = "") {
  return refusal_of([&] { make_world(parse_scenario(text_of(of_box, others), "shear.toml")); });
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
Scenario from_tilted_file(const ScratchFolder& folder, const std::string& of_box) {
  std::ofstream(folder / "tilted.xyz") << "2\nLattice=\"10 0 0 -2.5 10 0 0 0 10\" pbc=\"T T T\" "
                                          "Properties=pos:R:3:velo:R:3:radius:R:1\n"
                                          "1 1 1 0 0 0 0.3\n3.5 9.9 1 0 0 0 0.3\n";
  return parse_scenario("[box]\nsize = [10.0, 10.0, 10.0]\n" + of_box + "[start]\nfile = \"tilted.xyz\"\n",
                        (folder / "start.toml").string());
}

TEST(ShearedScenario, StartsFromTheTiltOfAFile) {
  const ScratchFolder folder;
  const World world = make_world(from_tilted_file(folder, kSheared));
  EXPECT_EQ(world.box().shear(), (Shear{.rate = 0.5, .offset = -2.5}));
  const World given = make_world(from_tilted_file(folder, kSheared + "shear_offset = 1\n"));
  EXPECT_EQ(given.box().shear(), (Shear{.rate = 0.5, .offset = 1}));
}

TEST(ShearedScenario, RefusesTheTiltOfAFileForABoxThatIsNotSheared) {
  const ScratchFolder folder;
  const Error error = error_of(
      [&] { make_world(from_tilted_file(folder, "boundary = [\"periodic\", \"periodic\", \"wall\"]\n")); });
  EXPECT_NE(error.problem().find("tilted by -2.5"), std::string::npos) << error.what();
  EXPECT_NE(error.where().find("tilted.xyz"), std::string::npos);
  EXPECT_NE(error.remedy().find("shear_offset = -2.5"), std::string::npos);
}

TEST(ShearedScenario, SaysWhereWhatDoesNotGoTogetherIs) {
  const std::string with_gravity = refusal_of_shear(kSheared + "gravity = [0, 0, -1]\n");
  EXPECT_NE(with_gravity.find("the box is sheared, and there is gravity"), std::string::npos) << with_gravity;
  EXPECT_NE(with_gravity.find("shear.toml:4"), std::string::npos) << with_gravity;
  const std::string with_steps =
      refusal_of_shear(kSheared, "[[potentials]]\nsteps = [{ ratio = 1.5, energy = -1 }]\n");
  EXPECT_NE(with_steps.find("shear.toml:4"), std::string::npos) << with_steps;
  const std::string with_walls =
      refusal_of_shear("boundary = [\"wall\", \"periodic\", \"periodic\"]\nshear_rate = 0.5\n");
  EXPECT_NE(with_walls.find("not periodic along x and y"), std::string::npos) << with_walls;
  EXPECT_NE(with_walls.find("shear.toml:4"), std::string::npos) << with_walls;
}

TEST(ShearedScenario, HasAThermostatWithSlabs) {
  const Scenario scenario = parse_scenario(
      text_of(kSheared, "[thermostat]\nkind = \"rescale\"\ntemperature = 1.0\nevery = 0.5\nslabs = 8\n"),
      "shear.toml");
  EXPECT_EQ(std::get<Rescale>(*scenario.thermostat).slabs(), 8);
}

// The tables [[potentials]] and [[bonds]].

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
std::string refusal_of_potentials(const std::string& tables) {
  return refusal_of([&] { make_world(read(tables)); });
}

void expect_refused(const std::string& tables, const std::string& part) {
  EXPECT_NE(refusal_of_potentials(tables).find(part), std::string::npos) << refusal_of_potentials(tables);
  EXPECT_NE(refusal_of_potentials(tables).find("gas.toml"), std::string::npos)
      << refusal_of_potentials(tables);
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
  const auto refused = [&] { return refusal_of([&] { make_world(scenario); }); };
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
}  // namespace hardball::features_test
