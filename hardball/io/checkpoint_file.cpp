// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/checkpoint_file.hpp"

#include <xxhash.h>
#include <zstd.h>

#include <algorithm>
#include <cstdint>
#include <system_error>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/io/read_file.hpp"
#include "hardball/io/replace_file.hpp"
#include "hardball/platform/little_endian.hpp"

namespace hardball {
namespace {

constexpr std::string_view kMagic = "HBCHECK1";
constexpr std::uint32_t kStored = 0;
constexpr std::uint32_t kZstd = 1;
// More is not believed of a section: a small file must not claim all memory.
constexpr std::uint64_t kMaxCompression = 256;

// Appends a frame that readers skip, so that there are this many bytes.
void pad(std::string& frames, std::size_t bytes) {
  constexpr std::uint32_t kSkippable = ZSTD_MAGIC_SKIPPABLE_START;
  constexpr std::size_t kHeader = 8;
  const std::size_t padding = bytes > frames.size() + kHeader ? bytes - frames.size() - kHeader : 0;
  append_little_endian(frames, kSkippable);
  append_little_endian(frames, static_cast<std::uint32_t>(padding));
  frames.append(padding, '\0');
}

[[noreturn]] void refuse_checkpoint(const std::string& what, const std::string& where) {
  throw Error(what, where, "use an undamaged copy, or start the run again");
}

// The parts of a file, one after the other.
class Parts {
 public:
  Parts(std::string_view file, const std::string& where) : file_(file), where_(where) {}

  std::string_view take(std::uint64_t length) {
    if (length > file_.size() - at_) refuse_checkpoint("ends too early", where_);
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

// What stands before the sections.
std::vector<SectionEntry> read_head(Parts& parts, std::string_view file, const std::string& where) {
  if (file.size() < kMagic.size() || parts.take(kMagic.size()) != kMagic) {
    refuse_checkpoint("is not a checkpoint", where);
  }
  std::vector<SectionEntry> entries;
  for (auto left = parts.number<std::uint32_t>(); left > 0; --left) {
    SectionEntry& entry = entries.emplace_back();
    entry.name = parts.take(parts.number<std::uint32_t>());
    entry.method = parts.number<std::uint32_t>();
    entry.length = parts.number<std::uint64_t>();
    entry.packed = parts.number<std::uint64_t>();
    entry.checksum = parts.number<std::uint64_t>();
  }
  const std::uint64_t checksum = XXH64(file.data(), parts.at(), 0);
  if (parts.number<std::uint64_t>() != checksum) refuse_checkpoint("the table of sections is damaged", where);
  return entries;
}

std::string unpacked(const SectionEntry& entry, std::string_view bytes, const std::string& where) {
  const std::string section = "section '" + shortened(entry.name) + "' ";
  if (XXH64(bytes.data(), bytes.size(), 0) != entry.checksum)
    refuse_checkpoint(section + "is damaged", where);
  if (entry.method == kStored && entry.length == entry.packed) return std::string(bytes);
  if (entry.method != kZstd || entry.length / kMaxCompression > entry.packed) {
    refuse_checkpoint(section + "is compressed in an unknown way", where);
  }
  std::string whole(entry.length, '\0');
  const std::size_t length = ZSTD_decompress(whole.data(), whole.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(length) != 0 || length != whole.size()) refuse_checkpoint(section + "is damaged", where);
  return whole;
}

}  // namespace

PackedSection pack(const CheckpointSection& section) {
  // Levels above 1 take longer than the disk gains.
  const std::string& bytes = section.bytes;
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t length = ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 1);
  const bool is_worth_it = ZSTD_isError(length) == 0 && length < bytes.size();
  if (is_worth_it) {
    packed.resize(length);
    if (length * kMaxCompression < bytes.size()) pad(packed, bytes.size() / kMaxCompression + 1);
  } else {
    packed = bytes;
  }
  const SectionEntry entry{section.name, is_worth_it ? kZstd : kStored, bytes.size(), packed.size(),
                           XXH64(packed.data(), packed.size(), 0)};
  return {entry, std::move(packed)};
}

std::string checkpoint_head(std::span<const SectionEntry> entries) {
  std::string head(kMagic);
  append_little_endian(head, static_cast<std::uint32_t>(entries.size()));
  for (const SectionEntry& entry : entries) {
    append_little_endian(head, static_cast<std::uint32_t>(entry.name.size()));
    head += entry.name;
    append_little_endian(head, entry.method);
    append_little_endian(head, entry.length);
    append_little_endian(head, entry.packed);
    append_little_endian(head, entry.checksum);
  }
  append_little_endian(head, std::uint64_t{XXH64(head.data(), head.size(), 0)});
  return head;
}

std::string checkpoint_of(std::span<const CheckpointSection> sections) {
  std::vector<SectionEntry> entries;
  std::string contents;
  for (const CheckpointSection& section : sections) {
    const PackedSection packed = pack(section);
    entries.push_back(packed.entry);
    contents += packed.bytes;
  }
  return checkpoint_head(entries) + contents;
}

void write_checkpoint_file(const std::filesystem::path& path, std::span<const CheckpointSection> sections) {
  replace_file(path, checkpoint_of(sections));
}

std::map<std::string, std::string> read_checkpoint(std::string_view file, const std::string& where) {
  Parts parts(file, where);
  std::map<std::string, std::string> sections;
  for (const SectionEntry& entry : read_head(parts, file, where)) {
    sections[entry.name] = unpacked(entry, parts.take(entry.packed), where);
  }
  if (!parts.is_end()) refuse_checkpoint("continues after its end", where);
  return sections;
}

std::map<std::string, std::string> read_checkpoint_file(const std::filesystem::path& path) {
  return read_checkpoint(read_file(path), path.string());
}

CheckpointReader::CheckpointReader(const std::filesystem::path& path)
    : where_(path.string()), file_(path, std::ios::binary) {
  std::error_code unknown;
  const std::uint64_t size = std::filesystem::file_size(path, unknown);
  if (!file_ || unknown) refuse_checkpoint("cannot be read", where_);
  constexpr std::uint64_t kFirst = 1 << 16;
  for (std::uint64_t length = std::min(kFirst, size);; length = std::min(2 * length, size)) {
    const std::string begin = read_part(file_, 0, length);
    Parts parts(begin, where_);
    try {
      const std::vector<SectionEntry> entries = read_head(parts, begin, where_);
      std::uint64_t offset = parts.at();
      for (const SectionEntry& entry : entries) {
        names_.push_back(entry.name);
        places_[entry.name] = {entry, offset};
        offset += entry.packed;
      }
      return;
    } catch (const Error&) {
      if (length == size) throw;
    }
  }
}

std::string CheckpointReader::section(const std::string& name) {
  const auto found = places_.find(name);
  if (found == places_.end()) refuse_checkpoint("has no section '" + name + "'", where_);
  const auto& [entry, offset] = found->second;
  const std::string bytes = read_part(file_, offset, entry.packed);
  if (bytes.size() < entry.packed) refuse_checkpoint("ends too early", where_);
  return unpacked(entry, bytes, where_);
}

}  // namespace hardball
