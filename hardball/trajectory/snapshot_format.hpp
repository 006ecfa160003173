// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "hardball/trajectory/snapshot_reader.hpp"

namespace hardball {

/// The formats of files with snapshots.
enum class SnapshotFormat {
  extended_xyz,
  extended_xyz_zst,
  gsd,
  lammps,
  vtp,  ///< Written but not read.
  csv,
  npy,
  sph,
};

/// The format of a file by its name. Error: the extension is unknown.
SnapshotFormat format_of(const std::filesystem::path& path);

/// Whether a file of this format has a single frame.
bool has_single_frame(SnapshotFormat format);

/// The name of a format, for people.
std::string_view name_of(SnapshotFormat format);

/// Opens a file to read its frames, in the format that its name says. Error: it cannot be read; it is not
/// what its name says; it contains no frame; its format cannot be read.
std::unique_ptr<SnapshotReader> open_snapshots(const std::filesystem::path& path);

/// The last frame of a file, from which a run can start. Error: as for open_snapshots and reading.
Snapshot read_snapshot(const std::filesystem::path& path);

}  // namespace hardball
