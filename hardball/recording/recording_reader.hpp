// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/recording/recording.hpp"

namespace hardball {

/// A range of bytes in a file.
struct FileExtent {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
};

/// The part of a recording that holds a chunk, and the times it covers.
struct ChunkExtent {
  FileExtent bytes;
  std::uint32_t contacts = 0;
  double begin = 0;  ///< [T]
  double end = 0;    ///< [T]
};

/// What a reader does with a file that is damaged after its first part, the header and the spheres.
enum class OnDamage {
  refuse,                  ///< Error.
  keep_what_comes_before,  ///< The recording ends before the first chunk that is damaged; see damage().
};

/// Reads a recording, even one that is still being written, or whose writer was killed: an incomplete last
/// chunk is ignored.
///
/// Damage is found by the checksums. Whatever the file contains, no more memory is allocated than its length
/// justifies.
class HARDBALL_EXPORT RecordingReader {
 public:
  /// Opens the file and finds its chunks by their heads. Error: it cannot be read; it is not a recording; its
  /// first part is damaged; or the head of a chunk, unless what comes before is to be kept.
  explicit RecordingReader(const std::filesystem::path& path, OnDamage on_damage = OnDamage::refuse);

  const RecordingHeader& header() const { return header_; }
  /// The header as written in the file: one JSON object.
  const std::string& header_text() const { return header_text_; }
  /// By id [L]; zero if there is no such sphere at the start, as are the masses.
  const std::vector<double>& radii() const { return radii_; }
  /// By id [M].
  const std::vector<double>& masses() const { return masses_; }
  /// The part of the file that holds radii and masses.
  FileExtent spheres() const { return spheres_; }

  /// The complete chunks found so far, each starting where the previous one ends.
  const std::vector<ChunkExtent>& chunks() const { return chunks_; }
  /// The end of the last complete chunk in the file.
  std::uint64_t length() const { return length_; }
  /// The time up to which the run is known [T].
  double reached() const { return chunks_.empty() ? header_.begin : chunks_.back().end; }

  /// Finds chunks added to the file since. Cost: that of reading their headers. Error: as for the
  /// constructor.
  void refresh();

  /// A whole chunk. Error: there is no such chunk; its checksum is another; it names spheres or surfaces that
  /// do not exist, times out of order, or numbers that are not finite.
  RecordedChunk read(std::size_t chunk);

  /// Reads all chunks found, and hands them to `take`, if there is one. Error: one of them is damaged, unless
  /// what comes before is to be kept. Cost: that of reading the file.
  void verify(const Function<void(const RecordedChunk&)>& take = {});
  /// What is damaged after the chunks that are kept, and where; nothing if no damage is known.
  const std::optional<std::string>& damage() const { return damage_; }

 private:
  std::uint64_t file_length();
  std::string read_bytes(const FileExtent& extent);
  [[noreturn]] void refuse(const std::string& problem) const;
  [[noreturn]] void refuse_chunk(std::size_t chunk, const std::string& problem) const;
  void find_chunks();

  std::string name_;
  std::unique_ptr<std::istream> file_;
  RecordingHeader header_;
  std::string header_text_;
  std::vector<double> radii_;
  std::vector<double> masses_;
  FileExtent spheres_;
  std::vector<ChunkExtent> chunks_;
  std::uint64_t length_ = 0;
  OnDamage on_damage_;
  std::optional<std::string> damage_;
};

}  // namespace hardball
