// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/snapshot_format.hpp"

#include <array>
#include <cstddef>
#include <string>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

struct Ending {
  std::string_view text;
  SnapshotFormat format;
};

// The first for each format is the usual one.
constexpr std::array<Ending, 10> kEndings{{{".xyz", SnapshotFormat::extended_xyz},
                                           {".extxyz", SnapshotFormat::extended_xyz},
                                           {".xyz.zst", SnapshotFormat::extended_xyz_zst},
                                           {".gsd", SnapshotFormat::gsd},
                                           {".lammpstrj", SnapshotFormat::lammps},
                                           {".dump", SnapshotFormat::lammps},
                                           {".pvd", SnapshotFormat::vtp},
                                           {".csv", SnapshotFormat::csv},
                                           {".npy", SnapshotFormat::npy},
                                           {".sph", SnapshotFormat::sph}}};

}  // namespace

SnapshotFormat format_of(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  std::string known;
  for (const Ending& ending : kEndings) {
    if (name.ends_with(ending.text)) return ending.format;
    known += (known.empty() ? "" : ", ") + std::string(ending.text);
  }
  throw Error("unknown file extension", path.string(), "use one of " + known);
}

bool has_single_frame(SnapshotFormat format) {
  return format == SnapshotFormat::csv || format == SnapshotFormat::npy;
}

std::string_view name_of(SnapshotFormat format) {
  constexpr std::array<std::string_view, 8> kNames{"extended XYZ",      "extended XYZ, compressed",
                                                   "GSD, schema hoomd", "LAMMPS dump",
                                                   "VTP collection",    "CSV table",
                                                   "NumPy array",       "EDMD snapshots"};
  return kNames[static_cast<std::size_t>(format)];
}

}  // namespace hardball
