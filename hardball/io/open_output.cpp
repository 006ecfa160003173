// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/open_output.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

constexpr int kFlags = O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC;
constexpr mode_t kMode = 0666;

// Nothing is lost by writing to it.
bool leads_to_device(const std::filesystem::path& path) {
  std::error_code failure;
  return std::filesystem::is_character_file(path, failure);
}

// Closes the file, and keeps errno.
int given_up(int file) {
  const int reason = errno;
  close(file);
  errno = reason;
  return -1;
}

}  // namespace

void refuse_link(const std::filesystem::path& path) {
  std::error_code failure;
  if (!std::filesystem::is_symlink(path, failure) || leads_to_device(path)) return;
  const std::filesystem::path target = std::filesystem::read_symlink(path, failure);
  const bool is_there = std::filesystem::exists(path, failure);
  throw Error("is a symbolic link to " + target.string() + (is_there ? "" : ": No such file or directory"),
              path.string(), "remove the link, or name another file or directory for the output");
}

int open_output(const std::filesystem::path& path) {
  if (leads_to_device(path)) return open(path.c_str(), O_WRONLY | O_CLOEXEC);
  const int file = open(path.c_str(), kFlags, kMode);
  if (file < 0) return file;
  struct stat status {};
  if (fstat(file, &status) != 0) return given_up(file);
  if (!S_ISREG(status.st_mode)) return file;
  if (status.st_nlink <= 1) return ftruncate(file, 0) == 0 ? file : given_up(file);
  close(file);
  return unlink(path.c_str()) == 0 ? open(path.c_str(), kFlags | O_EXCL, kMode) : -1;
}

}  // namespace hardball
