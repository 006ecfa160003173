// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The commands convert and info.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "cli/written.hpp"

namespace hardball::convert_test {
namespace {

using namespace support;

class Convert : public ProgramTest {
 protected:
  Convert() {
    write_text(folder_ / "gas.toml", kSmallGas +
                                         "[output]\ndirectory = 'out'\nsnapshots_every = 1\n"
                                         "trajectory = ['xyz', 'xyz.zst', 'gsd', 'lammps', 'vtp']\n"
                                         "event_log = true\nrecording = true\n");
    EXPECT_EQ(run_program(folder_, {"run", "gas.toml", "--quiet"}).exit_code, 0);
  }

  ProgramOutcome convert(const std::string& in, const std::string& out, const Arguments& more = {}) {
    return program({"convert", in, out}, more);
  }
};

TEST_F(Convert, WritesWhatARunWrites) {
  for (const std::string in : {"out/trajectory.xyz", "out/trajectory.xyz.zst", "out/trajectory.gsd"}) {
    for (const std::string ending : {"xyz", "xyz.zst", "gsd", "lammpstrj"}) {
      const ProgramOutcome outcome = convert(in, "a." + ending, {"--overwrite"});
      EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
      expect_written(outcome.output, folder_, "a." + ending, "6 frames");
      EXPECT_EQ(text("a." + ending), text("out/trajectory." + ending)) << in << " to " << ending;
    }
    const ProgramOutcome outcome = convert(in, "trajectory.pvd", {"--overwrite"});
    EXPECT_EQ(outcome.exit_code, 0);
    std::uintmax_t bytes = std::filesystem::file_size(folder_ / "trajectory.pvd");
    for (const auto& frame : std::filesystem::directory_iterator(folder_ / "trajectory"))
      bytes += frame.file_size();
    expect_written(outcome.output, "trajectory.pvd", bytes, "6 frames");
    EXPECT_EQ(text("trajectory.pvd"), text("out/trajectory.pvd"));
    EXPECT_EQ(text("trajectory/00000005.vtp"), text("out/trajectory/00000005.vtp"));
  }
}

TEST_F(Convert, TakesTheLastFrameForATableAndAnyThatIsAskedFor) {
  const ProgramOutcome outcome = convert("out/trajectory.gsd", "last.csv");
  EXPECT_EQ(outcome.exit_code, 0);
  expect_written(outcome.output, folder_, "last.csv", "1 frame");
  EXPECT_EQ(convert("out/trajectory.gsd", "fifth.csv", {"--frame", "5"}).exit_code, 0);
  EXPECT_EQ(convert("out/trajectory.gsd", "first.csv", {"--frame", "0"}).exit_code, 0);
  EXPECT_EQ(text("last.csv"), text("fifth.csv"));
  EXPECT_NE(text("last.csv"), text("first.csv"));
  EXPECT_EQ(convert("out/trajectory.xyz", "one.xyz", {"--frame", "0"}).exit_code, 0);
  EXPECT_TRUE(text("out/trajectory.xyz").starts_with(text("one.xyz")));
}

TEST_F(Convert, SaysThatVelocitiesAreMissing) {
  const ProgramOutcome outcome = convert("out/trajectory.xyz", "a.sph");
  EXPECT_EQ(outcome.messages, "");
  const ProgramOutcome back = convert("a.sph", "b.xyz");
  EXPECT_EQ(back.exit_code, 0);
  EXPECT_NE(back.messages.find("no velocities"), std::string::npos) << back.messages;
}

TEST_F(Convert, RefusesWhatItCannotDo) {
  const std::string before = text("out/trajectory.xyz");
  expect_refusal(convert("out/trajectory.xyz", "out/trajectory.xyz"), {"would overwrite"});
  expect_refusal(convert("out/trajectory.xyz", "a.dcd"), {"a.dcd: unknown file extension"});
  expect_refusal(convert("out/trajectory.pvd", "a.xyz"), {"cannot be read"});
  expect_refusal(convert("out/trajectory.xyz", "a.xyz", {"--frame", "6"}), {"--frame: there is no frame 6"});
  expect_refusal(convert("out/trajectory.xyz", "a.xyz", {"--frame", "last"}), {"--frame: 'last'"});
  expect_refusal(convert("missing.xyz", "a.xyz"), {"missing.xyz: the file cannot be read"});
  expect_refusal(convert("out/events.npy", "a.xyz"), {"out/events.npy: there is no column 'x'"});
  expect_refusal(convert("out/trajectory.xyz", "nowhere/a.xyz"), {"nowhere/a.xyz: cannot be written"});
  // A frame in the middle that is damaged: nothing is left.
  write_text(folder_ / "damaged.xyz", before + "1\nProperties=pos:R:3:velo:R:3:radius:R:1\n1 2 3 4 5 6 x\n");
  expect_refusal(convert("damaged.xyz", "a.gsd"), {"damaged.xyz:"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.gsd"));
  EXPECT_EQ(text("out/trajectory.xyz"), before);
}

TEST_F(Convert, ReplacesAFileOnlyIfItIsTold) {
  for (const std::string name : {"a.xyz", "a.gsd", "a.pvd"}) {
    ASSERT_EQ(convert("out/trajectory.xyz", name).exit_code, 0);
    const std::string before = text(name);
    expect_refusal(convert("out/trajectory.xyz", name, {"--frame", "0"}),
                   {name + ": the file exists already; name another file, or replace it with --overwrite"});
    EXPECT_TRUE(text(name) == before);
    EXPECT_EQ(convert("out/trajectory.xyz", name, {"--frame", "0", "--overwrite"}).exit_code, 0);
    EXPECT_FALSE(text(name) == before);
  }
  EXPECT_EQ(convert("out/trajectory.xyz", "null.xyz").exit_code, 0);
}

void expect_parts(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

TEST_F(Convert, TellsOfTheOthersWhatFilesHold) {
  write_text(folder_ / "notes.md", "mine");
  const ProgramOutcome outcome = run_program(folder_, {"info", "notes.md", "missing.hbr", "gas.toml", ".",
                                                       "out/checkpoint.hbc", "out/summary.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  expect_parts(outcome.messages, {"notes.md: unknown file extension", "missing.hbr: the file cannot be read",
                                  ".: it holds no files of a run"});
  EXPECT_EQ(std::count(outcome.messages.begin(), outcome.messages.end(), '\n'), 3);
  expect_parts(outcome.output,
               {"gas.toml: scenario, ", "  box       10 wall x 10 wall x 10 wall\n", "  until     5\n",
                "  seed      1\n", "out/checkpoint.hbc: checkpoint of gas.toml, ",
                "  contents  files, measures, run, simulation\n", "out/summary.json: summary of a run, ",
                "  scenario  gas.toml\n"});
}

TEST_F(Convert, TellsWhatADirectoryHolds) {
  const ProgramOutcome whole = run_program(folder_, {"info", "out"});
  EXPECT_EQ(whole.exit_code, 0) << whole.messages;
  expect_parts(whole.output,
               {"out: output of a run that has ended\n", "out/summary.json: ", "out/checkpoint.hbc: ",
                "out/trajectory.xyz: ", "out/trajectory.pvd: VTP collection, ",
                "out/events.npy: ", "out/recording.hbr: "});
  std::filesystem::remove(folder_ / "out/summary.json");
  std::string recording = text("out/recording.hbr");
  recording[recording.size() - 100] ^= 1;
  write_text(folder_ / "out/recording.hbr", recording);
  const ProgramOutcome damaged = run_program(folder_, {"info", "out", "gas.toml"});
  EXPECT_EQ(damaged.exit_code, 2);
  expect_parts(damaged.output,
               {"out: output of a run that has not ended\n", "out/recording.hbr: ", "gas.toml: "});
  expect_parts(damaged.messages,
               {"out/recording.hbr: the recording is damaged after time 0: chunk 0, at byte "});
}

TEST_F(Convert, TellsWhatFilesHold) {
  const ProgramOutcome outcome = run_program(
      folder_,
      {"info", "out/trajectory.gsd", "out/trajectory.lammpstrj", "out/events.npy", "out/recording.hbr"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  for (const char* fragment :
       {"out/trajectory.gsd: GSD, schema hoomd, ", "  frames    6\n", "  spheres   20\n",
        "  time      0 to 5\n", "  box       10 x 10 x 10, not periodic\n",
        "  contents  positions, radii, velocities, ids, images\n", "out/trajectory.lammpstrj: LAMMPS dump, ",
        "out/events.npy: event log, ", "out/recording.hbr: recording of gas, ", "  contacts  "}) {
    EXPECT_NE(outcome.output.find(fragment), std::string::npos) << fragment << " in\n" << outcome.output;
  }
  expect_refusal(run_program(folder_, {"info"}), {"FILE is required"});
}

}  // namespace
}  // namespace hardball::convert_test
