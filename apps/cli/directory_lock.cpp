// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/directory_lock.hpp"

#include <cerrno>
#include <cstring>
#include <string>

#include "hardball/error.hpp"
#include "hardball/io/open_output.hpp"

namespace hardball::cli {
namespace {

std::filesystem::path without_links(const std::filesystem::path& path) {
  refuse_link(path);
  return path;
}

}  // namespace

std::optional<DirectoryLock> DirectoryLock::if_free(const std::filesystem::path& directory,
                                                    const char* name) {
  platform::LockFile file(without_links(directory / name));
  using State = platform::LockFile::State;
  switch (file.state()) {
    case State::held:
      return DirectoryLock(std::move(file));
    case State::held_by_another:
      return std::nullopt;
    case State::not_created:
      throw Error(std::string("cannot be written to: ") + std::strerror(errno), directory.string(),
                  "name another directory for the output");
    case State::not_locked:
      throw Error(std::string("cannot be locked: ") + std::strerror(errno), directory.string(),
                  "name a directory on another file system");
  }
  return std::nullopt;
}

DirectoryLock::DirectoryLock(const std::filesystem::path& directory)
    : DirectoryLock([&] {
        std::optional<DirectoryLock> lock = if_free(directory, kRunLock);
        if (lock) return std::move(*lock);
        throw Error("another run is writing to it", directory.string(),
                    "wait until that run has ended, or name another directory for the output");
      }()) {}

}  // namespace hardball::cli
