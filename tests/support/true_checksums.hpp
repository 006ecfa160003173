// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/io/crc32.hpp"
#include "hardball/platform/little_endian.hpp"
#include "hardball/recording/recording.hpp"

namespace hardball::support {

/// A changed recording with the checksums that its bytes ask for, as far as it can be followed: what a reader
/// makes of values that no checksum tells from sound ones.
inline std::string with_true_checksums(std::string bytes) {
  using namespace recording_format;
  const std::uint64_t text_begin = kMagicBytes + kLengthBytes;
  const bool is_recording = bytes.starts_with(kMagicWithGrowth) || bytes.starts_with(kMagicWithoutGrowth);
  if (!is_recording || bytes.size() < text_begin) return bytes;
  const std::uint64_t text_bytes = read_little_endian<std::uint32_t>(&bytes[kMagicBytes]);
  RecordingHeader header;
  try {
    header = parse_recording_header(bytes.substr(text_begin, text_bytes), "test");
  } catch (const Error&) {
    return bytes;
  }
  const Layout layout = header.layout();
  // Whether there is room for a checksum of the bytes before `end`.
  const auto seal = [&](std::uint64_t begin, std::uint64_t end) {
    if (end > bytes.size() || bytes.size() - end < Layout::kChecksumBytes) return false;
    std::string checksum;
    append_little_endian(checksum,
                         std::uint64_t{crc32_of(std::string_view(bytes).substr(begin, end - begin))});
    bytes.replace(end, checksum.size(), checksum);
    return true;
  };
  std::uint64_t at = text_begin + text_bytes + kSphereBytes * header.spheres;
  for (std::uint64_t begin = 0; seal(begin, at);) {
    begin = at + Layout::kChecksumBytes;
    if (!seal(begin, begin + Layout::kHeadBytes)) break;
    const std::uint64_t contacts = read_little_endian<std::uint32_t>(&bytes[begin + 4]);
    at = begin + layout.chunk_bytes(header.spheres, contacts) - Layout::kChecksumBytes;
    begin += Layout::kSummedHeadBytes;
  }
  return bytes;
}

}  // namespace hardball::support
