// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/zstd.hpp"

#include "fuzz/file_of_bytes.hpp"
#include "fuzz/snapshots.hpp"
#include "hardball/trajectory/text_formats.hpp"

void hardball::fuzz::read(std::string_view bytes) {
  const FileOfBytes file(bytes);
  TextSnapshotReader reader([&] { return open_zstd(file.path()); }, "start", extended_xyz_format());
  read_frames(reader);
}
