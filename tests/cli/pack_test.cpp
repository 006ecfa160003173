// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The command pack.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "cli/program.hpp"
#include "cli/written.hpp"

namespace hardball::pack_test {
namespace {

using nlohmann::json;
using namespace support;

class Pack : public ProgramTest {
 protected:
  ProgramOutcome pack(const Arguments& more) { return program({"pack"}, more); }
  json packed(Arguments arguments, int exit_code = 0) {
    arguments.emplace_back("--json");
    const ProgramOutcome outcome = pack(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.messages;
    return json::parse(outcome.output);
  }
};

TEST_F(Pack, SaysWhatItHasReached) {
  const json found = packed({"--count", "100", "--phi", "0.6", "--out", "bed.xyz", "--seed", "4"});
  EXPECT_EQ(found["status"], "reached");
  EXPECT_NEAR(found["phi"].get<double>(), 0.6, 1e-12);
  EXPECT_EQ(found["count"], 100);
  EXPECT_EQ(found["largest_overlap"], 0);
  EXPECT_EQ(found["seed"], 4);
  EXPECT_EQ(found["files"], json::array({"bed.xyz"}));
  EXPECT_TRUE(found["contacts"].is_null());
  for (const std::string key :
       {"pressure", "collisions", "isostaticity", "rattlers", "shrink", "crystalline", "seconds"})
    EXPECT_TRUE(found.contains(key)) << key;
  EXPECT_NE(text("bed.xyz").find("radius"), std::string::npos);
}

TEST_F(Pack, JamsSpheres) {
  const json found = packed({"--count", "50", "--phi", "max"});
  EXPECT_EQ(found["status"], "jammed");
  EXPECT_GT(found["pressure"].get<double>(), 1e8);
  EXPECT_GT(found["isostaticity"].get<double>(), 0.95);
  EXPECT_GT(found["contacts"].get<int>(), 100);
}

TEST_F(Pack, WritesAReport) {
  packed({"--count", "60", "--phi", "max", "--walls", "z", "--report", "page.html"});
  const std::string page = text("page.html");
  for (const std::string part :
       {"jammed", "Forces", "Neighbors up to a gap", "Radial distribution", "plot-pressure"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_EQ(page.find("{{"), std::string::npos);
  EXPECT_EQ(page.find("From the curved wall"), std::string::npos);
  EXPECT_EQ(pack({"--count", "9", "--phi", "0.3", "--report", "page.html"}).exit_code, 2) << "it exists";
  packed({"--diameter", "1", "--phi", "0.4", "--container", "cone:4,4", "--report", "cone.html"});
  EXPECT_NE(text("cone.html").find("From the curved wall"), std::string::npos);
}

TEST_F(Pack, WritesAPageThatShowsForces) {
  packed({"--count", "20", "--phi", "max", "--rate", "0.1", "--replay", "page.html"});
  EXPECT_NE(text("page.html").find("show-forces"), std::string::npos);
  EXPECT_EQ(pack({"--count", "9", "--phi", "0.3", "--replay", "page.html"}).exit_code, 2) << "it exists";
}

TEST_F(Pack, SaysWhatItHasWritten) {
  const Arguments arguments{"--count", "20",    "--phi",    "0.4",    "--out",    "a.xyz",
                            "--out",   "a.npy", "--report", "r.html", "--replay", "p.html"};
  const ProgramOutcome outcome = pack(arguments);
  for (const std::string file : {"a.xyz", "a.npy", "r.html", "p.html"})
    expect_written(outcome.output, folder_, file, "20 spheres");
  const ProgramOutcome flat = pack({"--count", "9", "--phi", "0.4", "--dimensions", "2", "--out", "d.csv"});
  expect_written(flat.output, folder_, "d.csv", "9 discs");
}

TEST_F(Pack, WritesEveryFormat) {
  Arguments arguments{"--count", "20", "--phi", "0.4"};
  for (const std::string file : {"a.xyz", "a.xyz.zst", "a.gsd", "a.lammpstrj", "a.pvd", "a.csv", "a.npy"}) {
    arguments.insert(arguments.end(), {"--out", file});
  }
  EXPECT_EQ(pack(arguments).exit_code, 0);
  for (const std::string file : {"a.xyz", "a.gsd", "a.csv", "a.npy"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / file)) << file;
  // The same numbers in all of them.
  EXPECT_EQ(run_program(folder_, {"convert", "a.gsd", "b.csv"}).exit_code, 0);
  EXPECT_EQ(text("a.csv"), text("b.csv"));
  EXPECT_EQ(pack(arguments).exit_code, 2) << "it would overwrite them";
}

TEST_F(Pack, GoesOnFromAFile) {
  packed({"--count", "40", "--phi", "0.4", "--out", "a.xyz"});
  const json found = packed({"--start", "a.xyz", "--phi", "0.5", "--out", "b.xyz"});
  EXPECT_NEAR(found["phi"].get<double>(), 0.5, 1e-12);
  EXPECT_EQ(pack({"--start", "b.xyz", "--phi", "0.4"}).exit_code, 2);
}

// A dump of LAMMPS in a tilted box.
TEST_F(Pack, RefusesAStartInATiltedBox) {
  write_text(folder_ / "t.lammpstrj",
             "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS xy xz yz pp pp pp\n"
             "0.0 13.0 3.0\n0.0 10.0 0.0\n0.0 10.0 0.0\n"
             "ITEM: ATOMS id type x y z vx vy vz radius\n"
             "1 1 1 1 1 0 0 0 0.5\n2 1 12.5 9.5 5 0 0 0 0.5\n");
  expect_refusal(pack({"--start", "t.lammpstrj", "--phi", "0.1", "--out", "a.xyz"}), {"tilted by 3"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.xyz"));
}

// LAMMPS in two dimensions has centers at z = 0, and a box from -0.5 to 0.5.
TEST_F(Pack, ReadsADumpOfTwoDimensionsAsDiscs) {
  write_text(folder_ / "d.lammpstrj",
             "ITEM: TIMESTEP\n500\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS pp pp pp\n"
             "0.0 10.0\n0.0 10.0\n-5.0e-01 5.0e-01\n"
             "ITEM: ATOMS id type x y z vx vy vz radius\n"
             "1 1 1 2 0 1 0 0 0.5\n2 2 4 5 0 0 -1 0 0.25\n3 2 9.9 9 0 0.3 -1 0 0.25\n");
  for (const Arguments& more : {Arguments{}, Arguments{"--dimensions", "2"}}) {
    Arguments arguments{"--start", "d.lammpstrj", "--phi", "0.1", "--out", "e.lammpstrj", "--overwrite"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const json found = packed(arguments);
    EXPECT_EQ(found["status"], "reached");
    EXPECT_EQ(found["dimensions"], 2);
    EXPECT_NEAR(found["phi"].get<double>(), 0.1, 1e-12);
  }
  // What is written is read as discs again.
  EXPECT_EQ(packed({"--start", "e.lammpstrj", "--phi", "0.2"})["dimensions"], 2);
}

TEST_F(Pack, KeepsIdsTypesMassesAndTheCornerOfItsStart) {
  write_text(folder_ / "a.lammpstrj",
             "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp ff\n"
             "-2 8\n-0.5 9.5\n-15 5\nITEM: ATOMS id type x y z ix iy iz vx vy vz radius mass\n"
             "5 2 -1.5 0.25 -14 1 0 0 1 0 0 0.5 2\n9 1 7 9 4 0 -1 0 0 1 0 0.25 3\n");
  packed({"--start", "a.lammpstrj", "--phi", "0.1", "--out", "b.lammpstrj"});
  const std::string written = text("b.lammpstrj");
  for (const std::string part : {"-2 8\n-0.5 9.5\n-15 5\n", "\n5 2 ", "\n9 1 ", " 2\n9", " 3\n"})
    EXPECT_NE(written.find(part), std::string::npos) << part << "\n" << written;
  // From a checkpoint, too.
  packed({"--start", "a.lammpstrj", "--phi", "0.1", "--limit", "0", "--out", "c.lammpstrj"}, 1);
  packed({"--resume", "c.lammpstrj.checkpoint", "--out", "c.lammpstrj", "--overwrite"});
  EXPECT_EQ(text("c.lammpstrj"), written);
}

TEST_F(Pack, PredictsWithoutPacking) {
  const json found = packed({"--count", "1000000", "--phi", "0.64", "--dry-run"});
  EXPECT_GT(found["collisions"].get<double>(), 1e8);
  EXPECT_EQ(found["rate"], 0.01);
  EXPECT_FALSE(found["container"]["walls"][0].get<bool>());
}

// The same packing whether it was interrupted or not.
TEST_F(Pack, ResumesToTheSameBits) {
  packed({"--count", "300", "--phi", "max", "--out", "whole.xyz"});
  json part = packed({"--count", "300", "--phi", "max", "--out", "part.xyz", "--limit", "0.05"}, 1);
  EXPECT_EQ(part["status"], "not reached");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "part.xyz.checkpoint"));
  part = packed({"--resume", "part.xyz.checkpoint", "--out", "part.xyz", "--overwrite"});
  EXPECT_EQ(part["status"], "jammed");
  EXPECT_EQ(text("whole.xyz"), text("part.xyz"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "part.xyz.checkpoint"));
  EXPECT_EQ(pack({"--resume", "whole.xyz"}).exit_code, 2);
  EXPECT_EQ(pack({"--resume", "none", "--count", "3"}).exit_code, 2);
}

TEST_F(Pack, StopsAtASignal) {
  const Program program(folder_, {"pack", "--count", "3000", "--phi", "max", "--out", "a.xyz"});
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  kill(program.process(), SIGINT);
  const ProgramOutcome outcome = program.wait();
  EXPECT_EQ(outcome.exit_code, 1) << outcome.messages;
  EXPECT_NE(outcome.messages.find("--resume a.xyz.checkpoint"), std::string::npos) << outcome.messages;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "a.xyz.checkpoint"));
}

TEST_F(Pack, NamesTheRateToTryWhereSpheresLock) {
  const json found = packed({"--count", "64", "--phi", "0.65", "--rate", "0.3", "--out", "a.xyz"}, 1);
  EXPECT_EQ(found["status"], "not reached");
  EXPECT_LT(found["suggested_rate"].get<double>(), 0.3);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "a.xyz"));
}

TEST_F(Pack, RefusesInOneSentence) {
  for (const Arguments& arguments :
       {Arguments{"--count", "100", "--phi", "0.8"}, Arguments{"--count", "100"}, Arguments{"--box", "1,2"},
        Arguments{"--count", "9", "--phi", "0.5", "--out", "a.doc"},
        Arguments{"--count", "9", "--phi", "0.5", "now"},
        Arguments{"--count", "9", "--phi", "0.5", "--limit", "soon"}}) {
    const ProgramOutcome outcome = pack(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments.back();
    EXPECT_TRUE(outcome.messages.starts_with("hardball: ")) << outcome.messages;
    EXPECT_EQ(outcome.messages.find('\n'), outcome.messages.size() - 1);
    EXPECT_EQ(outcome.output, "");
  }
}

TEST_F(Pack, WarnsOfDoubtfulRequests) {
  const ProgramOutcome outcome = pack({"--count", "1000", "--phi", "0.68", "--dry-run"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.messages.find("warning: "), std::string::npos);
}

#if HARDBALL_POLISH
TEST_F(Pack, PolishesToTheIsostaticNumber) {
  const json found = packed({"--count", "60", "--phi", "max", "--polish"});
  EXPECT_EQ(found["polished"], true);
  EXPECT_EQ(found["isostaticity"], 1);
  EXPECT_EQ(found["contacts"], 3 * (found["count"].get<int>() - found["rattlers"].get<int>() - 1) + 1);
  EXPECT_EQ(pack({"--count", "60", "--phi", "0.5", "--polish"}).exit_code, 2);
}

TEST_F(Pack, PolishesInCurvedContainersAndMixtures) {
  for (const Arguments& request :
       {Arguments{"--container", "cylinder:6,8"}, Arguments{"--container", "sphere:7"},
        Arguments{"--container", "cone:6,8"}, Arguments{"--container", "sphere:7", "--dimensions", "2"},
        Arguments{"--sizes", "discrete:1=0.5,5=0.5"}}) {
    Arguments arguments{"--count", "40", "--phi", "max"};
    arguments.insert(arguments.end(), request.begin(), request.end());
    const json before = packed(arguments);
    arguments.emplace_back("--polish");
    const json found = packed(arguments);
    EXPECT_EQ(found["polished"], true) << request[1];
    EXPECT_GE(found["phi"].get<double>(), before["phi"].get<double>() * (1 - 1e-13)) << request[1];
    EXPECT_LT(found["contact_tolerance"].get<double>(), 1.1e-12);
    EXPECT_GE(found["contacts"].get<int>(), before["contacts"].get<int>() * 9 / 10) << request[1];
    // In the apex of a cone one contact holds a sphere all around.
    if (request[1] == "cone:6,8") continue;
    EXPECT_GE(found["isostaticity"].get<double>(), 1) << request[1];
  }
}
#endif

}  // namespace
}  // namespace hardball::pack_test
