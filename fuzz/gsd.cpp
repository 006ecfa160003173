// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/gsd_reader.hpp"

#include "fuzz/file_of_bytes.hpp"
#include "fuzz/snapshots.hpp"

void hardball::fuzz::read(std::string_view bytes) {
  const FileOfBytes file(bytes);
  GsdReader reader(file.path());
  read_frames(reader);
}
