// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <string>

#include "fuzz/file_of_bytes.hpp"
#include "fuzz/target.hpp"
#include "hardball/recording/recording_writer.hpp"

// The state of a recording being written, as checkpoints hold it.
void hardball::fuzz::read(std::string_view bytes) {
  // As long as any that is meant.
  const FileOfBytes file(std::string(1 << 16, '\0'));
  RecordingWriter writer(file.path(), bytes);
  writer.close(1);
}
