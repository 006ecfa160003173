// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "hardball/io/recording.hpp"

namespace hardball {

/// A stretch of bytes in a file.
struct FileExtent {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
};

/// Where a chunk of a recording lies, and when it happens.
struct ChunkExtent {
  FileExtent bytes;
  std::uint32_t contacts = 0;
  double begin = 0;  ///< [T]
  double end = 0;    ///< [T]
};

/// Reads a recording, also one that is still being written, or whose writer was killed: a last chunk that is
/// not complete is not there yet.
///
/// Whatever the file holds, no more memory is asked for than its length justifies.
class RecordingReader {
 public:
  /// Opens the file and finds its chunks. Error: it cannot be read; it is no recording; a chunk's header
  /// makes no sense.
  explicit RecordingReader(const std::filesystem::path& path);

  const RecordingHeader& header() const { return header_; }
  /// The header as it stands in the file: one JSON object.
  const std::string& header_text() const { return header_text_; }
  /// By id [L].
  const std::vector<double>& radii() const { return radii_; }
  /// By id [M].
  const std::vector<double>& masses() const { return masses_; }
  /// Where radii and masses lie in the file.
  FileExtent spheres() const { return spheres_; }

  /// The complete chunks found so far, each beginning where the one before ends.
  const std::vector<ChunkExtent>& chunks() const { return chunks_; }
  /// Where the last complete chunk ends in the file.
  std::uint64_t length() const { return length_; }
  /// The time up to which the run is known [T].
  double reached() const { return chunks_.empty() ? header_.begin : chunks_.back().end; }

  /// Looks for chunks that have been added to the file. Cost: that of reading their headers. Error: as for
  /// the constructor.
  void refresh();

  /// All of a chunk. Error: there is no such chunk; it names spheres that do not exist, times out of order,
  /// or numbers that are not finite.
  RecordedChunk read(std::size_t chunk);

 private:
  std::uint64_t file_length();
  std::string read_bytes(const FileExtent& extent);
  [[noreturn]] void refuse(const std::string& problem) const;

  std::string name_;
  std::ifstream file_;
  RecordingHeader header_;
  std::string header_text_;
  std::vector<double> radii_;
  std::vector<double> masses_;
  FileExtent spheres_;
  std::vector<ChunkExtent> chunks_;
  std::uint64_t length_ = 0;
};

}  // namespace hardball
