// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace hardball::cli {

/// Keeps other runs out of a directory while it exists: an advisory lock on the file run.lock in it, which
/// the system gives up when the process ends, however it ends.
class DirectoryLock {
 public:
  /// Error: another run holds the lock, or the directory cannot be written to.
  explicit DirectoryLock(const std::filesystem::path& directory);
  /// Removes the file.
  ~DirectoryLock();
  DirectoryLock(DirectoryLock&& other) noexcept;
  DirectoryLock& operator=(DirectoryLock&&) = delete;

 private:
  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace hardball::cli
