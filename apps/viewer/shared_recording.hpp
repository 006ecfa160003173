// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "hardball/engine/window_counters.hpp"
#include "hardball/platform/files.hpp"
#include "hardball/recording/recording_reader.hpp"
#include "hardball/world/block.hpp"

namespace hardball::viewer {

/// Blocks into which a run divides the box, from a time on; see Simulation::blocks.
struct TimedBlocks {
  double from = 0;  ///< [T]
  std::vector<Block> blocks;
};

/// The progress of the run of a recording.
struct RunProgress {
  bool is_finished = false;                ///< The run has ended.
  std::optional<std::string> failure;      ///< Why it ended early.
  std::optional<std::string> damage = {};  ///< Why the recording ends early, if it is damaged.
  std::uint64_t collisions = 0;            ///< Collisions of spheres that did not pass through each other.
  std::uint64_t mergers = 0;               ///< Collisions after which two spheres were one.
  std::uint64_t walls = 0;
  double rate = 0;                          ///< Contacts per second of wall-clock time.
  std::optional<std::uint64_t> hash;        ///< Hash of the event log.
  std::vector<TimedBlocks> divisions = {};  ///< Blocks of domains in a live run, in the order of times.
  WindowCounters windows = {};
};

/// A recording for many concurrent readers, which may grow meanwhile.
///
/// Every member may be called from any thread. A lock is held only while a few numbers are copied, never
/// while the file is read for a client, so that no client holds up the run.
class SharedRecording {
 public:
  /// Error: see RecordingReader.
  explicit SharedRecording(const std::filesystem::path& path, OnDamage on_damage = OnDamage::refuse);

  /// See RecordingReader::verify.
  void verify(const std::function<void(const RecordedChunk&)>& take);
  /// See RecordingReader::damage.
  std::optional<std::string> damage() const;

  /// Finds added chunks, and sets the progress of the run. Error: see RecordingReader::refresh.
  void update(RunProgress progress);

  RunProgress progress() const;
  const RecordingHeader& header() const { return reader_.header(); }
  /// The recording's header as in the file: one JSON object.
  const std::string& header_text() const { return reader_.header_text(); }
  /// The recording's header and the number of chunks: one JSON object.
  std::string header_json() const;
  /// The progress of the run, and the end times of the chunks from number `from` on: one JSON object.
  std::string status_json(std::uint64_t from) const;

  /// The part of the file that holds radii and masses.
  FileExtent spheres() const { return reader_.spheres(); }
  /// The part of the file that holds a chunk; none if it is not there yet.
  std::optional<FileExtent> chunk(std::uint64_t number) const;
  /// What a chunk contains. Error: see RecordingReader::read.
  RecordedChunk contents(std::uint64_t number) const;
  /// Length of the recording up to its last complete chunk.
  std::uint64_t length() const;

  /// Up to where it is known [T].
  double reached() const;

  /// Bytes of the file. Error (RunFailure): they cannot be read.
  std::string read(const FileExtent& extent) const;

 private:
  mutable RecordingReader reader_;  // which reads chunks by moving its place in the file
  platform::File file_;             // for reading at any offset without a lock
  mutable std::mutex mutex_;
  RunProgress progress_;
};

}  // namespace hardball::viewer
