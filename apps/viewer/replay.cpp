// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/viewer/replay.hpp"

#include <algorithm>

#include "hardball/errors/error.hpp"
#include "hardball/io/output_file.hpp"

namespace hardball::viewer {
namespace {

// Source: RFC 4648, section 4. Three bytes are four characters.
std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t begin = 0; begin < bytes.size(); begin += 3) {
    const std::size_t there = std::min<std::size_t>(bytes.size() - begin, 3);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (k < there ? static_cast<unsigned char>(bytes[begin + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) text += k <= there ? kDigits[(bits >> (18 - 6 * k)) & 0x3f] : '=';
  }
  return text;
}

}  // namespace

Replay::Replay(const SharedRecording& recording, const Page& page)
    : recording_(&recording), page_(page), recorded_(recording.length()) {
  if (recorded_ <= kMaxReplayedBytes) return;
  throw Error("the recording has " + to_text(recorded_) + " bytes, and a replay holds at most " +
                  to_text(kMaxReplayedBytes),
              "replay of " + recording.header().name, "end the run earlier or use fewer spheres");
}

std::uint64_t Replay::recorded_bytes(std::uint64_t most_bytes, const Page& page) {
  const OnePiece one(page);
  const std::uint64_t other = one.head.size() + one.tail.size();
  return other < most_bytes ? (most_bytes - other) / 4 * 3 : 0;
}

std::uint64_t Replay::length() const {
  return page_.head.size() + (recorded_ + 2) / 3 * 4 + page_.tail.size();
}

std::string Replay::piece(std::uint64_t offset) const {
  constexpr std::uint64_t kPieceBytes = 3 << 14;
  if (offset < page_.head.size()) return page_.head.substr(offset);
  const std::uint64_t character = offset - page_.head.size();
  const std::uint64_t byte = character / 4 * 3;
  if (byte < recorded_) {
    return base64(recording_->read({byte, std::min(kPieceBytes, recorded_ - byte)})).substr(character % 4);
  }
  return page_.tail.substr(character - (recorded_ + 2) / 3 * 4);
}

void Replay::write(const std::filesystem::path& path) const {
  OutputFile file(path);
  for (std::uint64_t offset = 0; offset < length();) {
    const std::string some = piece(offset);
    file.append(some);
    offset += some.size();
  }
  file.close();
}

}  // namespace hardball::viewer
