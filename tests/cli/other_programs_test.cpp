// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Runs that start from files of other programs, and files for these.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli/program.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"

namespace hardball::other_programs_test {
namespace {

using namespace support;

const std::string kCube =
    "[box]\nsize = [8.0, 8.0, 8.0]\nboundary = ['periodic', 'periodic', 'periodic']\n[run]\nuntil = 1\n";

class OtherPrograms : public ProgramTest {
 protected:
  ProgramOutcome run(const std::string& scenario, const Arguments& more = {}) {
    write_text(folder_ / "run.toml", scenario);
    return program({"run", "run.toml", "--quiet", "--json"}, more);
  }
};

// Two grains of 4 mm that meet at 1 m/s each, in SI units, as users of granular packages have them.
TEST_F(OtherPrograms, CollideFromADataFileOfLammps) {
  write_text(folder_ / "two.data",
             "two grains, written by hand\n\n2 atoms\n1 atom types\n\n0 0.08 xlo xhi\n0 0.04 ylo yhi\n"
             "0 0.08 zlo zhi\n\nAtoms # sphere\n\n1 1 0.004 2500 0.04 0.02 0.040 0 0 0\n"
             "2 1 0.004 2500 0.04 0.02 0.04416 0 0 0\n\nVelocities\n\n1 0 0 1 0 0 0\n2 0 0 -1 0 0 0\n");
  const ProgramOutcome outcome =
      run("[box]\nboundary = ['periodic', 'periodic', 'periodic']\nsize = [0.08, 0.04, 0.08]\n"
          "[response]\nrestitution = 0.8\n[start]\nfile = 'two.data'\n[run]\nuntil = 0.001\n"
          "[output]\ndirectory = 'out'\nsnapshots_every = 0.001\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.messages;
  EXPECT_EQ(outcome.messages, "");
  const Snapshot last = read_snapshot(folder_ / "out/trajectory.xyz");
  ASSERT_EQ(last.spheres.size(), 2U);
  // Some operations on numbers of order one.
  EXPECT_NEAR(last.spheres[0].velocity.z, -0.8, 1e-14);
  EXPECT_NEAR(last.spheres[1].velocity.z, 0.8, 1e-14);
  EXPECT_EQ(nlohmann::json::parse(outcome.output)["events"]["collision"], 1);
}

TEST_F(OtherPrograms, StartFromScaledPositions) {
  write_text(folder_ / "s.lammpstrj",
             "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n"
             "3.3501000000000003e-02 6.2616999999999997e+01\n-5.2700000000000002e-01 2.8887000000000000e+01\n"
             "-1.5000000000000000e+01 4.0000000000000000e+01\nITEM: ATOMS id type xs ys zs vx vy vz radius\n"
             "2608 2 0.0407033 0.457803 0.384662 1 0 0 0.5\n");
  ASSERT_EQ(run_program(folder_, {"convert", "s.lammpstrj", "s.xyz"}).exit_code, 0);
  const Snapshot read = read_snapshot(folder_ / "s.xyz");
  // The fractions have six digits.
  EXPECT_NEAR(read.spheres.at(0).position.x, 0.033501 + 0.0407033 * 62.583499, 1e-5);
  EXPECT_NEAR(read.spheres.at(0).position.x, 2.580855, 1e-5);
  EXPECT_NEAR(read.spheres.at(0).position.y, 12.938817, 1e-5);
  EXPECT_NEAR(read.spheres.at(0).position.z, 6.15641, 1e-5);
  EXPECT_EQ(read.box->low.z, -15);
}

TEST_F(OtherPrograms, StartFromTheLastFrameOfEdmd) {
  write_text(folder_ / "a.sph",
             "# made by Grow\n3\n8.0 8.0 8.0\na 1.0 2.0 3.0 0.5\nb 7.95 -0.067840512120 5.4 "
             "0.3\nc 12.5 4.0 -9.5 0.25\n");
  const ProgramOutcome outcome = run(kCube + "[start]\nfile = 'a.sph'\ntemperature = 1.0\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.messages;
  const auto summary = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(summary["spheres"], 3);
  EXPECT_NEAR(summary["energy"]["initial"], 4.5, 1e-13);
}

// As HOOMD-blue writes initial states: without a chunk of velocities, which then are zero.
TEST_F(OtherPrograms, GiveVelocitiesToSpheresOfGsdWithoutThem) {
  write_text(folder_ / "still.csv", "x,y,z,radius\n1,4,4,0.5\n4,4,4,0.5\n7,5,6,0.5\n");
  ASSERT_EQ(run_program(folder_, {"convert", "still.csv", "still.gsd"}).exit_code, 0);
  std::string bytes = read_text(folder_ / "still.gsd");
  for (const std::string chunk : {"particles/velocity", "log/particles/velocity64"}) {
    const std::size_t at = bytes.find(chunk + '\0');
    ASSERT_NE(at, std::string::npos);
    bytes[at] = '_';
  }
  write_text(folder_ / "bare.gsd", bytes);
  for (const char* name : {"bare.gsd", "still.gsd"}) {
    const ProgramOutcome warm = run(kCube + "[start]\nfile = '" + name + "'\ntemperature = 1.0\n");
    ASSERT_EQ(warm.exit_code, 0) << warm.messages;
    EXPECT_NEAR(nlohmann::json::parse(warm.output)["energy"]["initial"], 4.5, 1e-13);
    const ProgramOutcome still = run(kCube + "[start]\nfile = '" + name + "'\n");
    ASSERT_EQ(still.exit_code, 0) << still.messages;
    EXPECT_EQ(nlohmann::json::parse(still.output)["energy"]["initial"], 0);
  }
}

// Positions with six digits: neighbors overlap by three millionths of their diameters.
TEST_F(OtherPrograms, OfferToShrinkSpheresThatOverlap) {
  std::string spheres;
  const std::string places[] = {"0.333333", "1.000000", "1.666666", "2.333333"};
  for (const std::string& x : places) {
    for (const std::string& y : places) {
      for (const std::string& z : places) spheres += x + " " + y + " " + z + " 0.1 0.2 -0.1 0.333334\n";
    }
  }
  write_text(folder_ / "in.xyz",
             "64\nLattice=\"2.666667 0 0 0 2.666667 0 0 0 2.666667\" pbc=\"T T T\" "
             "Properties=pos:R:3:velo:R:3:radius:R:1\n" +
                 spheres);
  const std::string scenario =
      "[box]\nboundary = ['periodic', 'periodic', 'periodic']\nsize = [2.666667, 2.666667, 2.666667]\n"
      "[run]\nuntil = 1\n[start]\nfile = 'in.xyz'\n";
  expect_refusal(run(scenario), {"overlap", "shrink = true in [start]"});
  const ProgramOutcome shrunk = run(scenario + "shrink = true\n");
  ASSERT_EQ(shrunk.exit_code, 0) << shrunk.messages;
  // 0.666666 over 0.666668.
  const nlohmann::json summary = nlohmann::json::parse(shrunk.output);
  const std::string note = summary["notes"][0];
  EXPECT_TRUE(note.starts_with("all radii of in.xyz were multiplied by 0.99999700000")) << note;
  EXPECT_LE(summary["max_overlap"], 1e-12);
}

TEST_F(OtherPrograms, GiveTheFramesBeforeOneThatIsCut) {
  const std::string head = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n";
  const std::string rest =
      "\nITEM: BOX BOUNDS pp pp pp\n0 10\n0 10\n0 10\nITEM: ATOMS id type x y z radius\n";
  write_text(folder_ / "cut.lammpstrj",
             head + "1" + rest + "1 1 5 5 5 0.5\n" + head + "3" + rest + "3 2 8 8 8 0.25\n1 2 5 5 5 0.5\n");
  expect_refusal(run_program(folder_, {"convert", "cut.lammpstrj", "a.csv"}),
                 {"cut.lammpstrj:21: the file ends after 2 of the 3 spheres", "--frame"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.csv"));
  EXPECT_EQ(run_program(folder_, {"convert", "cut.lammpstrj", "a.csv", "--frame", "0"}).exit_code, 0);
  EXPECT_EQ(read_snapshot(folder_ / "a.csv").spheres.size(), 1U);
}

TEST_F(OtherPrograms, GetGunzipNamedForFilesOfGzip) {
  write_text(folder_ / "a.lammpstrj.gz", "\x1f\x8b");
  for (const Arguments& arguments :
       {Arguments{"info", "a.lammpstrj.gz"}, {"convert", "a.lammpstrj.gz", "a.csv"}}) {
    expect_refusal(run_program(folder_, arguments), {"gunzip"});
  }
  EXPECT_EQ(run(kCube + "[start]\nfile = 'a.lammpstrj.gz'\n").exit_code, 2);
}

// Two sizes of one species, of one density: two types, whose spheres LAMMPS gives their masses.
TEST_F(OtherPrograms, GetTypesDiametersAndDensitiesInDataFiles) {
  ASSERT_EQ(run("[box]\nsize = [8.0, 8.0, 8.0]\nboundary = ['periodic', 'periodic', 'periodic']\n"
                "[[spheres]]\ncount = 5\nradius = 0.5\nmass = 4\nplacement = 'random'\nmean_speed = 1\n"
                "[[spheres]]\ncount = 3\nradius = 0.25\nmass = 0.5\nplacement = 'random'\nmean_speed = 1\n"
                "[run]\nuntil = 1\n[output]\ndirectory = 'out'\nsnapshots_every = 1\n")
                .exit_code,
            0);
  ASSERT_EQ(run_program(folder_, {"convert", "out/trajectory.xyz", "a.data"}).exit_code, 0);
  const std::string text = read_text(folder_ / "a.data");
  EXPECT_NE(text.find("\n8 atoms\n2 atom types\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n1 2 1 7.639437"), std::string::npos) << text;
  EXPECT_NE(text.find("\n8 1 0.5 7.639437"), std::string::npos) << text;
  const Snapshot run_end = read_snapshot(folder_ / "out/trajectory.xyz");
  const Snapshot data = read_snapshot(folder_ / "a.data");
  ASSERT_EQ(data.spheres.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(data.spheres[i].position, run_end.spheres[i].position);
    EXPECT_EQ(data.spheres[i].velocity, run_end.spheres[i].velocity);
    EXPECT_EQ(data.spheres[i].radius, run_end.spheres[i].radius);
    EXPECT_NEAR(data.spheres[i].mass, run_end.spheres[i].mass, 1e-14);
    EXPECT_EQ(run_end.spheres[i].species, 0);
  }
}

}  // namespace
}  // namespace hardball::other_programs_test
