// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <thread>

#include "apps/viewer/live_run.hpp"
#include "apps/viewer/page.hpp"
#include "apps/viewer/shared_recording.hpp"
#include "hardball/io/crc32.hpp"
#include "hardball/platform/little_endian.hpp"
#include "hardball/recording/recording_reader.hpp"
#include "hardball/recording/recording_writer.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/gas.hpp"

/// A page and runs small enough for tests of the viewer.
namespace hardball::viewer {

inline constexpr Page kSmallPage{
    "<html><head><link rel=\"stylesheet\" href=\"page.css\"></head>"
    "<body><script src=\"page.js\"></script></body></html>",
    "body { margin: 0 }", "const tags = '</script><!--';"};

inline constexpr std::uint64_t kNoLimit = std::numeric_limits<std::int64_t>::max();

/// Writes a whole recording. Returns the hash of the run's event log.
inline std::uint64_t record(const std::filesystem::path& path, World world, double until) {
  Simulation simulation(std::move(world));
  RecordingWriter writer(path, {.until = until, .name = "gas"}, simulation.world());
  simulation.on_contact([&](const Contact& contact) { writer.record(contact, simulation.world()); });
  simulation.run_until(until);
  writer.close(until);
  return simulation.event_log_hash();
}

/// Writes a sparse recording file longer than a replay may be.
inline void make_huge_recording(const std::filesystem::path& path) {
  constexpr std::uint32_t kContacts = 2'000'000;
  record(path, support::make_gas({.count = 2, .packing_fraction = 0.01}), 0);
  const std::uint64_t chunk = RecordingReader(path).chunks().at(0).bytes.offset;
  const std::uint64_t length = recording_format::Layout().chunk_bytes(2, kContacts);
  std::string head;
  append_little_endian(head, recording_format::kChunkMagic);
  append_little_endian(head, kContacts);
  append_little_endian(head, length);
  append_little_endian(head, 0.0);
  append_little_endian(head, 0.0);
  append_little_endian(head, std::uint64_t{crc32_of(head)});
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(static_cast<std::streamoff>(chunk));
  file << head;
  file.close();
  std::filesystem::resize_file(path, chunk + length);
}

/// A live run and its recording.
class SmallRun {
 public:
  SmallRun(const std::filesystem::path& path, World world, double until, std::uint64_t most_bytes = kNoLimit)
      : SmallRun(path, Simulation(std::move(world)), until, most_bytes) {}
  SmallRun(const std::filesystem::path& path, Simulation simulation, double until, std::uint64_t most_bytes)
      : writer_(path, {.until = until, .name = "gas"}, simulation.world()),
        recording_(path),
        run_(std::move(simulation), std::move(writer_), recording_, until, most_bytes) {}

  const SharedRecording& recording() const { return recording_; }

  /// Waits for the end of the run and returns its progress.
  RunProgress finished() const {
    while (!recording_.progress().is_finished) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return recording_.progress();
  }

 private:
  RecordingWriter writer_;  // until moved into the run
  SharedRecording recording_;
  LiveRun run_;
};

}  // namespace hardball::viewer
