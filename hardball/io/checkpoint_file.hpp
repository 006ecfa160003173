// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "hardball/errors/export.hpp"

namespace hardball {

/// Part of a checkpoint: the bytes that its owner needs to continue.
struct CheckpointSection {
  std::string name;
  std::string bytes;
};

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

/// The same, of the bytes of a file; `where` names it in errors.
HARDBALL_EXPORT std::map<std::string, std::string> read_checkpoint(std::string_view file,
                                                                   const std::string& where);

}  // namespace hardball
