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
#include "hardball/io/open_output.hpp"

namespace hardball {
namespace {

// Returns when the bytes are on the disk; false, with errno, if that is impossible.
bool write_through(const std::string& path, std::string_view bytes) {
  const int opened = open_output(path);
  std::FILE* const file = opened < 0 ? nullptr : fdopen(opened, "wb");
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

[[noreturn]] void fail_to_replace(const std::filesystem::path& path, int reason) {
  throw RunFailure("cannot write " + path.string() + ": " + std::strerror(reason) + "; it is unchanged");
}

}  // namespace

void replace_file(const std::filesystem::path& path, std::string_view bytes) {
  const std::string unfinished = unfinished_name(path).string();
  if (!write_through(unfinished, bytes)) {
    const int reason = errno;
    std::remove(unfinished.c_str());
    fail_to_replace(path, reason);
  }
  put_in_place(path);
}

std::filesystem::path unfinished_name(const std::filesystem::path& path) {
  return path.string() + ".part";
}

void write_at(const std::filesystem::path& path, std::uint64_t offset, std::string_view bytes) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
  bool is_written = file >= 0;
  while (is_written && !bytes.empty()) {
    const ssize_t count = pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    is_written = count > 0 || (count < 0 && errno == EINTR);
    if (count <= 0) continue;
    bytes.remove_prefix(static_cast<std::size_t>(count));
    offset += static_cast<std::uint64_t>(count);
  }
  is_written = is_written && fsync(file) == 0;
  const int reason = errno;
  if (file >= 0) is_written = close(file) == 0 && is_written;
  if (!is_written) throw RunFailure("cannot write " + path.string() + ": " + std::strerror(reason));
}

void put_in_place(const std::filesystem::path& path) {
  const std::string unfinished = unfinished_name(path).string();
  if (std::rename(unfinished.c_str(), path.c_str()) == 0) return sync_directory(path.parent_path());
  const int reason = errno;
  std::remove(unfinished.c_str());
  fail_to_replace(path, reason);
}

}  // namespace hardball
