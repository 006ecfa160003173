// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <xxhash.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/target.hpp"
#include "hardball/io/checkpoint_file.hpp"
#include "hardball/platform/little_endian.hpp"

namespace hardball::fuzz {
namespace {

void overwrite(std::string& bytes, std::size_t at, std::uint64_t number) {
  std::string text;
  append_little_endian(text, number);
  bytes.replace(at, text.size(), text);
}

// The bytes with true checksums, as far as the table of sections goes: a fuzzer would never guess one.
std::string with_checksums(std::string_view bytes) {
  constexpr std::size_t kBegin = 12;
  constexpr std::size_t kBehindName = 28;  // method, two lengths, checksum
  constexpr std::size_t kSum = 8;
  std::string sound(bytes);
  if (sound.size() < kBegin) return sound;
  struct Section {
    std::size_t sum;
    std::uint64_t length;
  };
  std::vector<Section> sections;
  std::size_t at = kBegin;
  for (auto left = read_little_endian<std::uint32_t>(&sound[8]); left > 0; --left) {
    if (sound.size() - at < 4) return sound;
    const std::size_t name = read_little_endian<std::uint32_t>(&sound[at]);
    at += 4;
    if (sound.size() - at < name + kBehindName) return sound;
    at += name + kBehindName;
    sections.push_back({at - kSum, read_little_endian<std::uint64_t>(&sound[at - 2 * kSum])});
  }
  if (sound.size() - at < kSum) return sound;
  std::size_t content = at + kSum;
  for (const Section& section : sections) {
    const std::size_t length = std::min<std::uint64_t>(section.length, sound.size() - content);
    overwrite(sound, section.sum, XXH64(&sound[content], length, 0));
    content += length;
  }
  overwrite(sound, at, XXH64(sound.data(), at, 0));
  return sound;
}

}  // namespace
}  // namespace hardball::fuzz

void hardball::fuzz::read(std::string_view bytes) {
  read_checkpoint(with_checksums(bytes), "checkpoint.hbc");
}
