// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include "hardball/io/output_file.hpp"
#include "hardball/trajectory/frame_writer.hpp"

namespace hardball {

class ZstdCompressor;

/// Takes the next bytes of a file.
using AppendText = std::function<void(std::string_view)>;
/// Passes on the bytes of a frame.
using AppendFrame = void (*)(const Snapshot& snapshot, std::uint64_t frame, const AppendText& append);

/// A file in which frames follow each other, each in one piece, plain or compressed by zstd. Compressed
/// frames do not depend on each other, so that the file can be cut after any.
class TextTrajectory final : public FrameWriter {
 public:
  /// Creates the file, or continues from a position. Error: see OutputFile.
  TextTrajectory(std::filesystem::path path, AppendFrame append_frame, bool is_compressed,
                 const std::optional<TrajectoryPosition>& position = {});
  ~TextTrajectory() override;

  void append(const Snapshot& snapshot, std::uint64_t frame) override;
  TrajectoryPosition position() override { return {.file = file_.position()}; }
  void close() override { file_.close(); }

 private:
  OutputFile file_;
  AppendFrame append_frame_;
  std::unique_ptr<ZstdCompressor> compressor_;  // if it is compressed
};

}  // namespace hardball
