// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/text_snapshot_reader.hpp"

#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball {

TextSnapshotReader::TextSnapshotReader(OpenText open, std::string name, TextFormat format)
    : open_(std::move(open)), name_(std::move(name)), format_(format) {
  Lines lines(open_(), name_, format_.comment_mark);
  try {
    for (; lines.next_text(); ++frames_) format_.skip(lines);
  } catch (const Error& error) {
    if (frames_ == 0) throw;
    ++frames_;
    damage_ = error;
  }
  if (frames_ == 0) throw Error("the file contains no frame", name_, format_.remedy);
}

Snapshot TextSnapshotReader::read(std::size_t frame) {
  HARDBALL_CHECK(frame < frames_);
  if (damage_ && frame + 1 == frames_) throw Error(*damage_);
  if (!lines_ || frame < next_) {
    lines_ = std::make_unique<Lines>(open_(), name_, format_.comment_mark);
    next_ = 0;
  }
  for (;; ++next_) {
    if (!lines_->next_text())
      throw Error("the file has become shorter", name_, "leave it alone while it is read");
    if (next_ == frame) break;
    format_.skip(*lines_);
  }
  ++next_;
  Snapshot snapshot = format_.read(*lines_);
  if (!snapshot.ids.empty()) sort_by_id(snapshot, name_);
  check_numbers(snapshot, name_);
  return snapshot;
}

}  // namespace hardball
