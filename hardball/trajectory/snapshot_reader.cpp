// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/snapshot_reader.hpp"

#include <fstream>
#include <system_error>

#include "hardball/errors/error.hpp"
#include "hardball/io/zstd.hpp"
#include "hardball/trajectory/gsd_reader.hpp"
#include "hardball/trajectory/npy_snapshot.hpp"
#include "hardball/trajectory/snapshot_format.hpp"
#include "hardball/trajectory/text_formats.hpp"

namespace hardball {
namespace {

std::unique_ptr<std::istream> open_plain(const std::filesystem::path& path) {
  auto file = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*file) throw Error("the file cannot be read", path.string(), "name a file that you may read");
  return file;
}

}  // namespace

std::unique_ptr<SnapshotReader> open_snapshots(const std::filesystem::path& path) {
  const SnapshotFormat format = format_of(path);
  // Files are read more than once, to their ends: a pipe cannot be, and a device may have no end.
  std::error_code unknown;
  if (std::filesystem::exists(path, unknown) && !std::filesystem::is_regular_file(path, unknown)) {
    throw Error("it is not a regular file", path.string(), "name a file with snapshots");
  }
  const auto text = [&](TextFormat text_format) {
    const auto open = is_compressed(path) ? open_zstd : open_plain;
    return std::make_unique<TextSnapshotReader>([path, open] { return open(path); }, path.string(),
                                                text_format);
  };
  switch (format) {
    case SnapshotFormat::extended_xyz:
    case SnapshotFormat::extended_xyz_zst:
      return text(extended_xyz_format());
    case SnapshotFormat::gsd:
      return std::make_unique<GsdReader>(path);
    case SnapshotFormat::lammps:
      return text(lammps_dump_format());
    case SnapshotFormat::csv:
      return text(csv_format());
    case SnapshotFormat::npy:
      return std::make_unique<NpySnapshotReader>(path);
    case SnapshotFormat::sph:
      return text(sph_format());
    case SnapshotFormat::lammps_data:
      return text(lammps_data_format());
    case SnapshotFormat::vtp:
      break;
  }
  throw Error("VTP files cannot be read", path.string(), "name a file of another format");
}

Snapshot read_snapshot(const std::filesystem::path& path) {
  const std::unique_ptr<SnapshotReader> reader = open_snapshots(path);
  return reader->read(reader->frames() - 1);
}

}  // namespace hardball
