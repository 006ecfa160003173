// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/gsd_file.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "hardball/errors/error.hpp"
#include "hardball/io/read_file.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball::gsd {
namespace {

bool precedes(const Entry& a, const Entry& b) {
  return std::tie(a.frame, a.name) < std::tie(b.frame, b.name);
}

}  // namespace

File::File(const std::filesystem::path& path) : name_(path.string()), file_(path, std::ios::binary) {
  std::error_code unknown;
  length_ = std::filesystem::file_size(path, unknown);
  if (!file_ || unknown) throw Error("the file cannot be read", name_, "name a GSD file");
  if (length_ < kHeaderBytes) refuse("the file has no header");
  const std::string header = read_bytes(0, kHeaderBytes);
  if (read_little_endian<std::uint64_t>(header.data()) != kMagic) refuse("the file is not a GSD file");
  header_ = header_at(header.data());
  const auto version = read_little_endian<std::uint32_t>(&header[44]) >> 16;
  if (version != 1 && version != 2) refuse("the file has version " + to_text(version) + " of the format");
  constexpr std::size_t kSchemaOffset = 48 + kNameBytes;
  if (std::string_view(&header[kSchemaOffset], kSchema.size() + 1) != std::string(kSchema) + '\0') {
    refuse("the file's schema is not hoomd");
  }
  const auto fits = [&](std::uint64_t location, std::uint64_t count, std::uint64_t bytes) {
    return location <= length_ && count <= (length_ - location) / bytes;
  };
  if (!fits(header_.names_location, header_.names_length, kNameBytes) ||
      !fits(header_.index_location, header_.index_entries, Entry::kBytes)) {
    refuse("the header points beyond the end of the file");
  }
  const std::string names = read_bytes(header_.names_location, header_.names_length * kNameBytes);
  // In version 1 each name has 64 bytes; in version 2 they follow each other.
  for (std::size_t at = 0; at < names.size() && names[at] != '\0';) {
    const std::size_t end = std::min(names.find('\0', at), names.size());
    if (names_.size() > std::numeric_limits<std::uint16_t>::max()) refuse("the file has too many names");
    numbers_.emplace(names.substr(at, end - at), static_cast<std::uint16_t>(names_.size()));
    names_.push_back(names.substr(at, end - at));
    at = version == 1 ? at + kNameBytes : end + 1;
  }
  const std::string index = read_bytes(header_.index_location, header_.index_entries * Entry::kBytes);
  for (std::size_t at = 0; at < index.size(); at += Entry::kBytes) {
    entries_.push_back(read_entry(&index[at]));
    if (entries_.back().location != 0) continue;
    entries_.pop_back();
    break;
  }
  sorted_ = entries_;
  ranges::stable_sort(sorted_, precedes);
}

std::uint64_t File::frames() const {
  if (sorted_.empty()) return 0;
  // As GSD itself demands: then the number of frames is bounded by the length of the file.
  const std::uint64_t last = sorted_.back().frame;
  if (last >= header_.index_entries) refuse("the index is damaged");
  return last + 1;
}

const Entry* File::find(std::uint64_t frame, std::string_view name) const {
  const auto number = numbers_.find(name);
  if (number == numbers_.end()) return nullptr;
  Entry sought;
  sought.frame = frame;
  sought.name = number->second;
  const auto found = ranges::lower_bound(sorted_, sought, precedes);
  return found != sorted_.end() && !precedes(sought, *found) ? &*found : nullptr;
}

bool File::is_whole(const Entry& entry) const {
  const std::uint64_t size = bytes_of(entry.type);
  if (size == 0 || entry.location > length_) return false;
  const std::uint64_t numbers = (length_ - entry.location) / size;
  return entry.columns == 0 || entry.rows <= numbers / entry.columns;
}

std::string File::read(const Entry& entry) {
  if (!is_whole(entry)) refuse("a chunk does not lie within the file");
  return read_bytes(entry.location, entry.bytes());
}

std::string File::read_bytes(std::uint64_t offset, std::uint64_t length) {
  std::string bytes = read_part(file_, offset, length);
  if (bytes.size() != length) refuse("the file has become shorter");
  return bytes;
}

void File::refuse(const std::string& problem) const {
  throw Error(problem, name_, "give a complete GSD file with the schema hoomd");
}

}  // namespace hardball::gsd
