// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hardball/io/output_file.hpp"
#include "hardball/trajectory/frame_writer.hpp"
#include "hardball/trajectory/gsd_layout.hpp"

namespace hardball {

/// Writes a GSD file of the schema hoomd 1.4, for HOOMD-blue, OVITO, MDAnalysis, VMD and hardball itself.
///
/// The chunks of the schema are in single precision, centered on the box. Exact are, beside them,
/// `log/particles/position64`, `velocity64`, `radius64`, `mass64`, `angular_velocity64`, `moment64` and `id`,
/// `log/time` (NaN if it is not known), `log/pbc`, `log/box/origin`, `log/box/size` and `log/box/unbounded`.
/// Types are named after species: A, B; where they are finer than species, A.1, A.2. The step is the number
/// of the frame. What is as in the first frame is not repeated. The bytes of the file follow from its frames
/// alone, however often it was truncated. Memory: 64 bytes for each sphere between frames.
class GsdTrajectory final : public FrameWriter {
 public:
  /// Creates the file, or continues from a position in one that hardball has written. Error: it cannot be
  /// written; it has fewer frames, or others.
  explicit GsdTrajectory(std::filesystem::path path, const std::optional<TrajectoryPosition>& position = {});

  void append(const Snapshot& snapshot, std::uint64_t frame) override;
  TrajectoryPosition position() override;
  void close() override;

 private:
  OutputFile create(const std::filesystem::path& path);
  OutputFile open(const std::filesystem::path& path, const TrajectoryPosition& position);
  void cut_back();
  void write_chunk(gsd::Chunk chunk, const gsd::Rows& rows);
  void write_unless_as_first(gsd::Chunk chunk, gsd::Rows rows);
  void write_bonds(const Snapshot& snapshot);
  void write_entries();

  gsd::Header header_;
  std::uint64_t frame_ = 0;              // being written
  std::vector<gsd::Entry> entries_;      // in the file
  std::vector<gsd::Entry> new_entries_;  // of the frame being written
  std::array<std::string, gsd::kChunkNames.size()>
      first_;                               // the first frame's chunks that may not be repeated
  std::optional<std::size_t> first_count_;  // of its spheres
  bool is_repeated_ = false;  // whether the frame has another number of spheres, and so all chunks
  bool is_too_long_ = false;  // there may be frames that are to be cut off
  OutputFile file_;           // last: opening it reads the others from the file
};

}  // namespace hardball
