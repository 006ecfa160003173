// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "hardball/io/npy_header.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"
#include "hardball/trajectory/text_trajectory.hpp"

namespace hardball {

/// Writes a NumPy file: a structured array with an item for each sphere and the fields `id type x y z vx vy
/// vz radius mass ix iy iz`, where types are finer than species `species_id` and, where spheres spin,
/// `omegax omegay omegaz moment`.
TextFrame npy_frame();

/// Reads the spheres of a NumPy file: a structured array with such fields (see SphereColumns), or with
/// `position`, `velocity`, `angular_velocity` and `image` of three numbers each; or a plain array of shape
/// (N, 4) whose columns are x, y, z, radius, or of shape (N, 7), (N, 8) or (N, 9) whose columns are x, y, z,
/// vx, vy, vz, radius, mass, id. Error: see read_npy_header; a field is missing, or no number.
class NpySnapshotReader final : public SnapshotReader {
 public:
  explicit NpySnapshotReader(const std::filesystem::path& path);

  std::size_t frames() const override { return 1; }
  Snapshot read(std::size_t frame) override;

 private:
  std::filesystem::path path_;
  NpyHeader header_;
};

}  // namespace hardball
