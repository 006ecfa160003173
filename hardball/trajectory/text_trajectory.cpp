// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/text_trajectory.hpp"

#include <utility>

#include "hardball/io/zstd.hpp"

namespace hardball {

TextTrajectory::TextTrajectory(std::filesystem::path path, AppendFrame append_frame, bool is_compressed,
                               const std::optional<TrajectoryPosition>& position)
    : file_(position ? OutputFile(std::move(path), position->file) : OutputFile(std::move(path))),
      append_frame_(append_frame),
      compressor_(is_compressed ? std::make_unique<ZstdCompressor>() : nullptr) {}

TextTrajectory::~TextTrajectory() = default;

void TextTrajectory::append(const Snapshot& snapshot, std::uint64_t frame) {
  const AppendText to_file = [&](std::string_view text) { file_.append(text); };
  if (!compressor_) {
    append_frame_(snapshot, frame, to_file);
  } else {
    append_frame_(snapshot, frame, [&](std::string_view text) { compressor_->append(text, to_file); });
    compressor_->end(to_file);
  }
  file_.flush_complete();
}

}  // namespace hardball
