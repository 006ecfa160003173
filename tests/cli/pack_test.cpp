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

namespace hardball::pack_test {
namespace {

using nlohmann::json;
using support::Arguments;
using support::Outcome;

class Pack : public testing::Test {
 protected:
  Outcome pack(Arguments arguments) {
    arguments.insert(arguments.begin(), "pack");
    return support::run_program(folder_, arguments);
  }
  json packed(Arguments arguments, int exit_code = 0) {
    arguments.emplace_back("--json");
    const Outcome outcome = pack(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.messages;
    return json::parse(outcome.output);
  }
  std::string text(const std::string& name) { return support::read_text(folder_ / name); }

  support::ScratchFolder folder_;
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

TEST_F(Pack, WritesEveryFormat) {
  Arguments arguments{"--count", "20", "--phi", "0.4"};
  for (const std::string file : {"a.xyz", "a.xyz.zst", "a.gsd", "a.lammpstrj", "a.pvd", "a.csv", "a.npy"}) {
    arguments.insert(arguments.end(), {"--out", file});
  }
  EXPECT_EQ(pack(arguments).exit_code, 0);
  for (const std::string file : {"a.xyz", "a.gsd", "a.csv", "a.npy"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / file)) << file;
  // The same numbers in all of them.
  EXPECT_EQ(support::run_program(folder_, {"convert", "a.gsd", "b.csv"}).exit_code, 0);
  EXPECT_EQ(text("a.csv"), text("b.csv"));
  EXPECT_EQ(pack(arguments).exit_code, 2) << "it would overwrite them";
}

TEST_F(Pack, GoesOnFromAFile) {
  packed({"--count", "40", "--phi", "0.4", "--out", "a.xyz"});
  const json found = packed({"--start", "a.xyz", "--phi", "0.5", "--out", "b.xyz"});
  EXPECT_NEAR(found["phi"].get<double>(), 0.5, 1e-12);
  EXPECT_EQ(pack({"--start", "b.xyz", "--phi", "0.4"}).exit_code, 2);
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
  const support::Program program(folder_, {"pack", "--count", "3000", "--phi", "max", "--out", "a.xyz"});
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  kill(program.process(), SIGINT);
  const Outcome outcome = program.wait();
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
    const Outcome outcome = pack(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments.back();
    EXPECT_TRUE(outcome.messages.starts_with("hardball: ")) << outcome.messages;
    EXPECT_EQ(outcome.messages.find('\n'), outcome.messages.size() - 1);
    EXPECT_EQ(outcome.output, "");
  }
}

TEST_F(Pack, WarnsOfDoubtfulRequests) {
  const Outcome outcome = pack({"--count", "1000", "--phi", "0.68", "--dry-run"});
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
#endif

}  // namespace
}  // namespace hardball::pack_test
