// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Which progress the program shows, and where.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "cli/program.hpp"

namespace hardball::progress_test {
namespace {

using namespace support;
using ProgressElsewhere = ProgramTest;

std::string gas_of(int spheres) {
  return gas_in_cube(spheres, 120) + "[run]\nuntil = 1e-3\n";
}

// What a program wrote to a terminal as its standard error, and how it ended.
struct Shown {
  std::string text;
  int exit_code = -1;
};

class ProgressOnTerminal : public ProgramTest {
 protected:
  // Sends the program a signal, if one is given, as soon as it has shown the text.
  Shown run(const Arguments& arguments, int signal = 0, const std::string& after = "") const {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    EXPECT_EQ(grantpt(terminal), 0);
    EXPECT_EQ(unlockpt(terminal), 0);
    std::filesystem::remove(folder_ / "program.stderr");
    std::filesystem::create_symlink(ptsname(terminal), folder_ / "program.stderr");
    const Program program(folder_, arguments);
    Shown shown;
    char piece[512];
    for (ssize_t length = 0; (length = read(terminal, piece, sizeof piece)) > 0;) {
      shown.text.append(piece, static_cast<std::size_t>(length));
      if (signal == 0 || shown.text.find(after) == std::string::npos) continue;
      kill(program.process(), signal);
      signal = 0;
    }
    close(terminal);
    int status = 0;
    waitpid(program.process(), &status, 0);
    if (WIFEXITED(status)) shown.exit_code = WEXITSTATUS(status);
    return shown;
  }
};

TEST_F(ProgressOnTerminal, ShowsTheSetUpAndTheRun) {
  write_text(folder_ / "gas.toml", gas_of(20000));
  for (const std::string command : {"run", "check"}) {
    const Shown shown = run({command, "gas.toml"});
    EXPECT_EQ(shown.exit_code, 0);
    EXPECT_NE(shown.text.find("\r[                        ]   0%  setting up"), std::string::npos)
        << shown.text;
    EXPECT_EQ(shown.text.find("collisions/s") != std::string::npos, command == "run");
    EXPECT_TRUE(shown.text.ends_with(" \r")) << "the line is removed";
  }
}

TEST_F(ProgressOnTerminal, ShowsWhatTuningDoes) {
  write_text(folder_ / "gas.toml", gas_of(20000));
  const Shown shown = run({"tune", "gas.toml", "--budget", "1", "--unit-costs", "standard"});
  EXPECT_EQ(shown.exit_code, 0);
  for (const char* word : {"setting up", "settling", "round 1 of measurements"}) {
    EXPECT_NE(shown.text.find(word), std::string::npos) << word << " in " << shown.text;
  }
  EXPECT_TRUE(shown.text.ends_with(" \r")) << "the line is removed";
}

TEST_F(ProgressOnTerminal, IsNotShownIfQuiet) {
  write_text(folder_ / "gas.toml", gas_of(20000));
  for (const Arguments& arguments : {Arguments{"run", "gas.toml", "--quiet"},
                                     Arguments{"tune", "gas.toml", "--budget", "0.1", "--quiet"}}) {
    const Shown shown = run(arguments);
    EXPECT_EQ(shown.exit_code, 0);
    EXPECT_EQ(shown.text, "");
  }
}

// Errors and results are all that is left; a conversion has no other result than its file.
TEST_F(ProgressElsewhere, IsAbsentFromQuietCommands) {
  write_text(folder_ / "gas.toml", gas_of(100) + "[output]\nsnapshots_every = 1e-3\ntrajectory = \"xyz\"\n");
  // Of another box than the file's, and of so dense spheres that they grow into place: two reasons for notes.
  write_text(folder_ / "start.toml",
             "[box]\nsize = [130, 130, 130]\nboundary = [\"periodic\", \"periodic\", \"periodic\"]\n"
             "[start]\nfile = \"out/trajectory.xyz\"\n[run]\nuntil = 1e-3\n");
  write_text(folder_ / "dense.toml",
             "[box]\npacking_fraction = 0.4\nboundary = [\"periodic\", \"periodic\", \"periodic\"]\n"
             "[[spheres]]\ncount = 50\nradius = 0.5\nplacement = \"random\"\nspeed = 1\n"
             "[run]\nuntil = 1e-3\n");
  write_text(folder_ / "a.csv", "x,y,z,radius\n1,1,1,0.5\n");
  const auto expect = [&](Arguments arguments, bool has_result, bool has_note) {
    const ProgramOutcome loud = run_program(folder_, arguments);
    EXPECT_EQ(loud.exit_code, 0) << loud.messages;
    EXPECT_EQ(loud.messages != "", has_note) << arguments.front() << ": " << loud.messages;
    arguments.emplace_back("--quiet");
    if (arguments.front() == "convert" || arguments.front() == "run") arguments.emplace_back("--overwrite");
    const ProgramOutcome quiet = run_program(folder_, arguments);
    EXPECT_EQ(quiet.exit_code, 0) << quiet.messages;
    EXPECT_EQ(quiet.messages, "") << arguments.front();
    EXPECT_EQ(quiet.output != "", has_result) << arguments.front() << ": " << quiet.output;
  };
  expect({"run", "gas.toml", "--out", "out"}, true, false);
  expect({"run", "start.toml"}, true, true);
  expect({"run", "dense.toml"}, true, true);
  expect({"resume", "out"}, false, true);
  expect({"check", "dense.toml"}, true, true);
  expect({"verify", "dense.toml"}, true, true);
  expect({"tune", "dense.toml", "--budget", "0.1"}, true, true);
  expect({"pack", "--count", "3", "--phi", "0.2"}, true, false);
  expect({"convert", "out/trajectory.xyz", "b.csv"}, false, false);
}

TEST_F(ProgressElsewhere, NoCommandPrintsHelp) {
  const ProgramOutcome outcome = run_program(folder_, {});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.messages, "");
  EXPECT_EQ(outcome.output, run_program(folder_, {"--help"}).output);
  EXPECT_NE(outcome.output.find("Run a scenario"), std::string::npos) << outcome.output;
}

TEST_F(ProgressOnTerminal, LetsASignalEndTheSetUp) {
  write_text(folder_ / "gas.toml", gas_of(1000000));
  for (const int signal : {SIGINT, SIGTERM}) {
    const Shown shown = run({"run", "gas.toml", "--out", "out"}, signal, "setting up");
    EXPECT_EQ(shown.exit_code, 1);
    EXPECT_NE(shown.text.find("hardball: interrupted during the set-up, "), std::string::npos) << shown.text;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  }
}

TEST_F(ProgressElsewhere, IsNotShown) {
  write_text(folder_ / "gas.toml", gas_of(20000));
  for (const std::string command : {"run", "check"}) {
    EXPECT_EQ(run_program(folder_, {command, "gas.toml"}).messages, "");
  }
}

}  // namespace
}  // namespace hardball::progress_test
