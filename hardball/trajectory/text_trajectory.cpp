// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/text_trajectory.hpp"

#include <utility>

#include "hardball/io/zstd.hpp"

namespace hardball {

void append_text_frame(const TextFrame& text, const Snapshot& snapshot, std::uint64_t frame,
                       const AppendText& append) {
  const SphereTypes types(snapshot.spheres);
  text.head(snapshot, snapshot.spheres.size(), types, frame, append);
  text.spheres(snapshot, types, append);
}

TextTrajectory::TextTrajectory(std::filesystem::path path, const TextFrame& text, bool is_compressed,
                               const std::optional<TrajectoryPosition>& position)
    : file_(position ? OutputFile(std::move(path), position->file) : OutputFile(std::move(path))),
      text_(text),
      compressor_(is_compressed ? std::make_unique<ZstdCompressor>() : nullptr) {}

TextTrajectory::~TextTrajectory() = default;

void TextTrajectory::append(const Snapshot& snapshot, std::uint64_t frame) {
  append_frame([&](const AppendText& append) { append_text_frame(text_, snapshot, frame, append); });
}

void TextTrajectory::append(const FrameParts& parts, std::uint64_t frame) {
  if (!text_.takes_parts) return FrameWriter::append(parts, frame);
  append_frame([&](const AppendText& append) {
    text_.head(parts.head, parts.spheres, parts.types, frame, append);
    while (const std::optional<Snapshot> part = parts.next()) text_.spheres(*part, parts.types, append);
  });
}

template <class Write>
void TextTrajectory::append_frame(Write&& write) {
  const AppendText to_file = [&](std::string_view text) { file_.append(text); };
  if (!compressor_) {
    write(to_file);
  } else {
    write([&](std::string_view text) { compressor_->append(text, to_file); });
    compressor_->end(to_file);
  }
  file_.flush_complete();
}

}  // namespace hardball
