// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "hardball/trajectory/gsd_file.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"

namespace hardball {

/// Reads GSD files of the schema hoomd: exact numbers where hardball has written them, otherwise those in
/// single precision, in a box that begins at the origin.
///
/// A chunk that a frame lacks is that of the first frame, for quantities of spheres only if both have the
/// same number of spheres, and otherwise the default of the schema. Error: see gsd::File; a chunk has another
/// type or shape than the schema says; the box is triclinic; a frame has no positions.
class GsdReader final : public SnapshotReader {
 public:
  explicit GsdReader(const std::filesystem::path& path);

  std::size_t frames() const override { return frames_; }
  Snapshot read(std::size_t frame) override;

 private:
  struct Column;

  const gsd::Entry* entry_of(std::size_t frame, gsd::Chunk chunk);
  bool has_own(std::size_t frame, gsd::Chunk chunk) const;
  std::string chunk(std::size_t frame, gsd::Chunk chunk, gsd::Type type, std::uint64_t rows,
                    std::uint64_t columns);
  std::string exact_chunk(std::size_t frame, gsd::Chunk rough, gsd::Chunk exact, std::uint64_t rows,
                          std::uint64_t columns);
  std::uint64_t count_of(std::size_t frame);
  void read_box(std::size_t frame, Snapshot& snapshot);
  std::vector<SpeciesId> species_of_types(std::size_t frame);
  void read_bonds(std::size_t frame, Snapshot& snapshot);

  gsd::File file_;
  std::size_t frames_;
};

}  // namespace hardball
