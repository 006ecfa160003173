// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/replace_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// Returns when the bytes are on the disk; false, with errno, if that is impossible.
bool write_through(const std::string& path, std::string_view bytes) {
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (!file) return false;
  const bool is_written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() &&
                          std::fflush(file) == 0 && fsync(fileno(file)) == 0;
  const int reason = errno;
  const bool is_closed = std::fclose(file) == 0;
  if (!is_written) errno = reason;
  return is_written && is_closed;
}

// Asks for the names in a directory to be on the disk. Some file systems cannot; then they are when it
// pleases them.
void sync_directory(const std::filesystem::path& directory) {
  const int opened = open(directory.empty() ? "." : directory.c_str(), O_RDONLY | O_DIRECTORY);
  if (opened < 0) return;
  fsync(opened);
  close(opened);
}

}  // namespace

void replace_file(const std::filesystem::path& path, std::string_view bytes) {
  const std::string unfinished = path.string() + ".part";
  if (write_through(unfinished, bytes) && std::rename(unfinished.c_str(), path.c_str()) == 0) {
    sync_directory(path.parent_path());
    return;
  }
  const int reason = errno;
  std::remove(unfinished.c_str());
  throw RunFailure("cannot write " + path.string() + ": " + std::strerror(reason) + "; it is unchanged");
}

}  // namespace hardball
