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
  const gsd::Entry* entry_of(std::size_t frame, gsd::Chunk chunk);
  bool has_own(std::size_t frame, gsd::Chunk chunk) const;
  template <class Row>
  std::vector<Row> rows(std::size_t frame, gsd::Chunk chunk, std::uint64_t count,
                        std::uint32_t columns = gsd::RowOf<Row>::kColumns);
  template <class Row>
  std::vector<Row> exact_rows(std::size_t frame, gsd::Chunk rough, gsd::Chunk fine, std::uint64_t count);
  template <class Single>
  auto best_rows(std::size_t frame, gsd::Chunk rough, gsd::Chunk fine, std::uint64_t count);
  std::uint64_t count_of(std::size_t frame);
  void read_box(std::size_t frame, Snapshot& snapshot);
  std::vector<SpeciesId> species_of_types(std::size_t frame);
  void read_bonds(std::size_t frame, Snapshot& snapshot);

  gsd::File file_;
  std::size_t frames_;
};

}  // namespace hardball
