// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Runs that do not reach their end: exit code 1, a correct message, and readable files.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "cli/program.hpp"
#include "hardball/recording/recording_reader.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"

namespace hardball::failure_test {
namespace {

using namespace support;

const std::string kOutput =
    "[output]\ndirectory = \"out\"\nsnapshots_every = 0.5\nevent_log = true\nrecording = true\n";

// The number of records according to the header of an event log.
std::uint64_t counted_records(const std::filesystem::path& path) {
  const std::string bytes = read_text(path);
  const std::string key = "'shape': (";
  return std::stoull(bytes.substr(bytes.find(key) + key.size()));
}

std::uint64_t records_there(const std::filesystem::path& path) {
  constexpr std::uint64_t kHeaderBytes = 256;
  constexpr std::uint64_t kRecordBytes = 49;
  const std::uint64_t bytes = std::filesystem::file_size(path) - kHeaderBytes;
  EXPECT_EQ(bytes % kRecordBytes, 0U);
  return bytes / kRecordBytes;
}

class Failure : public ProgramTest {
 protected:
  Failure() { write_text(folder_ / "gas.toml", kSmallGas + kOutput); }

  void expect_message(const ProgramOutcome& outcome, const std::string& part) const {
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_TRUE(outcome.messages.starts_with("hardball: ")) << outcome.messages;
    EXPECT_EQ(outcome.messages.find('\n'), outcome.messages.size() - 1) << outcome.messages;
    EXPECT_NE(outcome.messages.find(part), std::string::npos) << outcome.messages;
  }

  void expect_readable_files() const {
    EXPECT_GE(read_snapshot(folder_ / "out/trajectory.xyz").spheres.size(), 20U);
    EXPECT_EQ(counted_records(folder_ / "out/events.npy"), records_there(folder_ / "out/events.npy"));
    const RecordingReader recording(folder_ / "out/recording.hbr");
    EXPECT_EQ(recording.length(), std::filesystem::file_size(folder_ / "out/recording.hbr"));
  }
};

TEST_F(Failure, SaysThatSpheresTouchAtTheStart) {
  std::string spheres = "64\nLattice=\"4 0 0 0 4 0 0 0 4\" Properties=pos:R:3:velo:R:3:radius:R:1\n";
  for (int i = 0; i < 64; ++i) {
    spheres += std::to_string(i % 4) + ".5 " + std::to_string(i / 4 % 4) + ".5 " + std::to_string(i / 16) +
               ".5 " + (i == 0 ? "1 0.3 0.2" : "0 0 0") + " 0.5\n";
  }
  write_text(folder_ / "touching.xyz", spheres);
  write_text(folder_ / "touching.toml",
             "[box]\nsize = [4, 4, 4]\nboundary = ['periodic', 'periodic', 'periodic']\n"
             "[start]\nfile = 'touching.xyz'\n[run]\nuntil = 1\n[measures]\nnames = []\n");
  const ProgramOutcome outcome = run_program(folder_, {"run", "touching.toml", "--quiet"});
  expect_message(outcome, "they touch at the start and are locked among others");
  const ProgramOutcome inelastic =
      run_program(folder_, {"run", "touching.toml", "--quiet", "--set", "response.restitution=0.9"});
  expect_message(inelastic, "or place spheres that touch at the start farther apart");
}

TEST_F(Failure, OfAFullDisk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  std::filesystem::create_directory(folder_ / "out");
  std::filesystem::create_symlink("/dev/full", folder_ / "out/trajectory.xyz");
  const ProgramOutcome outcome = run_program(folder_, {"run", "gas.toml", "--json"});
  expect_message(outcome, "out/trajectory.xyz: No space left on device");
  EXPECT_EQ(outcome.output, "");
  EXPECT_EQ(counted_records(folder_ / "out/events.npy"), records_there(folder_ / "out/events.npy"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/summary.json"));
}

TEST_F(Failure, OfAFileThatMayNotGrow) {
  const ProgramOutcome outcome =
      Program(folder_, {"run", "gas.toml", "--until", "50"}, HARDBALL_PROGRAM, rlim_t{20'000}).wait();
  expect_message(outcome, "out/trajectory.xyz: File too large");
  EXPECT_NE(outcome.messages.find("the run reached time"), std::string::npos) << outcome.messages;
  expect_readable_files();
  const Snapshot last = read_snapshot(folder_ / "out/trajectory.xyz");
  EXPECT_GT(last.time, 0);
  EXPECT_LT(last.time, 50);
}

TEST_F(Failure, OfTheEventLog) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  std::filesystem::create_directory(folder_ / "out");
  std::filesystem::create_symlink("/dev/full", folder_ / "out/events.npy");
  const ProgramOutcome outcome = run_program(folder_, {"run", "gas.toml"});
  expect_message(outcome, "out/events.npy: No space left on device");
}

TEST_F(Failure, OfTheStandardOutput) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  const ProgramOutcome outcome =
      Program(folder_, {"-c", "exec " HARDBALL_PROGRAM " run gas.toml >/dev/full"}, "/bin/sh").wait();
  expect_message(outcome, "standard output");
  expect_readable_files();
}

class Interruption : public Failure, public testing::WithParamInterface<int> {};

TEST_P(Interruption, LeavesCompleteFiles) {
  using namespace std::chrono_literals;
  const Program program(folder_, {"run", "gas.toml", "--json", "--set", "spheres.0.count=300", "--unit-costs",
                                  "standard", "--until", "1e6"});
  const std::filesystem::path trajectory = folder_ / "out/trajectory.xyz";
  for (int i = 0; i < 2000; ++i) {
    if (std::filesystem::exists(trajectory) && std::filesystem::file_size(trajectory) > 0) break;
    std::this_thread::sleep_for(10ms);
  }
  kill(program.process(), GetParam());
  const ProgramOutcome outcome = program.wait();
  expect_message(outcome, "interrupted at time ");
  EXPECT_NE(outcome.messages.find(" of 1e+06"), std::string::npos) << outcome.messages;
  expect_readable_files();
  const auto summary = nlohmann::json::parse(outcome.output);
  EXPECT_LT(summary["time"], 1e6);
  EXPECT_EQ(read_text(folder_ / "out/summary.json"), outcome.output);
  const std::uint64_t contacts =
      summary["events"]["collision"].get<std::uint64_t>() + summary["events"]["wall"].get<std::uint64_t>();
  EXPECT_EQ(counted_records(folder_ / "out/events.npy"), contacts);
  const RecordingReader recording(folder_ / "out/recording.hbr");
  EXPECT_EQ(recording.reached(), summary["time"]);
  std::uint64_t recorded = 0;
  for (const ChunkExtent& chunk : recording.chunks()) recorded += chunk.contacts;
  EXPECT_EQ(recorded, contacts);
}

TEST_P(Interruption, EndsARunInWhichNothingEverMeets) {
  using namespace std::chrono_literals;
  write_text(folder_ / "lone.toml",
             "[box]\nsize = [10.0, 10.0, 10.0]\nboundary = [\"periodic\", \"periodic\", \"periodic\"]\n"
             "[[spheres]]\ncount = 1\nradius = 0.5\nplacement = \"random\"\nmean_speed = 1.0\n"
             "[run]\nuntil = 1e12\n[output]\ndirectory = \"out\"\n");
  const Program program(folder_, {"run", "lone.toml", "--engine", "cells", "--unit-costs", "standard"});
  const std::filesystem::path checkpoint = folder_ / "out/checkpoint.hbc";
  for (int i = 0; i < 2000 && !std::filesystem::exists(checkpoint); ++i) std::this_thread::sleep_for(10ms);
  kill(program.process(), GetParam());
  expect_message(program.wait(), " of 1e+12; 'hardball resume out' resumes it");
}

INSTANTIATE_TEST_SUITE_P(Signals, Interruption, testing::Values(SIGINT, SIGTERM));

// So slow a run that its records fill no buffer for a long time.
TEST_F(Failure, OfAProcessKilledOutrightLosesLittleOfTheEventLog) {
  using namespace std::chrono_literals;
  const Program program(
      folder_, {"run", "gas.toml", "--unit-costs", "standard", "--until", "1e6", "--engine", "all-pairs",
                "--set", "spheres.0.count=10000", "--set", "spheres.0.radius=0.05", "--quiet"});
  const std::filesystem::path log = folder_ / "out/events.npy";
  std::uint64_t counted = 0;
  for (int i = 0; i < 6000 && counted == 0; ++i) {
    std::this_thread::sleep_for(10ms);
    if (std::filesystem::exists(log) && std::filesystem::file_size(log) > 256) counted = counted_records(log);
  }
  kill(program.process(), SIGKILL);
  program.wait();
  counted = counted_records(log);
  EXPECT_GT(counted, 0U);
  const std::uint64_t bytes = std::filesystem::file_size(log);
  EXPECT_LE(256 + 49 * counted, bytes);
  EXPECT_LT(bytes, std::uint64_t{4} << 20) << "the log has not completed itself";
  // The reader's recipe of docs/scenarios.md.
  write_text(folder_ / "read.py",
             "import numpy\n"
             "header = numpy.lib.format.open_memmap('out/events.npy', mode='r')\n"
             "events = numpy.fromfile('out/events.npy', header.dtype, offset=256)\n"
             "print(len(header), len(events), bool(numpy.all(numpy.diff(events['time']) >= 0)))\n");
  const ProgramOutcome outcome = Program(folder_, {"read.py"}, HARDBALL_PYTHON).wait();
  EXPECT_EQ(outcome.output, std::to_string(counted) + " " + std::to_string((bytes - 256) / 49) + " True\n")
      << outcome.messages;
}

TEST_F(Failure, OfARunThatCannotContinue) {
  write_text(folder_ / "collapse.toml",
             "[box]\nsize = [20, 20, 20]\nboundary = ['wall', 'wall', 'wall']\n"
             "[[spheres]]\nradius = 0.5\nspeed = 0\npositions = [[2, 10, 10]]\n"
             "[[spheres]]\nradius = 0.5\npositions = [[5, 10, 10], [8, 10, 10]]\n"
             "velocities = [[-1, 0, 0], [-2, 0, 0]]\n"
             "[response]\nrestitution = 0.01\n[run]\nuntil = 1e9\n");
  const ProgramOutcome outcome = run_program(folder_, {"run", "collapse.toml"});
  expect_message(outcome, "the run reached time");
  EXPECT_EQ(outcome.output, "");
}

}  // namespace
}  // namespace hardball::failure_test
