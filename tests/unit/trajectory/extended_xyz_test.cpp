// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/trajectory/text_formats.hpp"
#include "support/refusal.hpp"

namespace hardball::extended_xyz_test {
namespace {

std::string frame_of(const World& world, double time) {
  std::string text;
  append_text_frame(extended_xyz_frame(), snapshot_of(world, Time(time)), 0,
                    [&](std::string_view more) { text += more; });
  return text;
}

Snapshot parse(const std::string& text) {
  TextSnapshotReader reader([&] { return std::make_unique<std::istringstream>(text); }, "start.xyz",
                            extended_xyz_format());
  return reader.read(reader.frames() - 1);
}

std::string second_line(const std::string& text) {
  const std::size_t begin = text.find('\n') + 1;
  return text.substr(begin, text.find('\n', begin) - begin);
}

TEST(AppendSnapshot, WritesTheLineThatOvitoAndAseRead) {
  World world(Box({Boundary::periodic, Boundary::wall, Boundary::periodic}, {10, 20, 30}));
  world.add({.position = {1, 2, 3}, .velocity = {0.25, 0, -2}, .radius = 0.5, .mass = 3});
  EXPECT_EQ(
      frame_of(world, 0),
      "1\n"
      "Lattice=\"10 0 0 0 20 0 0 0 30\" pbc=\"T F T\" Time=0 "
      "Properties=type:I:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1:id:I:1:map_shift:I:3:momenta:R:3:masses:R:1\n"
      "1 1 2 3 0.25 0 -2 0.5 3 0 0 0 0 0.75 0 -6 3\n");
}

TEST(AppendSnapshot, ShowsSpheresWhereTheyAreAtTheTime) {
  World world(Box::walls({10, 10, 10}));
  world.add({.position = {1, 2, 3}, .velocity = {2, 0, 0}, .radius = 0.5});
  const Snapshot snapshot = parse(frame_of(world, 1.5));
  EXPECT_EQ(snapshot.time, 1.5);
  EXPECT_EQ(snapshot.spheres.at(0).position, (Vec3{4, 2, 3}));
}

TEST(AppendSnapshot, FoldsIntoAPeriodicBoxAndCountsTheBoxes) {
  World world(Box::periodic({10, 10, 10}));
  world.add({.position = {1, 2, 3}, .velocity = {2, -1, 0}, .radius = 0.5});
  const std::string frame = frame_of(world, 15);
  EXPECT_NE(frame.find("\n1 1 7 3 2 -1 0 0.5 1 0 3 -2 0 2 -1 0 1\n"), std::string::npos) << frame;
}

TEST(AppendSnapshot, SpansTheSpheresAlongOpenAxes) {
  World world(Box({Boundary::open, Boundary::wall, Boundary::periodic}, {0, 20, 30}));
  world.add({.position = {-4, 2, 3}, .radius = 1});
  world.add({.position = {6, 2, 3}, .radius = 0.5});
  EXPECT_EQ(second_line(frame_of(world, 0)),
            "Lattice=\"11.5 0 0 0 20 0 0 0 30\" Origin=\"-5 0 0\" pbc=\"F F T\" unbounded=T Time=0 "
            "Properties=type:I:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1:id:I:1:map_shift:I:3:species_id:I:1:"
            "momenta:R:3:"
            "masses:R:1");
}

TEST(AppendSnapshot, WritesAWorldWithoutSpheres) {
  EXPECT_EQ(frame_of(World(), 0).substr(0, 2), "0\n");
  EXPECT_TRUE(parse(frame_of(World(), 0)).spheres.empty());
}

TEST(AppendSnapshot, CutsAnIncompleteFrameOff) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  TextTrajectory file("/dev/full", extended_xyz_frame(), false);
  EXPECT_THROW(file.append(snapshot_of(World(), Time(0)), 0), RunFailure);
}

TEST(ReadSnapshot, LosesNoBit) {
  World world;
  const double tiny = std::numeric_limits<double>::denorm_min();
  world.add({.position = {0.1, -1.0 / 3, 0}, .velocity = {1e-60, 0.1 + 0.2, -7e59}, .radius = 1.0 / 7});
  world.add({.position = {tiny, 1e22, 123456789.123456789},
             .velocity = {0, -1e-5, 5},
             .radius = 3e-60,
             .mass = 1e60});
  const Snapshot snapshot = parse(frame_of(world, 0.3));
  ASSERT_EQ(snapshot.spheres.size(), 2U);
  for (Slot slot = 0; slot < 2; ++slot) {
    EXPECT_EQ(snapshot.spheres[slot].position, world.position(slot, Time(0.3)));
    EXPECT_EQ(snapshot.spheres[slot].velocity, world.path(slot).velocity);
    EXPECT_EQ(snapshot.spheres[slot].radius, world.base_radius(slot));
    EXPECT_EQ(snapshot.spheres[slot].mass, world.mass(slot));
  }
  EXPECT_EQ(snapshot.time, 0.3);
}

TEST(ReadSnapshot, TakesVelocitiesFromMomentaIfThereAreNoOthers) {
  const std::string frame = "1\nProperties=pos:R:3:radius:R:1:";
  const auto sphere = [&](const std::string& more) { return parse(frame + more).spheres.at(0); };
  const Sphere of_ase = sphere("momenta:R:3:masses:R:1\n1 2 3 0.5 2 -4 6 4\n");
  EXPECT_EQ(of_ase.velocity, (Vec3{0.5, -1, 1.5}));
  EXPECT_EQ(of_ase.mass, 4);
  EXPECT_EQ(sphere("momenta:R:3:mass:R:1\n1 2 3 0.5 2 -4 6 4\n").velocity, (Vec3{0.5, -1, 1.5}));
  // Whoever edits velo and mass need not know the others.
  const Sphere of_both = sphere("momenta:R:3:masses:R:1:velo:R:3:mass:R:1\n1 2 3 0.5 2 -4 6 4 7 8 9 2\n");
  EXPECT_EQ(of_both.velocity, (Vec3{7, 8, 9}));
  EXPECT_EQ(of_both.mass, 2);
  const Sphere kinematic = sphere("momenta:R:3:masses:R:1:mass:R:1\n1 2 3 0.5 2e60 0 0 1e60 inf\n");
  EXPECT_EQ(kinematic.velocity, (Vec3{2, 0, 0}));
  EXPECT_EQ(kinematic.mass, std::numeric_limits<double>::infinity());
}

TEST(AppendSnapshot, HasMomentaOfKinematicSpheres) {
  World world;
  world.add({.position = {1, 2, 3}, .velocity = {2, -3, 0}, .mass = std::numeric_limits<double>::infinity()});
  const std::string frame = frame_of(world, 0);
  EXPECT_TRUE(frame.ends_with(" inf 0 0 0 0 2e+60 -3e+60 0 1e+60\n")) << frame;
  EXPECT_EQ(parse(frame).spheres.at(0).velocity, (Vec3{2, -3, 0}));
}

TEST(ReadSnapshot, FindsColumnsByName) {
  const Snapshot snapshot = parse(
      "1\n"
      "Properties=radius:R:1:color:R:3:velo:R:3:name:S:1:pos:R:3\n"
      "0.5 9 9 9 4 5 6 word 1 2 3\n");
  ASSERT_EQ(snapshot.spheres.size(), 1U);
  EXPECT_EQ(snapshot.spheres[0].position, (Vec3{1, 2, 3}));
  EXPECT_EQ(snapshot.spheres[0].velocity, (Vec3{4, 5, 6}));
  EXPECT_EQ(snapshot.spheres[0].radius, 0.5);
  EXPECT_EQ(snapshot.spheres[0].mass, 1);
  EXPECT_FALSE(snapshot.time);
}

TEST(ReadSnapshot, SortsByIdAndKeepsTheLines) {
  const Snapshot snapshot = parse(
      "3\n"
      "Properties=id:I:1:pos:R:3:velo:R:3:radius:R:1\n"
      "8 8 0 0 0 0 0 1\n"
      "-1 1 0 0 0 0 0 1\n"
      "5 5 0 0 0 0 0 1\n");
  ASSERT_EQ(snapshot.spheres.size(), 3U);
  EXPECT_EQ(snapshot.spheres[0].position.x, 1);
  EXPECT_EQ(snapshot.spheres[1].position.x, 5);
  EXPECT_EQ(snapshot.spheres[2].position.x, 8);
  EXPECT_EQ(snapshot.lines, (std::vector<std::size_t>{4, 5, 3}));
}

TEST(ReadSnapshot, ReadsTheLastFrame) {
  const std::string properties = " Properties=pos:R:3:velo:R:3:radius:R:1\n";
  const Snapshot snapshot = parse("1\nTime=0" + properties + "1 0 0 0 0 0 1\n2\nTime=5" + properties +
                                  "2 0 0 0 0 0 1\n3 0 0 0 0 0 1\n\n");
  ASSERT_EQ(snapshot.spheres.size(), 2U);
  EXPECT_EQ(snapshot.time, 5);
  EXPECT_EQ(snapshot.spheres[0].position.x, 2);
  EXPECT_EQ(snapshot.lines, (std::vector<std::size_t>{6, 7}));
}

TEST(ReadSnapshot, UnderstandsWhatOtherProgramsWrite) {
  const Snapshot snapshot = parse(
      "1\r\n"
      "Lattice=\"1 0 0  0 1 0  0 0 1\"\tflag comment='two words' pbc=\"T T T\" Time=2.5e0 "
      "Properties=pos:R:3:velo:R:3:radius:R:1 more=1\r\n"
      "  +1.5\t2e0 3   0 0 -0   1\r\n");
  ASSERT_EQ(snapshot.spheres.size(), 1U);
  EXPECT_EQ(snapshot.time, 2.5);
  EXPECT_EQ(snapshot.spheres[0].position, (Vec3{1.5, 2, 3}));
}

const std::string kColumns = " Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1\n";
const std::string kSphere = "Si 1 2 3 4 5 6 0.5\n";
const std::string kLattice = "Lattice=\"4 0 0 0 5 0 0 0 6\" ";

using Periodic = std::array<bool, kAxes>;

std::optional<SnapshotBox> box_with(const std::string& comment) {
  return parse("1\n" + comment + kColumns + kSphere).box;
}

TEST(ReadSnapshot, TakesALatticeWithoutPbcForPeriodic) {
  const auto box = box_with(kLattice);
  ASSERT_TRUE(box);
  EXPECT_EQ(box->size, (Vec3{4, 5, 6}));
  EXPECT_EQ(box->low, Vec3{});
  EXPECT_EQ(box->is_periodic, (Periodic{true, true, true}));
  EXPECT_FALSE(box_with("energy=1"));
  EXPECT_FALSE(box_with("pbc=\"F F F\""));
  EXPECT_EQ(box_with("Lattice=\"4 0 0 0 5 0 0 0 1\" dimensions=2")->is_periodic,
            (Periodic{true, true, false}));
}

TEST(ReadSnapshot, UnderstandsPbcAsProgramsWriteIt) {
  for (const std::string pbc :
       {"\"T T F\"", "\"True true FALSE\"", "'1 1 0'", "[T,T,F]", "[ True, true, False ]", "{T T F}"}) {
    EXPECT_EQ(box_with(kLattice + "pbc=" + pbc)->is_periodic, (Periodic{true, true, false})) << pbc;
  }
}

TEST(ReadSnapshot, ReadsLatticesInBracketsAndBraces) {
  for (const std::string lattice : {"[[4,0,0],[0,5,0],[0,0,6]]", "[4, 0, 0, 0, 5, 0, 0, 0, 6]",
                                    "{4 0 0 0 5 0 0 0 6}", "'4 0 0 0 5 0 0 0 6d0'"}) {
    EXPECT_EQ(box_with("virial={1 2 3} Lattice=" + lattice)->size, (Vec3{4, 5, 6})) << lattice;
  }
}

TEST(ReadSnapshot, ReadsTheOrigin) {
  EXPECT_EQ(box_with(kLattice + "Origin=\"-2 -2.5 1e1\"")->low, (Vec3{-2, -2.5, 10}));
  EXPECT_EQ(box_with(kLattice + "cell_origin=[-2, -2.5, 10]")->low, (Vec3{-2, -2.5, 10}));
}

TEST(ReadSnapshot, ReadsATiltedLatticeWhoseCornerIsTheOrigin) {
  const auto box = box_with("Lattice=\"10 0 0 3 10 0 0 0 10\"");
  EXPECT_EQ(box->tilt, 3);
  EXPECT_EQ(box->corner(), Vec3{});
}

TEST(ReadSnapshot, ReadsKeysAndValuesInQuotes) {
  const Snapshot snapshot =
      parse("1 \ncomment=\"a Lattice=b \\\"pbc=c\\\" d\" \"a key\"=1 energy = -1.5e3 flag Time = 2.5" +
            kColumns + kSphere);
  EXPECT_EQ(snapshot.time, 2.5);
  EXPECT_FALSE(snapshot.box);
}

TEST(ReadSnapshot, KnowsColumnsByTheNamesOfOtherPrograms) {
  for (const std::string velocity : {"velo", "vel", "velocity", "velocities", "Velo"}) {
    const Snapshot snapshot =
        parse("1\nProperties=Pos:R:3:" + velocity + ":R:3:Radius:R:1:Mass:R:1\n1 2 3 4 5 6 0.5 7\n");
    EXPECT_EQ(snapshot.spheres.at(0).velocity, (Vec3{4, 5, 6})) << velocity;
    EXPECT_EQ(snapshot.spheres.at(0).radius, 0.5);
    EXPECT_EQ(snapshot.spheres.at(0).mass, 7);
  }
}

TEST(ReadSnapshot, ReadsExponentsOfFortran) {
  const Snapshot snapshot = parse("1\n" + kColumns + "Si 1.d0 2D+1 .5d-1 -1d0 5 6 0.5d0\n");
  EXPECT_EQ(snapshot.spheres.at(0).position, (Vec3{1, 20, 0.05}));
  EXPECT_EQ(snapshot.spheres.at(0).velocity, (Vec3{-1, 5, 6}));
}

TEST(ReadSnapshot, NumbersSpeciesInTheOrderOfTheirNames) {
  const std::string end = " 1 2 3 4 5 6 0.5\n";
  const Snapshot snapshot = parse("4\n" + kColumns + "Si" + end + "O" + end + "Si" + end + "H" + end);
  const std::array<SpeciesId, 4> species{0, 1, 0, 2};
  for (std::size_t i = 0; i < species.size(); ++i) EXPECT_EQ(snapshot.spheres.at(i).species, species[i]);
  const Snapshot typed = parse("1\nProperties=species:S:1:type:I:1:pos:R:3:velo:R:3:radius:R:1\nSi 4" + end);
  EXPECT_EQ(typed.spheres.at(0).species, 3);
}

struct BadFile {
  std::string name;
  std::string text;
  std::string where;
  std::string problem;
};

class RefusedSnapshot : public testing::TestWithParam<BadFile> {};

TEST_P(RefusedSnapshot, NamesPlaceAndProblem) {
  const Error error = support::error_of([&] { parse(GetParam().text); });
  EXPECT_EQ(error.where(), GetParam().where) << error.what();
  EXPECT_NE(error.problem().find(GetParam().problem), std::string::npos) << error.what();
  EXPECT_FALSE(error.remedy().empty());
}

TEST(ExtendedXyz, KeepsSpeciesSpinsMomentsAndInfiniteMasses) {
  World world(Box::open());
  world.add({.position = {0, 0, 0},
             .velocity = {1, 0, 0},
             .radius = 0.5,
             .mass = std::numeric_limits<double>::infinity(),
             .species = 255});
  world.add(
      {.position = {3, 0, 0}, .radius = 0.25, .mass = 2, .spin = {0.1, -2, 1e-7}, .inertia_factor = 1.0 / 3});
  const Snapshot snapshot = parse(frame_of(world, 0.5));
  ASSERT_EQ(snapshot.spheres.size(), 2U);
  EXPECT_TRUE(std::isinf(snapshot.spheres[0].mass));
  EXPECT_EQ(snapshot.spheres[0].species, 255);
  EXPECT_EQ(snapshot.spheres[1].species, 0);
  EXPECT_EQ(snapshot.spheres[1].spin, (Vec3{0.1, -2, 1e-7}));
  EXPECT_EQ(snapshot.spheres[1].inertia_factor, 1.0 / 3);
}

TEST(ExtendedXyz, KeepsIdsImagesAndTheBox) {
  World world(Box({Boundary::periodic, Boundary::open, Boundary::wall}, {10, 0, 30}));
  world.add({.position = {1, -2, 3}, .velocity = {-7, 1, 0}, .radius = 0.5});
  world.add({.position = {5, 7, 3}, .velocity = {2, 1, 0}, .radius = 1});
  world.remove(0);
  const Snapshot written = snapshot_of(world, Time(8));
  const Snapshot read = parse(frame_of(world, 8));
  EXPECT_EQ(read.ids, (std::vector<std::int64_t>{1}));
  EXPECT_EQ(read.images, written.images);
  EXPECT_EQ(read.image(0)[0], 2);
  EXPECT_EQ(read.box, written.box);
  EXPECT_TRUE(read.box->is_unbounded);
}

TEST(ExtendedXyz, SaysThatDiscsAreDiscs) {
  World world(Box::flat_walls(5, 4));
  world.add({.position = {1, 2, 0}, .radius = 0.5});
  const Snapshot read = parse(frame_of(world, 0));
  EXPECT_TRUE(read.box->is_flat);
  EXPECT_EQ(read.box->size, (Vec3{5, 4, 1}));
}

TEST(ExtendedXyz, TakesOtherTypesForNoSpecies) {
  const std::string columns = ":1:pos:R:3:velo:R:3:radius:R:1\n";
  EXPECT_EQ(parse("1\nProperties=type:S" + columns + "Au 0 0 0 0 0 0 1\n").spheres[0].species, 0);
  EXPECT_EQ(parse("1\nProperties=type:I" + columns + "1000 0 0 0 0 0 0 1\n").spheres[0].species, 0);
  EXPECT_EQ(parse("1\nProperties=type:I" + columns + "3 0 0 0 0 0 0 1\n").spheres[0].species, 2);
}

const std::string kGood = "Properties=pos:R:3:velo:R:3:radius:R:1\n";

INSTANTIATE_TEST_SUITE_P(
    All, RefusedSnapshot,
    testing::Values(
        BadFile{"Empty", "", "start.xyz", "no frame"},
        BadFile{"NoCount", "spheres\n", "start.xyz:1:1", "'spheres'"},
        BadFile{"NegativeCount", "-1\n" + kGood, "start.xyz:1:1", "'-1'"},
        BadFile{"TwoCounts", "1 2\n" + kGood, "start.xyz:1:1", "'1 2'"},
        BadFile{"NoSecondLine", "1\n", "start.xyz:1", "ends after 0 of the 1"},
        BadFile{"TornFrame", "2\n" + kGood + "1 0 0 0 0 0 1\n", "start.xyz:3", "ends after 1 of the 2"},
        BadFile{"TornLastFrame", "1\n" + kGood + "1 0 0 0 0 0 1\n1\n", "start.xyz:4",
                "ends after 0 of the 1"},
        BadFile{"NoProperties", "1\nplain comment\n1 0 0 0 0 0 1\n", "start.xyz:2", "no Properties"},
        BadFile{"OpenQuote", "1\nLattice=\"1 0\n1\n", "start.xyz:2:9", "never closed"},
        BadFile{"NoPosition", "1\nProperties=velo:R:3:radius:R:1\n0 0 0 1\n", "start.xyz:2:12", "'pos'"},
        BadFile{"NoMasses", "1\nProperties=pos:R:3:momenta:R:3:radius:R:1\n0 0 0 0 0 0 1\n", "start.xyz:2:12",
                "no masses"},
        BadFile{"NoRadius", "1\nProperties=pos:R:3:velo:R:3\n0 0 0 0 0 0\n", "start.xyz:2:12", "'radius'"},
        BadFile{"WrongType", "1\nProperties=pos:I:3:velo:R:3:radius:R:1\n0 0 0 0 0 0 1\n", "start.xyz:2:12",
                "another type"},
        BadFile{"WrongWidth", "1\nProperties=pos:R:2:velo:R:3:radius:R:1\n0 0 0 0 0 1\n", "start.xyz:2:12",
                "another type or width"},
        BadFile{"NoWidth", "1\nProperties=pos:R:3:velo:R\n0 0 0 0 0 1\n", "start.xyz:2:20", "have no count"},
        BadFile{"ColumnTwice", "1\nProperties=pos:R:3:pos:R:3\n0 0 0 0 0 1\n", "start.xyz:2:20", "twice"},
        BadFile{"TooFewValues", "1\n" + kGood + "1 2 3 4 5 6\n", "start.xyz:3", "6 values"},
        BadFile{"TooManyValues", "1\n" + kGood + "1 2 3 4 5 6 7 8\n", "start.xyz:3", "8 values"},
        BadFile{"NoNumber", "1\n" + kGood + "1 2 x 4 5 6 7\n", "start.xyz:3:5", "pos is 'x'"},
        BadFile{"HalfANumber", "1\n" + kGood + "1 2 3 4.5.6 5 6 7\n", "start.xyz:3:7", "velo is '4.5.6'"},
        BadFile{"NotANumber", "1\n" + kGood + "1 2 3 4 5 6 nan\n", "start.xyz:3:13", "radius is 'nan'"},
        BadFile{"Infinite", "1\n" + kGood + "inf 2 3 4 5 6 7\n", "start.xyz:3:1", "pos is 'inf'"},
        BadFile{"TooLarge", "1\n" + kGood + "1e999 2 3 4 5 6 7\n", "start.xyz:3:1", "pos is '1e999'"},
        BadFile{"BadTime", "1\nTime=now " + kGood + "1 2 3 4 5 6 7\n", "start.xyz:2:6", "Time is 'now'"},
        BadFile{"PbcOfOtherWords", "0\n" + kLattice + "pbc=\"yes yes no\" " + kGood, "start.xyz:2:34",
                "pbc is 'yes'"},
        BadFile{"PbcOfOneValue", "0\n" + kLattice + "pbc=T " + kGood, "start.xyz:2:33", "pbc has 1 value"},
        BadFile{"PbcWithoutBlanks", "0\n" + kLattice + "pbc=\"TTF\" " + kGood, "start.xyz:2:34",
                "pbc has 1 value"},
        BadFile{"PbcWithoutLattice", "0\npbc=\"T F F\" " + kGood, "start.xyz:2:6", "no Lattice"},
        BadFile{"EightNumbers", "0\nLattice=\"5.44 0.0 0.0 0.0 5.44 0.0 0.0 0.05.44\" " + kGood,
                "start.xyz:2:10", "Lattice has 8 values"},
        BadFile{"NoNumberInLattice", "0\nLattice=\"4 0 0 0 5 0 0 0 6.4.4\" " + kGood, "start.xyz:2:26",
                "Lattice is '6.4.4'"},
        BadFile{"ExponentOfMathematica", "0\nLattice=\"4*^0 0 0 0 5 0 0 0 6\" " + kGood, "start.xyz:2:10",
                "Lattice is '4*^0'"},
        BadFile{"EmptyLattice", "0\nLattice " + kGood, "start.xyz:2:8", "Lattice has 0 values"},
        BadFile{"NegativeEdge", "0\nLattice=\"4 0 0 0 -5 0 0 0 6\" " + kGood, "start.xyz:2:10",
                "an edge of -5"},
        BadFile{"NoEdge", "0\nLattice=\"4 0 0 0 5 0 0 0 0\" " + kGood, "start.xyz:2:10",
                "periodic along z and has no size"},
        BadFile{"Triclinic", "0\nLattice=\"4 0 0 0 5 0 1 0 6\" " + kGood, "start.xyz:2:10", "triclinic"},
        BadFile{"TiltedMatrix", "0\nLattice=[[4,0,0],[1,5,0],[0,0,6]] " + kGood, "start.xyz:2:10",
                "tilted box in brackets"},
        BadFile{"BadOrigin", "0\n" + kLattice + "Origin=\"1 2\" " + kGood, "start.xyz:2:37",
                "Origin has 2 values"},
        BadFile{"BadUnbounded", "0\n" + kLattice + "unbounded=maybe " + kGood, "start.xyz:2:39",
                "unbounded is 'maybe'"},
        BadFile{"KeyInAnotherCase", "0\nlattice=\"4 0 0 0 5 0 0 0 6\" " + kGood, "start.xyz:2:1",
                "another case"},
        BadFile{"KeyTwice", "0\n" + kLattice + kLattice + kGood, "start.xyz:2:29", "occurs twice"},
        BadFile{"OpenBracket", "0\nLattice=[[4,0,0] " + kGood, "start.xyz:2:9", "never closed"},
        BadFile{"VelocityTwice", "1\nProperties=pos:R:3:velo:R:3:vel:R:3:radius:R:1\n0 0 0 0 0 0 0 0 0 1\n",
                "start.xyz:2:29", "appears twice"},
        BadFile{"BadId", "1\nProperties=id:I:1:pos:R:3:velo:R:3:radius:R:1\n1.5 2 3 4 5 6 7 8\n",
                "start.xyz:3:1", "id is '1.5'"},
        BadFile{"IdTwice",
                "2\nProperties=id:I:1:pos:R:3:velo:R:3:radius:R:1\n4 2 3 4 5 6 7 8\n4 2 3 4 5 6 7 8\n",
                "start.xyz:4", "id 4 is already on line 3"}),
    [](const testing::TestParamInfo<BadFile>& test) { return test.param.name; });

}  // namespace
}  // namespace hardball::extended_xyz_test
