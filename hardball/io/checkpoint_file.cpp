// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/checkpoint_file.hpp"

#include <xxhash.h>
#include <zstd.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/io/little_endian.hpp"
#include "hardball/io/read_file.hpp"
#include "hardball/io/replace_file.hpp"

namespace hardball {
namespace {

constexpr std::string_view kMagic = "HBCHECK1";
constexpr std::uint32_t kStored = 0;
constexpr std::uint32_t kZstd = 1;
// More is not believed of a section: a small file must not claim all memory.
constexpr std::uint64_t kMaxCompression = 256;

struct Packed {
  std::uint32_t method;
  std::string bytes;
};

// Appends a frame that readers skip, so that there are this many bytes.
void pad(std::string& frames, std::size_t bytes) {
  constexpr std::uint32_t kSkippable = ZSTD_MAGIC_SKIPPABLE_START;
  constexpr std::size_t kHeader = 8;
  const std::size_t padding = bytes > frames.size() + kHeader ? bytes - frames.size() - kHeader : 0;
  append_little_endian(frames, kSkippable);
  append_little_endian(frames, static_cast<std::uint32_t>(padding));
  frames.append(padding, '\0');
}

Packed packed(const std::string& bytes) {
  // Levels above 1 take longer than the disk gains.
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t length = ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 1);
  if (ZSTD_isError(length) != 0 || length >= bytes.size()) return {kStored, bytes};
  packed.resize(length);
  if (length * kMaxCompression < bytes.size()) pad(packed, bytes.size() / kMaxCompression + 1);
  return {kZstd, std::move(packed)};
}

[[noreturn]] void refuse(const std::string& what, const std::string& where) {
  throw Error(what, where, "use an undamaged copy, or start the run again");
}

// The parts of a file, one after the other.
class Parts {
 public:
  Parts(std::string_view file, const std::string& where) : file_(file), where_(where) {}

  std::string_view take(std::uint64_t length) {
    if (length > file_.size() - at_) refuse("ends too early", where_);
    const std::string_view part = file_.substr(at_, length);
    at_ += length;
    return part;
  }
  template <class Number>
  Number number() {
    return read_little_endian<Number>(take(sizeof(Number)).data());
  }
  std::size_t at() const { return at_; }
  bool is_end() const { return at_ == file_.size(); }

 private:
  std::string_view file_;
  const std::string& where_;
  std::size_t at_ = 0;
};

struct Entry {
  std::string name;
  std::uint32_t method = kStored;
  std::uint64_t length = 0;
  std::uint64_t packed = 0;
  std::uint64_t checksum = 0;
};

std::string unpacked(const Entry& entry, std::string_view bytes, const std::string& where) {
  const std::string section = "section '" + entry.name + "' ";
  if (XXH64(bytes.data(), bytes.size(), 0) != entry.checksum) refuse(section + "is damaged", where);
  if (entry.method == kStored && entry.length == entry.packed) return std::string(bytes);
  if (entry.method != kZstd || entry.length / kMaxCompression > entry.packed) {
    refuse(section + "is compressed in an unknown way", where);
  }
  std::string whole(entry.length, '\0');
  const std::size_t length = ZSTD_decompress(whole.data(), whole.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(length) != 0 || length != whole.size()) refuse(section + "is damaged", where);
  return whole;
}

}  // namespace

std::string checkpoint_of(std::span<const CheckpointSection> sections) {
  std::string file(kMagic);
  append_little_endian(file, static_cast<std::uint32_t>(sections.size()));
  std::vector<Packed> contents;
  for (const CheckpointSection& section : sections) {
    const Packed& content = contents.emplace_back(packed(section.bytes));
    append_little_endian(file, static_cast<std::uint32_t>(section.name.size()));
    file += section.name;
    append_little_endian(file, content.method);
    append_little_endian(file, std::uint64_t{section.bytes.size()});
    append_little_endian(file, std::uint64_t{content.bytes.size()});
    append_little_endian(file, std::uint64_t{XXH64(content.bytes.data(), content.bytes.size(), 0)});
  }
  append_little_endian(file, std::uint64_t{XXH64(file.data(), file.size(), 0)});
  for (const Packed& content : contents) file += content.bytes;
  return file;
}

void write_checkpoint_file(const std::filesystem::path& path, std::span<const CheckpointSection> sections) {
  replace_file(path, checkpoint_of(sections));
}

std::map<std::string, std::string> read_checkpoint(std::string_view file, const std::string& where) {
  Parts parts(file, where);
  if (file.size() < kMagic.size() || parts.take(kMagic.size()) != kMagic) {
    refuse("is not a checkpoint", where);
  }
  std::vector<Entry> entries;
  for (auto left = parts.number<std::uint32_t>(); left > 0; --left) {
    Entry& entry = entries.emplace_back();
    entry.name = parts.take(parts.number<std::uint32_t>());
    entry.method = parts.number<std::uint32_t>();
    entry.length = parts.number<std::uint64_t>();
    entry.packed = parts.number<std::uint64_t>();
    entry.checksum = parts.number<std::uint64_t>();
  }
  const std::uint64_t checksum = XXH64(file.data(), parts.at(), 0);
  if (parts.number<std::uint64_t>() != checksum) refuse("the table of sections is damaged", where);
  std::map<std::string, std::string> sections;
  for (const Entry& entry : entries) {
    sections[entry.name] = unpacked(entry, parts.take(entry.packed), where);
  }
  if (!parts.is_end()) refuse("continues after its end", where);
  return sections;
}

std::map<std::string, std::string> read_checkpoint_file(const std::filesystem::path& path) {
  return read_checkpoint(read_file(path), path.string());
}

}  // namespace hardball
