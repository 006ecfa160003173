// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/make_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/scenario/density.hpp"
#include "hardball/scenario/make_simulation.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/totals.hpp"
#include "hardball/world/walls.hpp"
#include "support/interacting.hpp"
#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::make_world_test {
namespace {

using namespace support;

SphereGroup make_group(std::size_t count, VelocityRule rule, double scale) {
  SphereGroup group;
  group.count = count;
  group.radius = 0.5;
  group.velocity_rule = rule;
  group.velocity_scale = scale;
  group.where = "gas.toml:5:1";
  return group;
}

Scenario make_scenario(Boundary boundary, double size, const std::vector<SphereGroup>& spheres = {}) {
  Scenario scenario;
  scenario.name = "gas.toml";
  for (Scenario::Axis& axis : scenario.box) axis = {boundary, size};
  scenario.spheres = spheres;
  return scenario;
}

// A world that starts from a file in a folder of its own.
class StartFile : public testing::Test {
 protected:
  // In a box of this edge.
  Scenario start_with(const std::string& name, const std::string& text, Boundary boundary, double size = 10) {
    write_text(folder_ / name, text);
    Scenario scenario = make_scenario(boundary, size);
    scenario.start_file = folder_ / name;
    return scenario;
  }

  ScratchFolder folder_;
};

// What make_world says of a scenario.
std::string notes_of(const Scenario& scenario) {
  std::string notes;
  make_world(scenario, {}, [&](const std::string& note) { notes += note; });
  return notes;
}

void expect_refused(const Scenario& scenario, const std::string& part) {
  const std::string refusal = refusal_of([&] { make_world(scenario); });
  EXPECT_NE(refusal.find(part), std::string::npos) << refusal;
}

double mean_speed(const World& world, Slot begin, Slot end) {
  double sum = 0;
  for (Slot slot = begin; slot < end; ++slot) sum += length(world.path(slot).velocity);
  return sum / (end - begin);
}

double temperature(const World& world, Slot begin, Slot end) {
  double sum = 0;
  for (Slot slot = begin; slot < end; ++slot) {
    sum += world.mass(slot) * dot(world.path(slot).velocity, world.path(slot).velocity);
  }
  return sum / (end - begin) / 3;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(MakeWorld, PlacesWithoutOverlapInsideTheBox) {
  for (const Boundary boundary : {Boundary::wall, Boundary::periodic, Boundary::open}) {
    Scenario scenario = make_scenario(boundary, 10, {make_group(200, VelocityRule::speed, 1)});
    const World world = make_world(scenario);
    ASSERT_EQ(world.size(), 200U);
    EXPECT_EQ(audit(world, Time(0)).max_overlap, 0);
    for (Slot slot = 0; slot < world.size(); ++slot) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        EXPECT_GE(world.path(slot).position[axis], 0);
        EXPECT_LE(world.path(slot).position[axis], 10);
      }
    }
  }
}

TEST(MakeWorld, IsAFunctionOfTheSeed) {
  Scenario scenario = make_scenario(Boundary::wall, 10, {make_group(50, VelocityRule::temperature, 1)});
  const World first = make_world(scenario);
  const World again = make_world(scenario);
  scenario.run.seed = 2;
  const World other = make_world(scenario);
  EXPECT_TRUE(std::equal(first.paths().begin(), first.paths().end(), again.paths().begin()));
  EXPECT_FALSE(std::equal(first.paths().begin(), first.paths().end(), other.paths().begin()));
}

TEST(MakeWorld, PositionsDoNotDependOnTheVelocityRule) {
  Scenario scenario = make_scenario(Boundary::wall, 10, {make_group(50, VelocityRule::temperature, 1)});
  const World warm = make_world(scenario);
  scenario.spheres = {make_group(50, VelocityRule::speed, 0)};
  const World cold = make_world(scenario);
  for (Slot slot = 0; slot < 50; ++slot) EXPECT_EQ(warm.path(slot).position, cold.path(slot).position);
}

TEST(MakeWorld, FillsATenthOfACubeAroundTheOriginInOpenSpace) {
  Scenario scenario = make_scenario(Boundary::open, 0);
  for (Scenario::Axis& axis : scenario.box) axis.size.reset();
  scenario.spheres = {make_group(1000, VelocityRule::speed, 1)};
  const World world = make_world(scenario);
  const double edge = std::cbrt(1000 * std::numbers::pi / 6 / 0.1);
  double farthest = 0;
  for (const Path& path : world.paths()) {
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      farthest = std::max(farthest, std::fabs(path.position[axis]));
  }
  EXPECT_LE(farthest, edge / 2 - 0.5);
  EXPECT_GT(farthest, edge / 2 - 0.7);
}

TEST(MakeWorld, PlacesAroundZeroAlongAnOpenAxisWithoutSize) {
  Scenario scenario = make_scenario(Boundary::wall, 20);
  scenario.box[2] = {Boundary::open, {}};
  scenario.spheres = {make_group(1000, VelocityRule::speed, 1)};
  const World world = make_world(scenario);
  const double stretch = 1000 * std::numbers::pi / 6 / 0.1 / 400;
  for (const Path& path : world.paths()) EXPECT_LE(std::fabs(path.position.z), stretch / 2 - 0.5);
}

TEST(MakeWorld, PutsEqualSpheresOnALattice) {
  Scenario scenario =
      make_scenario(Boundary::periodic, 10,
                    {make_group(500, VelocityRule::speed, 1), make_group(500, VelocityRule::speed, 2)});
  for (SphereGroup& group : scenario.spheres) group.placement = Placement::fcc;
  const World world = make_world(scenario);
  EXPECT_EQ(world.size(), 1000U);
  EXPECT_EQ(audit(world, Time(0)).max_overlap, 0);
}

TEST(MakeWorld, TakesListedSpheres) {
  Scenario scenario = make_scenario(Boundary::wall, 10);
  SphereGroup group = make_group(2, VelocityRule::listed, 0);
  group.placement = Placement::listed;
  group.positions = {{1, 2, 3}, {4, 5, 6}};
  group.velocities = {{0, 0, 1}, {2, 0, 0}};
  group.mass = 3;
  scenario.spheres = {group};
  const World world = make_world(scenario);
  EXPECT_EQ(world.path(0).position, (Vec3{1, 2, 3}));
  EXPECT_EQ(world.path(1).velocity, (Vec3{2, 0, 0}));
  EXPECT_EQ(world.mass(1), 3);
}

TEST(MakeWorld, GivesTheExactMeanSpeed) {
  for (const Boundary boundary : {Boundary::wall, Boundary::periodic}) {
    Scenario scenario = make_scenario(
        boundary, 20,
        {make_group(300, VelocityRule::mean_speed, 17.25), make_group(1, VelocityRule::mean_speed, 2)});
    const World world = make_world(scenario);
    EXPECT_NEAR(mean_speed(world, 0, 300), 17.25, 1e-13);
    EXPECT_NEAR(mean_speed(world, 300, 301), 2, 1e-14);
  }
}

TEST(MakeWorld, GivesTheExactTemperature) {
  for (const Boundary boundary : {Boundary::wall, Boundary::periodic}) {
    Scenario scenario = make_scenario(
        boundary, 20,
        {make_group(300, VelocityRule::temperature, 2.5), make_group(100, VelocityRule::temperature, 2.5)});
    scenario.spheres[1].mass = 1000;
    const World world = make_world(scenario);
    EXPECT_NEAR(temperature(world, 0, 300), 2.5, 1e-13);
    EXPECT_NEAR(temperature(world, 300, 400), 2.5, 1e-13);
  }
}

TEST(MakeWorld, DrawsRadiiAndGivesMassesByDensity) {
  Scenario scenario = make_scenario(
      Boundary::periodic, 20,
      {make_group(300, VelocityRule::temperature, 2.5), make_group(100, VelocityRule::temperature, 2.5)});
  RadiusDistribution radii;
  radii.kind = RadiusDistribution::Kind::uniform;
  radii.min = 0.1;
  radii.max = 0.6;
  scenario.spheres[0].distribution = radii;
  scenario.spheres[0].density = 3;
  const World world = make_world(scenario);
  double least = 1;
  double most = 0;
  for (Slot slot = 0; slot < 300; ++slot) {
    const double radius = world.base_radius(slot);
    least = std::min(least, radius);
    most = std::max(most, radius);
    EXPECT_NEAR(world.mass(slot), 4 * std::numbers::pi * radius * radius * radius, 1e-12);
  }
  EXPECT_GE(least, 0.1);
  EXPECT_LT(least, 0.15);
  EXPECT_GT(most, 0.55);
  EXPECT_LE(most, 0.6);
  EXPECT_EQ(world.base_radius(300), 0.5);
  EXPECT_EQ(world.mass(300), 1);
  EXPECT_EQ(audit(world, Time(0)).max_overlap, 0);
  EXPECT_NEAR(temperature(world, 0, 300), 2.5, 1e-13);
  EXPECT_NEAR(temperature(world, 300, 400), 2.5, 1e-13);
  EXPECT_LT(length(momentum(world, Time(0))), 1e-10);
  const World again = make_world(scenario);
  scenario.run.seed = 2;
  const World other = make_world(scenario);
  EXPECT_EQ(again.base_radius(0), world.base_radius(0));
  EXPECT_NE(other.base_radius(0), world.base_radius(0));
}

TEST(MakeWorld, RefusesALatticeOfDistributedRadii) {
  Scenario scenario = make_scenario(Boundary::wall, 10, {make_group(5, VelocityRule::speed, 0)});
  scenario.spheres[0].placement = Placement::fcc;
  RadiusDistribution radii;
  radii.min = 0.1;
  radii.max = 0.6;
  scenario.spheres[0].distribution = radii;
  expect_refused(scenario, "one radius");
}

TEST(MakeWorld, GivesMaxwellVelocities) {
  Scenario scenario = make_scenario(Boundary::wall, 60, {make_group(20000, VelocityRule::temperature, 1)});
  const World world = make_world(scenario);
  double fourth = 0;
  for (const Path& path : world.paths()) fourth += std::pow(path.velocity.x, 4);
  // <v^4> = 3 with a standard deviation of sqrt(96 / n); four of them.
  EXPECT_NEAR(fourth / 20000, 3, 4 * std::sqrt(96.0 / 20000));
}

TEST(MakeWorld, GivesTheExactSpeedToEach) {
  Scenario scenario = make_scenario(Boundary::periodic, 20, {make_group(100, VelocityRule::speed, 3)});
  const World world = make_world(scenario);
  for (const Path& path : world.paths()) EXPECT_NEAR(length(path.velocity), 3, 1e-15 * 3 * 4);
}

TEST(MakeWorld, LeavesNoMomentumInAPeriodicBox) {
  Scenario scenario = make_scenario(Boundary::periodic, 20, {make_group(2, VelocityRule::mean_speed, 5)});
  EXPECT_LT(length(momentum(make_world(scenario), Time(0))), 1e-14);
  scenario.spheres = {make_group(300, VelocityRule::temperature, 1),
                      make_group(10, VelocityRule::mean_speed, 2)};
  scenario.spheres[1].mass = 7;
  EXPECT_LT(length(momentum(make_world(scenario), Time(0))), 1e-10);
}

TEST(MakeWorld, KeepsMomentumWhereItIsNotConservedOrPrescribed) {
  Scenario scenario = make_scenario(Boundary::wall, 20, {make_group(100, VelocityRule::temperature, 1)});
  EXPECT_GT(length(momentum(make_world(scenario), Time(0))), 1e-3);
  scenario = make_scenario(Boundary::periodic, 20);
  scenario.spheres = {make_group(100, VelocityRule::speed, 1)};
  EXPECT_GT(length(momentum(make_world(scenario), Time(0))), 1e-3);
  scenario.spheres = {make_group(1, VelocityRule::temperature, 1)};
  EXPECT_GT(length(momentum(make_world(scenario), Time(0))), 1e-3);
}

TEST(MakeWorld, AllowsRest) {
  for (const VelocityRule rule : {VelocityRule::mean_speed, VelocityRule::temperature, VelocityRule::speed}) {
    Scenario scenario = make_scenario(Boundary::periodic, 20, {make_group(10, rule, 0)});
    EXPECT_EQ(kinetic_energy(make_world(scenario), Time(0)), 0);
  }
}

TEST_F(StartFile, ReadsTheStartFile) {
  Scenario scenario = start_with("start.xyz",
                                 "2\nProperties=id:I:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1\n"
                                 "5 1 2 3 0.5 0 0 0.25 2\n"
                                 "4 11 2 3 0 0 0 0.125 3\n",
                                 Boundary::periodic);
  const World world = make_world(scenario);
  ASSERT_EQ(world.size(), 2U);
  EXPECT_EQ(world.path(0).position, (Vec3{1, 2, 3}));
  EXPECT_EQ(world.mass(0), 3);
  EXPECT_EQ(world.base_radius(1), 0.25);
  EXPECT_EQ(world.path(1).velocity, (Vec3{0.5, 0, 0}));
}

TEST_F(StartFile, SaysThatTheStartFileHasAnotherBox) {
  const auto note_of = [&](const std::string& comment, Boundary boundary) {
    const std::string text = "1\n" + comment + " Properties=pos:R:3:velo:R:3:radius:R:1\n5 5 5 0 0 0 0.25\n";
    return notes_of(start_with("start.xyz", text, boundary));
  };
  const std::string ten = "Lattice=\"10 0 0 0 10 0 0 0 10\"";
  const std::string closed = ten + " pbc=\"F F F\"";
  EXPECT_EQ(note_of("", Boundary::periodic), "");
  EXPECT_EQ(note_of(ten, Boundary::periodic), "");
  EXPECT_EQ(note_of(ten + " Origin=\"-5 -5 -5\"", Boundary::periodic), "");
  EXPECT_EQ(note_of(closed, Boundary::wall), "");
  EXPECT_EQ(note_of(closed + " unbounded=T Origin=\"1 1 1\"", Boundary::wall), "");
  EXPECT_EQ(note_of(ten, Boundary::wall), "the box of " + (folder_ / "start.xyz").string() +
                                              ", 10 x 10 x 10, periodic along x, y, z, is not that of [box], "
                                              "which is used");
  EXPECT_NE(note_of(closed, Boundary::periodic), "");
  EXPECT_NE(note_of(closed + " Origin=\"1 0 0\"", Boundary::wall), "");
  EXPECT_NE(note_of("Lattice=\"10 0 0 0 10 0 0 0 10.5\"", Boundary::periodic), "");
}

TEST_F(StartFile, GivesTheSpheresOfAFileWithoutVelocitiesThoseOfTheScenario) {
  write_text(folder_ / "start.sph", "3\n10 10 10\na 1 2 3 0.5\nb 4 -5 16 0.25\nc 7 8 9 0.5\n");
  Scenario scenario = make_scenario(Boundary::periodic, 10);
  scenario.start_file = folder_ / "start.sph";
  expect_refused(scenario, "no velocities");
  scenario.start_velocity_rule = VelocityRule::temperature;
  scenario.start_velocity_scale = 2;
  const World world = make_world(scenario);
  ASSERT_EQ(world.size(), 3U);
  EXPECT_EQ(world.path(1).position, (Vec3{4, 5, 6}));
  EXPECT_EQ(world.base_radius(1), 0.25);
  EXPECT_EQ(world.species(2), 2);
  EXPECT_NEAR(kinetic_energy(world, Time(0)), 3 * 3 * 2 / 2.0, 1e-12);
  EXPECT_NEAR(length(momentum(world, Time(0))), 0, 1e-12);
  scenario.start_velocity_scale = 0;
  EXPECT_EQ(make_world(scenario).path(0).velocity, Vec3{});
}

TEST_F(StartFile, RefusesTwoSourcesOfVelocities) {
  Scenario scenario =
      start_with("start.csv", "x,y,z,vx,vy,vz,diameter\n1,2,3,4,5,6,0.5\n", Boundary::periodic);
  EXPECT_EQ(make_world(scenario).base_radius(0), 0.25);
  scenario.start_velocity_rule = VelocityRule::mean_speed;
  expect_refused(scenario, "has velocities");
}

// A file of GSD without velocities says that they are zero, as one of LAMMPS that has them does.
TEST_F(StartFile, GivesSpheresThatAreAllAtRestTheVelocitiesOfTheScenario) {
  Scenario scenario = start_with("start.csv", "x,y,z,vx,vy,vz,radius\n1,2,3,0,0,0,0.5\n5,5,5,0,0,0,0.5\n",
                                 Boundary::periodic);
  EXPECT_EQ(kinetic_energy(make_world(scenario), Time(0)), 0);
  scenario.start_velocity_rule = VelocityRule::temperature;
  scenario.start_velocity_scale = 2;
  // Three per sphere and twice half of kT, up to the rounding of some sums.
  EXPECT_NEAR(kinetic_energy(make_world(scenario), Time(0)), 6, 1e-13);
}

TEST_F(StartFile, DrawsVelocitiesForTheMassesOfAFile) {
  std::string text = "x,y,z,radius,mass\n";
  for (int i = 0; i < 400; ++i) {
    const std::string place = to_text(i % 20 + 0.5) + "," + to_text(i / 20 + 0.5) + ",5,0.1,";
    text += place + (i == 0 ? "inf" : i % 2 == 0 ? "1" : "16") + "\n";
  }
  Scenario scenario = start_with("start.csv", text, Boundary::periodic, 20);
  scenario.start_velocity_rule = VelocityRule::temperature;
  scenario.start_velocity_scale = 2;
  const World world = make_world(scenario);
  EXPECT_EQ(world.path(0).velocity, Vec3{});
  double light = 0;
  double heavy = 0;
  for (Slot slot = 1; slot < world.size(); ++slot) {
    const Vec3& velocity = world.path(slot).velocity;
    (world.mass(slot) == 1 ? light : heavy) += world.mass(slot) * dot(velocity, velocity);
  }
  EXPECT_NEAR(light + heavy, 3 * 399 * 2, 1e-9);
  // Each is a sum of 600 squares of normal numbers: a standard deviation of 6%, of the quotient 8%.
  EXPECT_NEAR(light / heavy, 1, 0.4);
}

// Touching spheres, in files of six digits.
TEST_F(StartFile, ShrinksSpheresThatOverlapIfAsked) {
  Scenario scenario = start_with("start.csv",
                                 "x,y,z,vx,vy,vz,radius\n1,5,5,1,0,0,0.333334\n1.666667,5,5,0,0,0,0.333334\n"
                                 "1,8,5,0,0,0,0.25\n",
                                 Boundary::periodic);
  EXPECT_GT(audit(make_world(scenario), Time(0)).max_overlap, 1e-6);
  scenario.shrinks_start = true;
  std::string notes;
  const World world = make_world(scenario, {}, [&](const std::string& note) { notes += note; });
  EXPECT_EQ(audit(world, Time(0)).max_overlap, 0);
  // To the distance of the two, and no farther than rounding.
  EXPECT_NEAR(world.base_radius(0), 0.666667 / 2, 1e-15);
  EXPECT_NEAR(world.base_radius(2) / 0.25, 0.666667 / 0.666668, 1e-15);
  EXPECT_TRUE(contains(notes, "were multiplied by 0.9999985")) << notes;
}

TEST_F(StartFile, ShrinksSpheresThatReachThroughWallsIfAsked) {
  Scenario scenario = start_with(
      "start.csv", "x,y,z,vx,vy,vz,radius\n0.499999,5,5,1,0,0,0.5\n5,5,5,0,0,0,0.25\n", Boundary::wall);
  expect_refused(scenario, "reaches through a wall");
  expect_refused(scenario, "shrink = true in [start]");
  scenario.shrinks_start = true;
  const World world = make_world(scenario);
  EXPECT_EQ(audit(world, Time(0)).max_escape, 0);
  EXPECT_NEAR(world.base_radius(0), 0.499999, 1e-15);
  EXPECT_NEAR(world.base_radius(1), 0.499999 / 2, 1e-15);
}

TEST_F(StartFile, ShrinksNothingThatDoesNotOverlap) {
  Scenario scenario = start_with("start.csv", "x,y,z,vx,vy,vz,radius\n1,5,5,1,0,0,0.5\n2,5,5,0,0,0,0.5\n",
                                 Boundary::periodic);
  scenario.shrinks_start = true;
  EXPECT_EQ(make_world(scenario).base_radius(0), 0.5);
  EXPECT_EQ(notes_of(scenario), "");
}

TEST_F(StartFile, CannotShrinkSpheresWhoseCentersCoincide) {
  Scenario scenario = start_with("start.csv", "x,y,z,radius\n1,5,5,0.5\n1,5,5,0.5\n", Boundary::periodic);
  scenario.start_velocity_rule = VelocityRule::temperature;
  scenario.shrinks_start = true;
  expect_refused(scenario, "no radius is so small");
}

TEST_F(StartFile, DoesNotMissBoundariesThatAFileDoesNotTell) {
  for (const Boundary boundary : {Boundary::periodic, Boundary::wall}) {
    Scenario scenario = start_with(
        "start.data",
        "title\n1 atoms\n1 atom types\n0 10 xlo xhi\n0 10 ylo yhi\n0 10 zlo zhi\n\nAtoms # sphere\n\n"
        "1 1 1 1 5 5 5\n",
        boundary);
    scenario.start_velocity_rule = VelocityRule::temperature;
    EXPECT_EQ(notes_of(scenario), "");
  }
}

TEST_F(StartFile, NamesTheLineOfABadSphereInTheStartFile) {
  write_text(folder_ / "start.xyz",
             "2\nProperties=pos:R:3:velo:R:3:radius:R:1\n"
             "1 2 3 0 0 0 0.25\n"
             "9.9 2 3 0 0 0 0.25\n");
  Scenario scenario = make_scenario(Boundary::wall, 10);
  scenario.start_file = folder_ / "start.xyz";
  expect_refused(scenario, "start.xyz:4: sphere 1: ");
}

TEST_F(StartFile, RefusesAnEmptyStartFile) {
  Scenario scenario = start_with("start.xyz", "0\nProperties=pos:R:3:velo:R:3:radius:R:1\n", Boundary::wall);
  expect_refused(scenario, "no spheres");
}

TEST(MakeWorld, NamesTheGroupOfABadSphere) {
  Scenario scenario = make_scenario(Boundary::wall, 10);
  SphereGroup group = make_group(1, VelocityRule::speed, 0);
  group.placement = Placement::listed;
  group.positions = {{0.25, 5, 5}};
  scenario.spheres = {group};
  expect_refused(scenario, "gas.toml:5:1: sphere 0: ");
}

TEST(MakeWorld, RefusesWhatDoesNotFit) {
  Scenario scenario = make_scenario(Boundary::wall, 10, {make_group(1, VelocityRule::speed, 0)});
  scenario.spheres[0].radius = 6;
  expect_refused(scenario, "diameter 12 exceeds");
  scenario.spheres = {make_group(4000000000, VelocityRule::speed, 0)};
  expect_refused(scenario, "cannot exist");
  scenario.spheres = {make_group(1200, VelocityRule::speed, 0)};  // 0.63
  expect_refused(scenario, "fcc");
}

TEST(MakeWorld, RefusesALatticeOfUnequalSpheres) {
  Scenario scenario = make_scenario(
      Boundary::wall, 10, {make_group(5, VelocityRule::speed, 0), make_group(5, VelocityRule::speed, 0)});
  for (SphereGroup& group : scenario.spheres) group.placement = Placement::fcc;
  scenario.spheres[1].radius = 0.25;
  expect_refused(scenario, "one radius");
  expect_refused(scenario, "placement = \"random\"");
}

TEST(MakeWorld, RefusesToMixPlacements) {
  Scenario scenario = make_scenario(
      Boundary::wall, 10, {make_group(5, VelocityRule::speed, 0), make_group(5, VelocityRule::speed, 0)});
  scenario.spheres[1].placement = Placement::fcc;
  expect_refused(scenario, "different ways");
}

TEST(MakeWorld, PlacesSpheresAroundThoseThatAreListed) {
  for (const double radius : {0.27, 0.32}) {  // so dense that the random ones are placed at once, and grow
    Scenario scenario =
        make_scenario(Boundary::periodic, 8,
                      {make_group(1800, VelocityRule::speed, 1), make_group(2, VelocityRule::listed, 0)});
    scenario.spheres[0].radius = radius;
    scenario.spheres[1].placement = Placement::listed;
    scenario.spheres[1].positions = {{4, 4, 4}, {-1, 9, 4}};
    scenario.spheres[1].velocities = {{0, 0, 1}, {2, 0, 0}};
    scenario.spheres[1].radius = 1.5;
    std::string notes;
    const World world = make_world(scenario, {}, [&](const std::string& note) { notes += note; });
    EXPECT_EQ(world.size(), 1802U);
    EXPECT_EQ(world.path(1800).position, (Vec3{4, 4, 4}));
    EXPECT_EQ(audit(world, Time(0)).max_overlap, 0);
    EXPECT_EQ(contains(notes, "placed by growing spheres"), radius > 0.3) << notes;
    std::swap(scenario.spheres[0], scenario.spheres[1]);
    EXPECT_EQ(make_world(scenario).path(0).position, (Vec3{4, 4, 4}));
  }
}

// Those who share a world have together what make_world makes, to the last bit.
TEST(MakePart, HasTheSpheresThatAreWanted) {
  std::vector<Scenario> scenarios;
  for (const VelocityRule rule : {VelocityRule::mean_speed, VelocityRule::temperature, VelocityRule::speed}) {
    for (const Boundary boundary : {Boundary::periodic, Boundary::wall}) {
      Scenario scenario = make_scenario(boundary, 12, {make_group(500, rule, 1.5)});
      scenario.spheres[0].placement = Placement::fcc;
      scenario.spheres[0].mass = 2;
      scenarios.push_back(scenario);
      scenario.spheres[0].rotational_temperature = 0.5;
      scenarios.push_back(scenario);
      // Two groups are made whole.
      scenario.spheres.push_back(make_group(100, rule, 1));
      scenario.spheres[1].placement = Placement::fcc;
      scenarios.push_back(scenario);
    }
  }
  for (const Scenario& scenario : scenarios) {
    const World whole = make_world(scenario);
    std::size_t taken = 0;
    for (SphereId part = 0; part < 3; ++part) {
      const World empty = make_part(
          scenario, [&](SphereId id) { return id % 3 == part; },
          [&](const SphereState& state) {
            EXPECT_EQ(state, whole.state_of(whole.slot_of(state.id)));
            EXPECT_EQ(state.id % 3, part);
            ++taken;
          });
      EXPECT_EQ(empty.size(), 0U);
    }
    EXPECT_EQ(taken, whole.size());
  }
}

TEST(MakeWorld, ReportsItsProgress) {
  for (const std::string placement : {"random", "fcc"}) {
    const Scenario scenario = parse_scenario(
        "[box]\nsize = [100, 100, 100]\nboundary = [\"wall\", \"wall\", \"wall\"]\n"
        "[[spheres]]\ncount = 2000\nradius = 1\nplacement = \"" +
            placement + "\"\nspeed = 1\n",
        "here.toml");
    std::vector<double> reports;
    const World reported = make_world(scenario, [&](double done) { reports.push_back(done); });
    ASSERT_GE(reports.size(), 100U);
    EXPECT_LE(reports.size(), 400U);
    EXPECT_EQ(reports.front(), 0);
    EXPECT_EQ(reports.back(), 1);
    EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
    const World silent = make_world(scenario);
    for (Slot slot = 0; slot < reported.size(); ++slot) {
      ASSERT_EQ(reported.path(slot).position, silent.path(slot).position);
    }
    const auto interrupt = [](double done) {
      if (done > 0.5) throw RunFailure("enough");
    };
    EXPECT_THROW(make_world(scenario, interrupt), RunFailure);
  }
}

Scenario scenario_with(const std::string& response) {
  return parse_scenario(R"(
[box]
size = [6, 6, 6]
boundary = ["periodic", "periodic", "periodic"]
[[species]]
name = "drop"
[[spheres]]
count = 30
radius = 0.5
placement = "random"
species = "drop"
temperature = 1
)" + response,
                        "gas.toml");
}

std::uint64_t hash_with(const Scenario& scenario, const EngineOptions& options) {
  Simulation simulation = make_simulation(scenario, make_world(scenario), options);
  simulation.run_until(2);
  return simulation.event_log_hash();
}

TEST(MakeSimulation, HasTheResponseOfTheScenario) {
  for (const char* response : {"[response]\nrestitution = 0.5\nelastic_below = 0.1",
                               "[response]\ntangential_restitution = 0.5", "[response]\nkind = \"merge\"",
                               "[[response.pairs]]\nbetween = [\"drop\", \"drop\"]\nkind = \"bounce\"\n"
                               "restitution = 0.7"}) {
    const Scenario scenario = scenario_with(response);
    Simulation expected{make_world(scenario)};
    expected.run_until(2);
    Simulation elastic(interacting(make_world(scenario), {}));
    elastic.run_until(2);
    EXPECT_NE(expected.event_log_hash(), elastic.event_log_hash()) << response;
    EXPECT_EQ(hash_with(scenario, {}), expected.event_log_hash()) << response;
    EXPECT_EQ(hash_with(scenario, {.engine = EngineKind::all_pairs}), expected.event_log_hash()) << response;
  }
}

const std::string kPeriodic = "[box]\nboundary = [\"periodic\", \"periodic\", \"periodic\"]\n";
const std::string kDiscs = "[box]\ndimensions = 2\nboundary = [\"periodic\", \"wall\"]\n";
const std::string kSpheres = "[[spheres]]\nplacement = \"random\"\nspeed = 1\n";

std::string error_of(const std::string& text) {
  return refusal_of([&] { parse_scenario(text, "gas.toml"); });
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
        scenario.run.seed = seed;
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
}  // namespace hardball::make_world_test
