// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/temporary_file.hpp"

#include <cerrno>
#include <cstring>
#include <string>

#include "hardball/error.hpp"
#include "hardball/platform/files.hpp"

namespace hardball::cli {

TemporaryFile::TemporaryFile() {
  const std::filesystem::path directory = std::filesystem::temp_directory_path();
  path_ = platform::create_temporary_file(directory);
  if (path_.empty()) {
    throw Error(std::string("cannot create a temporary file: ") + std::strerror(errno), directory.string(),
                "name another directory in the environment variable TMPDIR");
  }
}

TemporaryFile::~TemporaryFile() {
  platform::remove_file(path_);
}

}  // namespace hardball::cli
