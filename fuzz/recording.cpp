// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <string>

#include "fuzz/file_of_bytes.hpp"
#include "fuzz/target.hpp"
#include "hardball/recording/recording_reader.hpp"
#include "support/true_checksums.hpp"

void hardball::fuzz::read(std::string_view bytes) {
  // A fuzzer would never guess a checksum.
  const FileOfBytes file(support::with_true_checksums(std::string(bytes)));
  RecordingReader reader(file.path());
  for (std::size_t chunk = 0; chunk < reader.chunks().size(); ++chunk) reader.read(chunk);
}
