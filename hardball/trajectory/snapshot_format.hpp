// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

#include "hardball/describe/names.hpp"
#include "hardball/errors/export.hpp"

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
  lammps_data,
};

/// The format of a file by its name. Text formats may be compressed by zstd: their names then end in .zst. A
/// number at the end, as in dump.100, does not matter. Error: the name says no format; the file is compressed
/// by gzip, or is compressed and no text.
HARDBALL_EXPORT SnapshotFormat format_of(const std::filesystem::path& path);

/// Whether a file is compressed by zstd, by its name.
HARDBALL_EXPORT bool is_compressed(const std::filesystem::path& path);

/// Whether a file of this format has a single frame.
HARDBALL_EXPORT bool has_single_frame(SnapshotFormat format);

template <>
inline constexpr std::array<std::string_view, 9> kNames<SnapshotFormat>{
    "extended XYZ", "extended XYZ, compressed", "GSD, schema hoomd",
    "LAMMPS dump",  "VTP collection",           "CSV table",
    "NumPy array",  "EDMD snapshots",           "LAMMPS data file"};

}  // namespace hardball
