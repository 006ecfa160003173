// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "hardball/platform/files.hpp"

namespace hardball::cli {

/// Keeps other runs out of a directory while it exists: an advisory lock on the file run.lock in it, which
/// the system gives up when the process ends, however it ends.
class DirectoryLock {
 public:
  /// Error: another run holds the lock, or the directory cannot be written to.
  explicit DirectoryLock(const std::filesystem::path& directory);

 private:
  platform::LockFile file_;
};

}  // namespace hardball::cli
