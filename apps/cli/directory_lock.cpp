// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/directory_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "hardball/error.hpp"
#include "hardball/io/open_output.hpp"

namespace hardball::cli {
namespace {

// Whether the name still leads to the open file, which the run before may have removed meanwhile.
bool is_named(int file, const std::filesystem::path& path) {
  struct stat open {};
  struct stat named {};
  return fstat(file, &open) == 0 && stat(path.c_str(), &named) == 0 && open.st_ino == named.st_ino;
}

}  // namespace

std::optional<DirectoryLock> DirectoryLock::if_free(const std::filesystem::path& directory,
                                                    const char* name) {
  constexpr mode_t kReadableByAll = 0644;
  const std::filesystem::path path = directory / name;
  refuse_link(path);
  int file = -1;
  do {
    if (file >= 0) close(file);
    file = open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, kReadableByAll);
    if (file < 0) {
      throw Error(std::string("cannot be written to: ") + std::strerror(errno), directory.string(),
                  "name another directory for the output");
    }
    if (flock(file, LOCK_EX | LOCK_NB) != 0) {
      const int reason = errno;
      close(file);
      if (reason == EWOULDBLOCK) return std::nullopt;
      throw Error(std::string("cannot be locked: ") + std::strerror(reason), directory.string(),
                  "name a directory on another file system");
    }
  } while (!is_named(file, path));
  return DirectoryLock(path, file);
}

DirectoryLock::DirectoryLock(const std::filesystem::path& directory)
    : DirectoryLock([&] {
        std::optional<DirectoryLock> lock = if_free(directory, kRunLock);
        if (lock) return std::move(*lock);
        throw Error("another run is writing to it", directory.string(),
                    "wait until that run has ended, or name another directory for the output");
      }()) {}

DirectoryLock::~DirectoryLock() {
  if (file_ < 0) return;
  unlink(path_.c_str());
  close(file_);
}

DirectoryLock::DirectoryLock(DirectoryLock&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}

}  // namespace hardball::cli
