// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "apps/viewer/page.hpp"
#include "apps/viewer/shared_recording.hpp"

namespace hardball::viewer {

/// Longer recordings exceed what browsers allow for one string.
inline constexpr std::uint64_t kMaxReplayedBytes = 200'000'000;

/// A recording and the page that shows it in one HTML file, which needs no server and no network. It contains
/// the chunks known when it is created.
class Replay {
 public:
  /// `recording` must outlive it. Error: the recording is longer than kMaxReplayedBytes.
  Replay(const SharedRecording& recording, const Page& page);

  /// How many bytes of a recording fit into an HTML file of `most_bytes`; zero if not even the page does.
  static std::uint64_t recorded_bytes(std::uint64_t most_bytes, const Page& page);

  /// Length of the HTML file in bytes.
  std::uint64_t length() const;
  /// Some bytes of the file from `offset` on, at least one. Precondition: offset < length(). Error
  /// (RunFailure): the recording cannot be read.
  std::string piece(std::uint64_t offset) const;
  /// Writes the HTML file. Error (RunFailure): the recording cannot be read; the file cannot be written.
  void write(const std::filesystem::path& path) const;

 private:
  const SharedRecording* recording_;
  OnePiece page_;
  std::uint64_t recorded_;  // bytes of the recording
};

}  // namespace hardball::viewer
