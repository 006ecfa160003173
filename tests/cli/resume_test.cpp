// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Runs that resume from a checkpoint.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/program.hpp"

namespace hardball::resume_test {
namespace {

using nlohmann::json;
using namespace support;

class Resume : public ProgramTest {
 protected:
  Resume() {
    write_text(folder_ / "gas.toml", kSmallGas +
                                         "[output]\nsnapshots_every = 0.7\nevent_log = true\n"
                                         "recording = true\ncheckpoint_at = [2.0, 1.0]\n");
  }

  json run(const Arguments& arguments) { return json_of(arguments, {"--json", "--quiet"}); }

  void expect_refused(const Arguments& arguments, const std::string& part) {
    expect_refusal(program(arguments), {part});
  }

  // What does not depend on how often the run was resumed, nor on the machine.
  void expect_same(const json& a, const json& b, const std::string& folder_a, const std::string& folder_b) {
    for (const char* key :
         {"spheres", "time", "event_log_hash", "energy", "momentum", "max_overlap", "wall_pressure"}) {
      EXPECT_EQ(a[key], b[key]) << key;
    }
    for (const char* name : {"trajectory.xyz", "events.npy", "measures/quantities.csv"}) {
      EXPECT_EQ(read_text(folder_ / folder_a / name), read_text(folder_ / folder_b / name)) << name;
    }
  }
};

TEST_F(Resume, ARunThatHasEndedGoesOn) {
  const json whole = run({"run", "gas.toml", "--out", "whole", "--until", "9.3"});
  run({"run", "gas.toml", "--out", "parts"});
  run({"resume", "parts", "--until", "7"});
  expect_same(run({"resume", "parts", "--until", "9.3", "--threads", "2"}), whole, "parts", "whole");
}

TEST_F(Resume, GoesOnFromACheckpointThatWasKept) {
  const json whole = run({"run", "gas.toml", "--out", "out"});
  std::filesystem::copy(folder_ / "out", folder_ / "whole", std::filesystem::copy_options::recursive);
  for (const char* checkpoint : {"checkpoints/2.hbc", "checkpoints/1.hbc"}) {
    std::filesystem::remove(folder_ / "out/summary.json");
    expect_same(run({"resume", "out", "--from", checkpoint}), whole, "out", "whole");
  }
}

TEST_F(Resume, GoesOnAfterAnInterruption) {
  const std::string long_run = "run.until=300";
  const json whole = run({"run", "gas.toml", "--out", "whole", "--set", long_run});
  Program program(folder_, {"run", "gas.toml", "--out", "parts", "--set", long_run});
  for (int i = 0; i < 60000 && !exists("parts/trajectory.xyz"); ++i) usleep(1000);
  kill(program.process(), SIGTERM);
  const ProgramOutcome outcome = program.wait();
  if (outcome.exit_code != 0) {
    EXPECT_NE(outcome.messages.find("'hardball resume parts' resumes it"), std::string::npos)
        << outcome.messages;
    std::filesystem::remove(folder_ / "parts/summary.json");
    expect_same(run({"resume", "parts"}), whole, "parts", "whole");
  }
}

TEST_F(Resume, AWholeRunHasNothingToDo) {
  const json whole = run({"run", "gas.toml", "--out", "out"});
  for (const Arguments& arguments :
       {Arguments{"resume", "out"}, {"resume", "out", "--until", "5"}, {"resume", "out", "--until", "5.0"}}) {
    const ProgramOutcome outcome = run_program(folder_, arguments);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(
        outcome.messages,
        "hardball: out: the run is whole: it has reached its end at time 5; --until gives a later one\n");
  }
  EXPECT_EQ(run({"resume", "out"}), whole);
  EXPECT_EQ(json::parse(read_text(folder_ / "out/summary.json")), whole);
}

TEST_F(Resume, RunStartsOrResumes) {
  const Arguments wanted{"run", "gas.toml", "--out", "out", "--set", "run.until=300", "--resume"};
  const json whole = run({"run", "gas.toml", "--out", "whole", "--set", "run.until=300"});
  // A run that is killed before its first checkpoint leaves files and its lock.
  std::filesystem::create_directory(folder_ / "out");
  write_text(folder_ / "out/trajectory.xyz", "half a line");
  write_text(folder_ / "out/run.lock", "");
  Program program(folder_, wanted);
  for (int i = 0; i < 60000 && !exists("out/checkpoint.hbc"); ++i) usleep(1000);
  kill(program.process(), SIGKILL);
  program.wait();
  EXPECT_TRUE(exists("out/checkpoint.hbc"));
  expect_same(run(wanted), whole, "out", "whole");
  // Then there is nothing left to do.
  EXPECT_EQ(
      succeed(wanted).messages,
      "hardball: out: the run is whole: it has reached its end at time 300; --until gives a later one\n");
  EXPECT_EQ(run(wanted), json::parse(text("out/summary.json")));
}

TEST_F(Resume, RunDoesNotResumeAnotherRun) {
  run({"run", "gas.toml", "--out", "out", "--seed", "3"});
  const auto expect_other = [&](const Arguments& more, const std::string& what) {
    expect_refusal(program({"run", "gas.toml", "--out", "out", "--resume"}, more),
                   {"out: holds a run that was started with another " + what + "; name another directory"});
  };
  expect_other({"--seed", "4"}, "--seed");
  expect_other({"--seed", "3", "--until", "9"}, "--until");
  expect_other({"--seed", "3", "--set", "spheres.0.radius=0.4"}, "--set");
  write_text(folder_ / "gas.toml", kSmallGas);
  expect_other({"--seed", "3"}, "scenario");
  expect_refused({"run", "gas.toml", "--resume"}, "--resume: the run has no directory");
  expect_refused({"run", "gas.toml", "--out", "out", "--resume", "--overwrite"}, "exclude each other");
  // Files of which no checkpoint is left are those of another run.
  std::filesystem::remove(folder_ / "out/checkpoint.hbc");
  expect_refused({"run", "gas.toml", "--out", "out", "--resume"}, "of another run");
}

TEST_F(Resume, RefusesWhatIsNoUnfinishedRun) {
  expect_refused({"resume", "nowhere"}, "nowhere/checkpoint.hbc: there is no checkpoint");
  run({"run", "gas.toml", "--out", "out"});
  expect_refused({"resume", "out", "--until", "4"}, "the run has reached time 5");
  expect_refused({"resume", "out", "--until", "x"}, "--until");
  const std::string checkpoint = read_text(folder_ / "out/checkpoint.hbc");
  write_text(folder_ / "out/checkpoint.hbc", checkpoint.substr(0, checkpoint.size() / 2));
  expect_refused({"resume", "out", "--until", "6"}, "out/checkpoint.hbc: ends too early");
  write_text(folder_ / "out/checkpoint.hbc", checkpoint);
  std::filesystem::remove(folder_ / "out/events.npy");
  expect_refused({"resume", "out", "--until", "6"},
                 "out/events.npy: the file that the run continues is gone");
  EXPECT_FALSE(exists("out/run.lock"));
}

TEST_F(Resume, ARunDoesNotReplaceAnother) {
  run({"run", "gas.toml", "--out", "out"});
  const std::string summary = read_text(folder_ / "out/summary.json");
  expect_refused({"run", "gas.toml", "--out", "out"}, "out: holds trajectory.xyz of another run");
  EXPECT_EQ(read_text(folder_ / "out/summary.json"), summary);
  run({"run", "gas.toml", "--out", "out", "--overwrite", "--set", "output.checkpoint_at=[]"});
  EXPECT_FALSE(exists("out/checkpoints"));
}

TEST_F(Resume, ADirectoryBelongsToOneRunAtATime) {
  Program first(folder_, {"run", "gas.toml", "--unit-costs", "standard", "--out", "out", "--until", "1e9"});
  for (int i = 0; i < 60000 && !exists("out/events.npy"); ++i) usleep(1000);
  expect_refused({"run", "gas.toml", "--out", "out", "--overwrite"}, "out: another run is writing to it");
  kill(first.process(), SIGKILL);
  first.wait();
  EXPECT_TRUE(exists("out/run.lock"));
  run({"run", "gas.toml", "--out", "out", "--overwrite"});
  EXPECT_FALSE(exists("out/run.lock"));
}

TEST_F(Resume, GoesOnFromTheStart) {
  const json whole = run({"run", "gas.toml", "--out", "whole", "--set", "output.checkpoint_at=[]"});
  // Files of five kilobytes: far less than the run writes, enough for its first checkpoint.
  const ProgramOutcome failed =
      Program(folder_, {"run", "gas.toml", "--out", "parts", "--set", "output.checkpoint_at=[]"},
              HARDBALL_PROGRAM, 5000)
          .wait();
  EXPECT_EQ(failed.exit_code, 1) << failed.messages;
  EXPECT_NE(failed.messages.find("the run reached time"), std::string::npos) << failed.messages;
  expect_same(run({"resume", "parts"}), whole, "parts", "whole");
}

TEST_F(Resume, RefusesFilesThatHoldSomethingElse) {
  run({"run", "gas.toml", "--out", "out", "--set", R"(output.trajectory=["vtp", "lammps"])"});
  for (const auto& [name, at] : std::map<std::string, std::size_t>{{"trajectory.pvd", 200},
                                                                   {"trajectory/00000000.vtp", 1000},
                                                                   {"trajectory.lammpstrj", 300},
                                                                   {"events.npy", 300},
                                                                   {"recording.hbr", 300}}) {
    const std::string whole = read_text(folder_ / "out" / name);
    std::string changed = whole;
    changed[at] ^= 4;
    write_text(folder_ / "out" / name, changed);
    expect_refused({"resume", "out", "--until", "6"}, "does not hold what was written");
    EXPECT_TRUE(read_text(folder_ / "out" / name) == changed);
    write_text(folder_ / "out" / name, whole);
  }
  run({"resume", "out", "--until", "6"});
}

// The files are cut back to it, and are shorter than they were at any later checkpoint.
TEST_F(Resume, ACheckpointFromWhichARunGoesOnIsTheCurrentOne) {
  run({"run", "gas.toml", "--out", "out", "--set", "measures.names=[]"});
  const std::string kept = read_text(folder_ / "out/checkpoints/1.hbc");
  Program(folder_, {"resume", "out", "--from", "checkpoints/1.hbc", "--until", "1e9"}, HARDBALL_PROGRAM, 5000)
      .wait();
  EXPECT_TRUE(read_text(folder_ / "out/checkpoint.hbc") == kept);
  run({"resume", "out", "--until", "5"});
}

}  // namespace
}  // namespace hardball::resume_test
