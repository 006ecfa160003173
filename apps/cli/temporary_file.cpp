// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/temporary_file.hpp"

#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "hardball/error.hpp"

namespace hardball::cli {

TemporaryFile::TemporaryFile() {
  const std::filesystem::path directory = std::filesystem::temp_directory_path();
  std::string name = (directory / "hardball-XXXXXX").string();
  const int file = mkstemp(name.data());
  if (file < 0) {
    throw Error(std::string("cannot create a temporary file: ") + std::strerror(errno), directory.string(),
                "name another directory in the environment variable TMPDIR");
  }
  close(file);
  path_ = name;
}

TemporaryFile::~TemporaryFile() {
  unlink(path_.c_str());
}

}  // namespace hardball::cli
