// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What the program tells of species that bounce, merge and pass through each other.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/program.hpp"
#include "hardball/recording/recording_reader.hpp"

namespace hardball::species_test {
namespace {

using nlohmann::json;
using namespace support;
using SpeciesInWords = ProgramTest;
using Potentials = ProgramTest;

const std::string kSpecies = R"([box]
size = [10.0, 10.0, 10.0]
boundary = ["wall", "periodic", "periodic"]
[[species]]
name = "drop"
[[species]]
name = "mist"
[[spheres]]
count = 60
radius = 0.4
placement = "random"
temperature = 1.0
species = "drop"
[[spheres]]
count = 100
radius = 0.2
placement = "random"
temperature = 1.0
species = "mist"
[[spheres]]
count = 1
radius = 0.5
placement = "random"
kinematic = true
speed = 0.0
species = "mist"
[response]
kind = "merge"
[[response.pairs]]
kind = "pass"
between = ["mist", "mist"]
[[response.pairs]]
kind = "bounce"
restitution = { law = "viscoelastic", value = 0.8, speed = 1.0 }
tangential_restitution = 0.5
contact_duration = 1e-6
between = ["drop", "wall"]
[output]
recording = true
[run]
until = 3.0
)";

TEST_F(SpeciesInWords, AreCheckedBeforeTheRun) {
  write_text(folder_ / "species.toml", kSpecies);
  const ProgramOutcome checked = run_program(folder_, {"check", "species.toml"});
  ASSERT_EQ(checked.exit_code, 0) << checked.messages;
  expect_in(checked.output, "spheres merge; at walls they bounce, elastic");
  expect_in(checked.output, "mist and mist           pass through each other");
  expect_in(checked.output,
            "drop at walls           bounce, viscoelastic, restitution 0.8 at the impact speed 1, "
            "rough with tangential restitution 0.5, elastic within 1e-06 after another contact");
  expect_in(checked.output, "drop 60, mist 101");
  expect_in(checked.output, "kinematic               1 sphere");
}

TEST_F(SpeciesInWords, AreCountedRecordedAndReportedByTheRun) {
  write_text(folder_ / "species.toml", kSpecies);
  const ProgramOutcome outcome =
      run_program(folder_, {"run", "species.toml", "--out", "out", "--json", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.messages;
  const json summary = json::parse(outcome.output);
  const std::size_t mergers = summary["events"]["merger"];
  const std::size_t passes = summary["events"]["pass"];
  ASSERT_GT(mergers, 0U);
  ASSERT_GT(passes, 0U);
  EXPECT_EQ(summary["spheres"], 161 - mergers);
  EXPECT_EQ(summary["species"]["drop"].get<std::size_t>() + summary["species"]["mist"].get<std::size_t>(),
            161 - mergers);
  EXPECT_GT(summary["energy"]["rotational"], 0);
  const std::string report = read_text(folder_ / "out/report.html");
  expect_in(report, "<dt>mergers</dt><dd>" + std::to_string(mergers) + "</dd>");
  expect_in(report, "pass through each other");
  RecordingReader reader(folder_ / "out/recording.hbr");
  EXPECT_EQ(reader.header().species_names, (std::vector<std::string>{"drop", "mist"}));
  EXPECT_TRUE(std::isnan(reader.header().restitution));
  std::size_t present = 0;
  for (const RecordedBody& body : reader.read(reader.chunks().size() - 1).bodies_at(3)) {
    present += body.exists() ? 1U : 0U;
  }
  EXPECT_EQ(present, 161 - mergers);
  EXPECT_EQ(run_program(folder_, {"replay", "out", "--out", "replay.html"}).exit_code, 0);
}

// What the program tells of potentials of steps and bonds.
TEST_F(Potentials, AreDescribedCheckedAndSummarized) {
  write_text(folder_ / "well.toml", R"([box]
size = [10.0, 10.0, 10.0]
boundary = ["periodic", "periodic", "periodic"]
[[spheres]]
count = 100
radius = 0.5
placement = "random"
temperature = 1.0
[[potentials]]
steps = [{ ratio = 1.2, energy = -2.0 }, { ratio = 1.5, energy = -1.0 }]
[output]
directory = "out"
checkpoint_every = 1e-9
[run]
until = 20.0
)");
  const ProgramOutcome check = run_program(folder_, {"check", "well.toml"});
  EXPECT_NE(check.output.find("energy -2 within 1.2, energy -1 within 1.5"), std::string::npos)
      << check.output;
  EXPECT_NE(check.output.find("steps of potentials add events"), std::string::npos) << check.output;
  const ProgramOutcome run = run_program(folder_, {"run", "well.toml", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  const json summary = json::parse(run.output);
  EXPECT_GT(summary["events"]["step_passed"], 100);
  EXPECT_GT(summary["events"]["step_refused"], 10);
  EXPECT_LT(summary["energy"]["potential"], 0);
  EXPECT_NEAR(summary["energy"]["initial"].get<double>(), summary["energy"]["final"].get<double>(), 1e-9);
  const std::string quantities = read_text(folder_ / "out/measures/quantities.csv");
  for (const char* name :
       {"potential_energy", "heat_capacity", "passed_outward_1", "rate_inward_2", "g_inside_1"})
    EXPECT_NE(quantities.find(name), std::string::npos) << name;
  // Stopped and resumed, it has the same history; and so by every engine.
  const ProgramOutcome half =
      run_program(folder_, {"run", "well.toml", "--until", "10", "--out", "half", "--quiet"});
  ASSERT_EQ(half.exit_code, 0) << half.messages;
  const ProgramOutcome resumed =
      run_program(folder_, {"resume", "half", "--until", "20", "--json", "--quiet"});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.messages;
  EXPECT_EQ(json::parse(resumed.output)["event_log_hash"], summary["event_log_hash"]);
  EXPECT_EQ(run_program(folder_, {"verify", "well.toml", "--until", "5"}).exit_code, 0);
  expect_refusal(run_program(folder_, {"run", "well.toml", "--threads", "2", "--out", "other"}),
                 {"threads cannot share spheres with potentials of steps"});
}

}  // namespace
}  // namespace hardball::species_test
