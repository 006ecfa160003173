// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/viewer/live_run.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/viewer/recorded_progress.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/measure/event_log_hash.hpp"
#include "support/scratch_folder.hpp"
#include "unit/viewer/small_run.hpp"

namespace hardball::viewer::live_run_test {
namespace {

using namespace support;

const World kGas = make_gas({.count = 100, .packing_fraction = 0.2, .boundary = Boundary::wall});

TEST(LiveRun, HasTheSameHistoryAsAnUnrecordedRun) {
  const ScratchFolder folder;
  Simulation alone(kGas);
  alone.run_until(20);
  const SmallRun run(folder / "live.hbr", kGas, 20);
  const RunProgress progress = run.finished();
  EXPECT_EQ(progress.failure, std::nullopt);
  EXPECT_EQ(progress.hash, alone.event_log_hash());
  EXPECT_EQ(progress.collisions, alone.counters().collision);
  EXPECT_EQ(progress.walls, alone.counters().wall);
  const nlohmann::json status = nlohmann::json::parse(run.recording().status_json(0));
  EXPECT_EQ(status["reached"], 20);
  EXPECT_EQ(status["chunk_ends"].size(), status["chunks"]);
}

// Only the times at which chunks were closed may differ.
TEST(LiveRun, RecordsWhatAnyOtherRunRecords) {
  const ScratchFolder folder;
  record(folder / "plain.hbr", kGas, 20);
  { SmallRun(folder / "live.hbr", kGas, 20).finished(); }
  const auto contacts_in = [](const std::filesystem::path& path) {
    std::vector<RecordedContact> contacts;
    RecordingReader reader(path);
    for (std::size_t k = 0; k < reader.chunks().size(); ++k) {
      const RecordedChunk chunk = reader.read(k);
      contacts.insert(contacts.end(), chunk.contacts.begin(), chunk.contacts.end());
    }
    return contacts;
  };
  EXPECT_TRUE(contacts_in(folder / "live.hbr") == contacts_in(folder / "plain.hbr"));
}

// The status after the end of a run.
nlohmann::json final_status(const ScratchFolder& folder, Simulation simulation) {
  const SmallRun run(folder / "live.hbr", std::move(simulation), 20, kNoLimit);
  EXPECT_EQ(run.finished().failure, std::nullopt);
  return nlohmann::json::parse(run.recording().status_json(0));
}

TEST(LiveRun, TellsHowItsDomainsDivideTheBox) {
  const ScratchFolder folder;
  Simulation alone(kGas);
  alone.run_until(20);
  const nlohmann::json status =
      final_status(folder, Simulation(kGas, {.division = Division{.domains = 2, .threads = 2}}));
  EXPECT_EQ(status["event_log_hash"], hash_text(alone.event_log_hash()));
  ASSERT_GE(status["divisions"].size(), 1U);
  EXPECT_EQ(status["divisions"][0]["from"], 0);
  double from = 0;
  for (const nlohmann::json& division : status["divisions"]) {
    EXPECT_GE(division["from"], from);
    from = division["from"];
    ASSERT_EQ(division["blocks"].size(), 2U);
    // Walls are no ends, and the cut is one for both.
    int cuts = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_TRUE(division["blocks"][0]["low"][axis].is_null());
      EXPECT_TRUE(division["blocks"][1]["high"][axis].is_null());
      EXPECT_EQ(division["blocks"][0]["high"][axis], division["blocks"][1]["low"][axis]);
      cuts += division["blocks"][0]["high"][axis].is_number() ? 1 : 0;
    }
    EXPECT_EQ(cuts, 1);
  }
  EXPECT_GT(status["windows"]["committed"], 0);
  EXPECT_LE(status["windows"]["steps"], status["windows"]["committed"]);
}

TEST(LiveRun, OfOneThreadHasOneBlockAndNoWindows) {
  const ScratchFolder folder;
  const nlohmann::json status = final_status(folder, Simulation(kGas));
  ASSERT_EQ(status["divisions"].size(), 1U);
  EXPECT_EQ(status["divisions"][0]["blocks"].size(), 1U);
  EXPECT_EQ(status["windows"], nlohmann::json::parse(R"({"committed": 0, "failed": 0, "steps": 0})"));
}

TEST(LiveRun, EndsWhenItIsDestroyed) {
  const ScratchFolder folder;
  { const SmallRun run(folder / "live.hbr", kGas, 1e9); }
  const RecordingReader reader(folder / "live.hbr");
  EXPECT_LT(reader.reached(), 1e9);
  EXPECT_EQ(reader.length(), std::filesystem::file_size(folder / "live.hbr"));
}

TEST(LiveRun, KeepsToTheLimitOfItsRecording) {
  const ScratchFolder folder;
  constexpr std::uint64_t kLimit = 12'000'000;
  const SmallRun run(folder / "live.hbr", kGas, 1e9, kLimit);
  const RunProgress progress = run.finished();
  ASSERT_TRUE(progress.failure);
  EXPECT_NE(progress.failure->find("limit of 12000000 bytes"), std::string::npos) << *progress.failure;
  EXPECT_LE(std::filesystem::file_size(folder / "live.hbr"), kLimit);
  EXPECT_GE(std::filesystem::file_size(folder / "live.hbr"), kLimit / 2);
  EXPECT_EQ(run.recording().length(), std::filesystem::file_size(folder / "live.hbr"));
}

TEST(LiveRun, ReportsWhyItFailed) {
  const ScratchFolder folder;
  Simulation simulation(kGas);
  RecordingWriter writer(folder / "live.hbr", {}, simulation.world());
  simulation.respond_with([](const Contact& contact) -> Velocities {
    if (contact.time.value() > 1) throw RunFailure("nothing lasts for ever");
    return Restitution(1)(contact);
  });
  SharedRecording recording(folder / "live.hbr");
  const LiveRun run(std::move(simulation), std::move(writer), recording, 20, kNoLimit);
  while (!recording.progress().is_finished) std::this_thread::yield();
  ASSERT_TRUE(recording.progress().failure);
  EXPECT_TRUE(recording.progress().failure->starts_with("nothing lasts for ever; the run reached time "));
  const RecordingReader reader(folder / "live.hbr");
  EXPECT_GT(reader.reached(), 0.9);
  EXPECT_LE(reader.reached(), 1);
}

TEST(RecordedProgress, OfADamagedRecordingIsThatBeforeTheDamage) {
  const ScratchFolder folder;
  record(folder / "recording.hbr", kGas, 5);
  RecordingReader whole(folder / "recording.hbr");
  ASSERT_GT(whole.chunks().size(), 2U);
  const ChunkExtent second = whole.chunks()[1];
  std::uint64_t contacts = 0;
  for (const RecordedContact& contact : whole.read(0).contacts) contacts += contact.is_collision() ? 1U : 0U;
  std::string bytes = read_text(folder / "recording.hbr");
  bytes[second.bytes.offset + second.bytes.length / 2] ^= 1;
  write_text(folder / "recording.hbr", bytes);
  EXPECT_THROW(SharedRecording(folder / "recording.hbr").verify({}), Error);
  SharedRecording recording(folder / "recording.hbr", OnDamage::keep_what_comes_before);
  recording.update(recorded_progress(recording, folder / "summary.json"));
  EXPECT_EQ(recording.progress().collisions, contacts);
  EXPECT_EQ(recording.length(), second.bytes.offset);
  EXPECT_FALSE(recording.chunk(1));
  const auto status = nlohmann::json::parse(recording.status_json(0));
  EXPECT_EQ(status["chunks"], 1);
  EXPECT_EQ(status["reached"], second.begin);
  EXPECT_TRUE(status["failed"].is_null());
  EXPECT_EQ(status["damaged"], "the recording is damaged after time " + to_text(second.begin) +
                                   ": chunk 1, at byte " + to_text(second.bytes.offset) +
                                   ", does not match its checksum; the part before is shown");
}

TEST(RecordedProgress, IsThatOfTheRunAndItsSummary) {
  const ScratchFolder folder;
  Simulation alone(kGas);
  alone.run_until(5);
  record(folder / "recording.hbr", kGas, 5);
  SharedRecording recording(folder / "recording.hbr");
  const auto progress = [&] { return recorded_progress(recording, folder / "summary.json"); };
  EXPECT_TRUE(progress().is_finished);
  EXPECT_EQ(progress().collisions, alone.counters().collision);
  EXPECT_EQ(progress().walls, alone.counters().wall);
  EXPECT_EQ(progress().hash, std::nullopt);
  EXPECT_EQ(progress().rate, 0);
  write_text(folder / "summary.json",
             R"({"event_log_hash": "00000000000000ff", "seconds": {"setup": 1, "run": 0.5}})");
  EXPECT_EQ(progress().hash, 255U);
  EXPECT_EQ(progress().rate, 2.0 * static_cast<double>(alone.counters().contacts()));
  for (const std::string nonsense : {"", "{", "[]", "{\"event_log_hash\": 7, \"seconds\": []}",
                                     "{\"event_log_hash\": \"xyz\", \"seconds\": {\"run\": \"long\"}}"}) {
    write_text(folder / "summary.json", nonsense);
    EXPECT_EQ(progress().hash, std::nullopt) << nonsense;
    EXPECT_EQ(progress().rate, 0) << nonsense;
  }
}

}  // namespace
}  // namespace hardball::viewer::live_run_test
