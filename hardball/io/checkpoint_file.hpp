// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/errors/export.hpp"

namespace hardball {

/// Part of a checkpoint: the bytes that its owner needs to continue.
struct CheckpointSection {
  std::string name;
  std::string bytes;
};

/// The entry of a section in the directory at the start of a checkpoint.
struct SectionEntry {
  std::string name;
  std::uint32_t method = 0;    ///< How it is compressed.
  std::uint64_t length = 0;    ///< Length of its bytes.
  std::uint64_t packed = 0;    ///< Length of the compressed bytes.
  std::uint64_t checksum = 0;  ///< Checksum of the compressed bytes.

  static void persist(auto& archive, auto& self) {
    archive(self.name, self.method, self.length, self.packed, self.checksum);
  }
};

/// A section as it is stored.
struct PackedSection {
  SectionEntry entry;
  std::string bytes;
};

/// Compresses a section. Cost: O(bytes).
PackedSection pack(const CheckpointSection& section);

/// What stands before the sections of a checkpoint; these follow without gaps.
std::string checkpoint_head(std::span<const SectionEntry> entries);

/// A checkpoint as bytes. Sections are compressed, and each has a checksum. Cost: O(bytes), some 0.5 s for a
/// million spheres.
///
/// The bytes, little-endian: the eight bytes "HBCHECK1"; the number of sections, 4 bytes; of each the length
/// of its name, 4 bytes, its name, how it is compressed, 4 bytes (0 not at all, 1 zstd), its length, its
/// length as compressed and the XXH64 of the compressed bytes, 8 bytes each; the XXH64 of all before; then
/// the compressed sections.
HARDBALL_EXPORT std::string checkpoint_of(std::span<const CheckpointSection> sections);

/// Writes a checkpoint, which under its own name is always complete: the one before, or this one. Error
/// (RunFailure): it cannot be written; the one before is kept. Cost: as of checkpoint_of.
HARDBALL_EXPORT void write_checkpoint_file(const std::filesystem::path& path,
                                           std::span<const CheckpointSection> sections);

/// The sections of a checkpoint, by name. Error: there is no such file, or it is damaged. Memory: no more
/// than 256 times the length of the file.
HARDBALL_EXPORT std::map<std::string, std::string> read_checkpoint_file(const std::filesystem::path& path);

/// The sections of a checkpoint, by name, from the bytes of a file; `where` names it in errors. Error: it is
/// damaged.
HARDBALL_EXPORT std::map<std::string, std::string> read_checkpoint(std::string_view file,
                                                                   const std::string& where);

/// A checkpoint of which a few sections are read at a time.
class CheckpointReader {
 public:
  /// Error: there is no such file; what stands before its sections is damaged.
  explicit CheckpointReader(const std::filesystem::path& path);

  /// The names of all sections, in the order in which they are stored.
  const std::vector<std::string>& names() const { return names_; }
  /// Error: there is no such section, or it is damaged.
  std::string section(const std::string& name);

 private:
  struct Place {
    SectionEntry entry;
    std::uint64_t offset = 0;
  };

  std::string where_;
  std::ifstream file_;
  std::vector<std::string> names_;
  std::map<std::string, Place> places_;
};

}  // namespace hardball
