// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace hardball::cli {

/// A file in the directory for temporary files, readable only by this user, until its name is removed.
class TemporaryFile {
 public:
  /// Error: it cannot be created.
  TemporaryFile();
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace hardball::cli
