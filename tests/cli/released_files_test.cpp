// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Files of earlier releases are read, and runs that were saved by them end as they would have ended then.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "hardball/recording/recording_reader.hpp"

namespace hardball::released_files_test {
namespace {

using nlohmann::json;
using support::ProgramOutcome;
using support::run_program;

const std::filesystem::path kReleases = HARDBALL_TEST_SUPPORT "/released";

// A run that ended at time 1, in a folder of its release.
struct Saved {
  const char* folder;
  const char* hash;  // of the event log up to time 2, according to that release
  bool has_recording = true;
};

class ReleasedRun : public testing::TestWithParam<Saved> {};

TEST_P(ReleasedRun, IsResumed) {
  const support::ScratchFolder folder;
  std::filesystem::copy(kReleases / GetParam().folder, folder / "run",
                        std::filesystem::copy_options::recursive);
  const ProgramOutcome outcome = run_program(folder, {"resume", "run", "--until", "2", "--json", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.messages;
  EXPECT_EQ(json::parse(outcome.output)["event_log_hash"], GetParam().hash);
  if (!GetParam().has_recording) return;
  // What was appended to the recording belongs to what was in it.
  RecordingReader reader(folder / "run/recording.hbr");
  std::uint64_t contacts = 0;
  double end = 0;
  for (std::size_t k = 0; k < reader.chunks().size(); ++k) {
    const RecordedChunk chunk = reader.read(k);
    EXPECT_EQ(chunk.begin, end) << k;
    end = chunk.end;
    // Changes by a thermostat and epochs of growth are entries, too.
    contacts +=
        static_cast<std::uint64_t>(std::ranges::count_if(chunk.contacts, [](const RecordedContact& contact) {
          return !contact.is_epoch() && contact.second != static_cast<std::int64_t>(contact.first);
        }));
  }
  EXPECT_EQ(end, 2);
  const json events = json::parse(outcome.output)["events"];
  EXPECT_EQ(events["collision"].get<std::uint64_t>() + events["wall"].get<std::uint64_t>(), contacts);
}

INSTANTIATE_TEST_SUITE_P(Released, ReleasedRun,
                         testing::Values(Saved{"0.2.0/gas", "4704b1584a71a428"},
                                         Saved{"0.2.0/cylinder", "6063274e25713229"},
                                         Saved{"0.2.0/growing", "c8c0a95fd51d1154"},
                                         Saved{"0.2.0/wells", "184353f97fed27df", false},
                                         Saved{"0.2.0/sheared", "4b72d35bb0eb0d58"}),
                         [](const testing::TestParamInfo<Saved>& saved) {
                           const std::string folder = saved.param.folder;
                           return folder.substr(folder.find('/') + 1);
                         });

// That release did not sum the torque.
TEST(ReleasedRunInATube, DoesNotKnowItsTorque) {
  const support::ScratchFolder folder;
  std::filesystem::copy(kReleases / "0.2.0/cylinder", folder / "run",
                        std::filesystem::copy_options::recursive);
  const ProgramOutcome outcome = run_program(folder, {"resume", "run", "--until", "2", "--json", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.messages;
  const json tube = json::parse(outcome.output)["walls"].back();
  EXPECT_GT(tube["contacts"], 0);
  for (const json& component : tube["torque"]) EXPECT_TRUE(component.is_null());
}

TEST(ReleasedPacking, IsResumed) {
  const support::ScratchFolder folder;
  // A checkpoint is removed when its packing is finished.
  std::filesystem::copy(kReleases / "0.2.0/packing.hbc", folder / "packing.hbc");
  const ProgramOutcome outcome =
      run_program(folder, {"pack", "--resume", "packing.hbc", "--out", "spheres.xyz", "--json", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.messages;
  const json summary = json::parse(outcome.output);
  EXPECT_EQ(summary["status"], "reached");
  EXPECT_EQ(summary["collisions"], 1831);
}

}  // namespace
}  // namespace hardball::released_files_test
