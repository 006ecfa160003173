// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Spheres that lose energy under gravity come to rest, at a bounded cost and by themselves.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli/program.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"

namespace hardball::heap_test {
namespace {

using nlohmann::json;
using namespace support;

// Of diameter .5 and mass one, under a gravity of 10.
constexpr double kLift = 5;

// Twenty of the discs fit the width exactly: the lowest row is pressed flat.
std::string discs_in_room(const std::string& response) {
  return "[box]\ndimensions = 2\nboundary = [\"wall\", \"wall\"]\nsize = [10.0, 30.0]\n"
         "gravity = [0.0, -10.0]\n[[spheres]]\ncount = 200\nradius = 0.25\nplacement = \"random\"\n"
         "temperature = 1.0\n[response]\n" +
         response + "[run]\nuntil = 30.0\n[output]\nsnapshots_every = 1.0\nevent_log = true\n";
}

std::string balls_on_floor(const std::string& balls, const std::string& response) {
  return "[box]\nboundary = [\"open\", \"open\", \"wall\"]\nsize = [10.0]\ngravity = [0.0, 0.0, -9.8]\n"
         "[[spheres]]\n" +
         balls + "[response]\n" + response + "[run]\nuntil = 3.0\n[output]\nsnapshots_every = 0.1\n";
}

class Heap : public ProgramTest {
 protected:
  ProgramOutcome run(const std::string& scenario, const Arguments& more = {}) {
    write_text(folder_ / "heap.toml", scenario);
    return program({"run", "heap.toml", "--out", "out", "--overwrite", "--quiet", "--json"}, more);
  }
  json summary(const std::string& scenario, const Arguments& more = {}) {
    const ProgramOutcome outcome = run(scenario, more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
    return json::parse(outcome.output);
  }
  Snapshot last_frame() const { return read_snapshot(folder_ / "out/trajectory.xyz"); }
};

double kinetic_energy(const Snapshot& frame) {
  double energy = 0;
  for (const Sphere& sphere : frame.spheres)
    energy += sphere.mass * dot(sphere.velocity, sphere.velocity) / 2;
  return energy / static_cast<double>(frame.spheres.size());
}

TEST_F(Heap, OfDiscsComesToRestByEveryRule) {
  for (const char* const rule :
       {"", "elastic_below = 0.05\n", "elastic_below = 0.2\n", "contact_duration = 0.002\n"}) {
    const json found = summary(discs_in_room(std::string("restitution = 0.8\n") + rule));
    EXPECT_EQ(found["time"], 30) << rule;
    EXPECT_LT(found["at_rest_since"], 15) << rule;
    EXPECT_LT(found["max_overlap"], 1e-9) << rule;
    EXPECT_LT(found["energy"]["final"], found["energy"]["initial"]) << rule;
    EXPECT_LT(found["events"]["collision"], 3e6) << rule;
    EXPECT_LT(kinetic_energy(last_frame()), 0.01 * kLift) << rule;
    EXPECT_EQ(last_frame().time, 30) << "a frame of a heap at rest shows it at its own time";
  }
}

TEST_F(Heap, AtRestCostsNothing) {
  const std::string scenario = discs_in_room("restitution = 0.5\n");
  const json shorter = summary(scenario);
  const json longer = summary(scenario, {"--set", "run.until=3000", "--set", "output.snapshots_every=1000"});
  EXPECT_EQ(longer["time"], 3000);
  EXPECT_EQ(longer["event_log_hash"], shorter["event_log_hash"]);
  EXPECT_EQ(longer["at_rest_since"], shorter["at_rest_since"]);
}

TEST_F(Heap, IsTheSameWhereverTheRunIsCut) {
  const std::string scenario = discs_in_room("restitution = 0.5\n");
  const json whole = summary(scenario);
  const std::string frames = read_text(folder_ / "out/trajectory.xyz");
  for (const char* const until : {"2.5", "12"}) {
    EXPECT_EQ(run(scenario, {"--set", std::string("run.until=") + until}).exit_code, 0);
    const ProgramOutcome resumed =
        run_program(folder_, {"resume", "out", "--until", "30", "--quiet", "--json"});
    ASSERT_EQ(resumed.exit_code, 0) << resumed.messages;
    const json found = json::parse(resumed.output);
    for (const char* const key : {"time", "at_rest_since", "event_log_hash", "energy"})
      EXPECT_EQ(found[key], whole[key]) << until << " " << key;
    EXPECT_EQ(read_text(folder_ / "out/trajectory.xyz"), frames) << until;
  }
  EXPECT_EQ(summary(scenario, {"--threads", "2"})["event_log_hash"], whole["event_log_hash"]);
}

TEST_F(Heap, IsShownAsFarAsItMoves) {
  const json found = summary(discs_in_room("restitution = 0.5\n"));
  const ProgramOutcome shown = run_program(folder_, {"replay", "heap.toml", "--out", "heap.html"});
  ASSERT_EQ(shown.exit_code, 0) << shown.messages;
  EXPECT_NE(shown.output.find(", " + to_string(found["events"]["collision"]) + " collisions"),
            std::string::npos)
      << shown.output;
}

TEST_F(Heap, ThatIsNotAtRestIsSaid) {
  const std::string scenario = discs_in_room("restitution = 0.5\n");
  write_text(folder_ / "heap.toml", scenario);
  const auto says_so = [&](const Arguments& more) {
    Arguments arguments{"run", "heap.toml", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(folder_, arguments).output.find("  not at rest") != std::string::npos;
  };
  EXPECT_TRUE(says_so({"--until", "1"}));
  EXPECT_FALSE(says_so({}));
  EXPECT_FALSE(says_so({"--until", "1", "--set", "response.restitution=1.0"}));
}

TEST_F(Heap, BallAtRestOnTheFloorStays) {
  const std::string ball = "radius = 0.1\npositions = [[0.0, 0.0, 0.1]]\nvelocities = [[0.0, 0.0, 0.0]]\n";
  for (const char* const rule : {"restitution = 0.8\n", "restitution = 0.8\nelastic_below = 0.001\n",
                                 "restitution = 0.0\n", "settle = true\n"}) {
    const json found = summary(balls_on_floor(ball, rule));
    EXPECT_NEAR(found["energy"]["final"], 0.98, 1e-4) << rule;
    EXPECT_NEAR(last_frame().spheres.front().position.z, 0.1, 1e-5) << rule;
  }
  const ProgramOutcome elastic = run(balls_on_floor(ball, "restitution = 1.0\n"));
  EXPECT_EQ(elastic.exit_code, 1);
  EXPECT_NE(elastic.messages.find("sphere 0 lies still"), std::string::npos) << elastic.messages;
  EXPECT_NE(elastic.messages.find("settle"), std::string::npos) << elastic.messages;
}

TEST_F(Heap, BallsOnEachOtherStay) {
  const std::string balls =
      "radius = 0.5\npositions = [[0.0, 0.0, 0.5], [0.0, 0.0, 1.5]]\n"
      "velocities = [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]\n";
  for (const char* const rule : {"restitution = 0.5\n", "restitution = 0.5\nelastic_below = 0.01\n"}) {
    summary(balls_on_floor(balls, rule));
    EXPECT_NEAR(last_frame().spheres[1].position.z, 1.5, 1e-3) << rule;
  }
}

TEST_F(Heap, GoesOnWithoutTheRuleIfThatIsWanted) {
  const std::string scenario = discs_in_room("restitution = 0.5\nsettle = false\n");
  const ProgramOutcome outcome = run(scenario);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.messages.find("inelastic collapse"), std::string::npos);
  const ProgramOutcome check = run_program(folder_, {"check", "heap.toml"});
  EXPECT_NE(check.output.find("by inelastic collapse, unless settle"), std::string::npos) << check.output;
  EXPECT_NE(check.output.find("a trial of this run failed: inelastic collapse"), std::string::npos);
}

TEST_F(Heap, RuleIsSaidWhereItHolds) {
  write_text(folder_ / "heap.toml", discs_in_room("restitution = 0.8\n"));
  const ProgramOutcome settling = run_program(folder_, {"check", "heap.toml"});
  EXPECT_NE(settling.output.find("elastic within a hundredth of sqrt(d / g)"), std::string::npos);
  EXPECT_EQ(settling.output.find("collapse"), std::string::npos) << settling.output;
  for (const char* const other :
       {"box.gravity=[0.0, 0.0]", "response.restitution=1.0", "response.contact_duration=0.01"}) {
    const ProgramOutcome plain = run_program(folder_, {"check", "heap.toml", "--set", other});
    EXPECT_EQ(plain.output.find("a hundredth"), std::string::npos) << other;
  }
  expect_refusal(run_program(folder_, {"check", "heap.toml", "--set", "box.gravity=[0.0, 0.0]", "--set",
                                       "response.settle=true"}),
                 {"nothing settles without gravity"});
}

}  // namespace
}  // namespace hardball::heap_test
