// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "hardball/trajectory/gsd_layout.hpp"

namespace hardball::gsd {

/// The chunks of a GSD file, by frame and name.
class File {
 public:
  /// Reads header, names and index. Memory: some times that of the index. Error: the file cannot be read; it
  /// is not a GSD file of version 1 or 2 with the schema hoomd; its header points out of the file.
  explicit File(const std::filesystem::path& path);

  const std::string& name() const { return name_; }
  const Header& header() const { return header_; }
  /// One more than the number of the last frame. Error: the index is damaged.
  std::uint64_t frames() const;
  /// All entries of the index before its end, as they are in the file.
  const std::vector<Entry>& entries() const { return entries_; }
  /// The names of chunks, by the numbers in entries.
  const std::vector<std::string>& names() const { return names_; }

  /// The chunk of this frame; null if the frame itself has none.
  const Entry* find(std::uint64_t frame, std::string_view name) const;
  /// The bytes of a chunk. Error: it does not lie within the file.
  std::string read(const Entry& entry);
  /// Whether a chunk lies within the file.
  bool is_whole(const Entry& entry) const;

 private:
  [[noreturn]] void refuse(const std::string& problem) const;
  std::string read_bytes(std::uint64_t offset, std::uint64_t length);

  std::string name_;
  std::ifstream file_;
  std::uint64_t length_ = 0;
  Header header_;
  std::vector<std::string> names_;
  std::map<std::string, std::uint16_t, std::less<>> numbers_;
  std::vector<Entry> entries_;
  std::vector<Entry> sorted_;
};

}  // namespace hardball::gsd
