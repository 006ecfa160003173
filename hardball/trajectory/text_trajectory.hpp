// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include "hardball/io/output_file.hpp"
#include "hardball/trajectory/frame_writer.hpp"
#include "hardball/trajectory/sphere_types.hpp"

namespace hardball {

class ZstdCompressor;

/// Takes the next bytes of a file.
using AppendText = std::function<void(std::string_view)>;
/// How a frame is written.
struct TextFrame {
  /// Passes on what precedes the spheres of a frame, given their number and types; the spheres of `head` do
  /// not matter.
  void (*head)(const Snapshot& head, std::size_t spheres, const SphereTypes& types, std::uint64_t frame,
               const AppendText& append);
  /// Passes on the spheres of a frame, or some of them; the types are those of all.
  void (*spheres)(const Snapshot& part, const SphereTypes& types, const AppendText& append);
  bool takes_parts = true;  ///< Whether spheres may come in parts.
};

/// Passes on the bytes of a whole frame.
void append_text_frame(const TextFrame& text, const Snapshot& snapshot, std::uint64_t frame,
                       const AppendText& append);

/// A file in which frames follow each other, each in one piece, plain or compressed by zstd. Compressed
/// frames do not depend on each other, so that the file can be cut after any.
class TextTrajectory final : public FrameWriter {
 public:
  /// Creates the file, or continues from a position. Error: see OutputFile.
  TextTrajectory(std::filesystem::path path, const TextFrame& text, bool is_compressed,
                 const std::optional<TrajectoryPosition>& position = {});
  ~TextTrajectory() override;

  void append(const Snapshot& snapshot, std::uint64_t frame) override;
  void append(const FrameParts& parts, std::uint64_t frame) override;
  TrajectoryPosition position() override { return {.file = file_.position()}; }
  void close() override { file_.close(); }

 private:
  // Calls write(append) with a function that appends to the file.
  template <class Write>
  void append_frame(Write&& write);

  OutputFile file_;
  TextFrame text_;
  std::unique_ptr<ZstdCompressor> compressor_;  // if it is compressed
};

}  // namespace hardball
