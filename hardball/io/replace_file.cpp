// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/replace_file.hpp"

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/io/open_output.hpp"
#include "hardball/platform/files.hpp"

namespace hardball {
namespace {

// Returns when the bytes are on the disk; false, with errno, if that is impossible.
bool write_through(platform::File file, std::string_view bytes) {
  return file.is_open() && file.write(bytes) && file.sync() && file.close();
}

[[noreturn]] void fail_to_replace(const std::filesystem::path& path, int reason) {
  throw RunFailure("cannot write " + path.string() + ": " + std::strerror(reason) + "; it is unchanged");
}

}  // namespace

void replace_file(const std::filesystem::path& path, std::string_view bytes) {
  const std::filesystem::path unfinished = unfinished_name(path);
  if (!write_through(open_output(unfinished), bytes)) {
    const int reason = errno;
    platform::remove_file(unfinished);
    fail_to_replace(path, reason);
  }
  put_in_place(path);
}

std::filesystem::path unfinished_name(const std::filesystem::path& path) {
  std::filesystem::path name = path;
  return name += ".part";
}

void write_at(const std::filesystem::path& path, std::uint64_t offset, std::string_view bytes) {
  platform::File file(path, platform::Access::create);
  const bool is_placed = file.is_open() && file.seek(offset);
  if (!is_placed || !write_through(std::move(file), bytes))
    throw RunFailure("cannot write " + path.string() + ": " + std::strerror(errno));
}

void put_in_place(const std::filesystem::path& path) {
  const std::filesystem::path unfinished = unfinished_name(path);
  if (platform::rename_file(unfinished, path)) return;
  const int reason = errno;
  platform::remove_file(unfinished);
  fail_to_replace(path, reason);
}

}  // namespace hardball
