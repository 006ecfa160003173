// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <utility>

#include "hardball/platform/files.hpp"

namespace hardball::cli {

/// The file by which a run keeps others out of its directory. A run that is killed leaves it there.
inline constexpr const char* kRunLock = "run.lock";

/// Keeps others out of a directory while it exists: an advisory lock on a file in it, which the system gives
/// up when the process ends, however it ends.
class DirectoryLock {
 public:
  /// The lock of a run, on the file kRunLock. Error: another run holds the lock, or the directory cannot be
  /// written to.
  explicit DirectoryLock(const std::filesystem::path& directory);
  /// The lock on the file of this name in a directory; none if another holds it. Error: the directory cannot
  /// be written to.
  static std::optional<DirectoryLock> if_free(const std::filesystem::path& directory, const char* name);

 private:
  explicit DirectoryLock(platform::LockFile file) : file_(std::move(file)) {}

  platform::LockFile file_;
};

}  // namespace hardball::cli
