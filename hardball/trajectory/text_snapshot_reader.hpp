// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/trajectory/snapshot.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"
#include "hardball/trajectory/text_lines.hpp"

namespace hardball {

/// How the frames of a text follow each other. Both functions find the first line of a frame already read,
/// and leave its last one.
struct TextFormat {
  void (*skip)(Lines& lines);
  Snapshot (*read)(Lines& lines);
  const char* remedy;        ///< For a file without frames: what to give.
  char comment_mark = '\0';  ///< What lines begin with that are passed over; zero if there are none.
};

/// Reads the frames of a text. A frame at which the text ends, or where another cannot be found, is the last.
class TextSnapshotReader final : public SnapshotReader {
 public:
  /// Counts the frames. Error, with its place: there are none, or the first is incomplete. An error in a
  /// later one is that of reading it.
  TextSnapshotReader(OpenText open, std::string name, TextFormat format);

  std::size_t frames() const override { return frames_; }
  Snapshot read(std::size_t frame) override;

 private:
  OpenText open_;
  std::string name_;
  TextFormat format_;
  std::size_t frames_ = 0;
  std::optional<Error> damage_;   // of the last frame
  std::unique_ptr<Lines> lines_;  // before frame next_
  std::size_t next_ = 0;
};

}  // namespace hardball
