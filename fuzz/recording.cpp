// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "fuzz/file_of_bytes.hpp"
#include "fuzz/target.hpp"
#include "hardball/io/recording_reader.hpp"

void hardball::fuzz::read(std::string_view bytes) {
  const FileOfBytes file(bytes);
  RecordingReader reader(file.path());
  for (std::size_t chunk = 0; chunk < reader.chunks().size(); ++chunk) reader.read(chunk);
}
