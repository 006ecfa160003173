// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/open_output.hpp"

#include <cstdint>
#include <string>
#include <system_error>
#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// Nothing is lost by writing to it.
bool leads_to_device(const std::filesystem::path& path) {
  std::error_code failure;
  return std::filesystem::is_character_file(path, failure);
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

platform::File open_output(const std::filesystem::path& path) {
  using platform::Access;
  using platform::File;
  if (leads_to_device(path)) return {path, Access::write};
  File file(path, Access::create);
  if (!file.is_open()) return file;
  const std::uint64_t names = file.names();
  if (names == 0) return file;
  if (names == 1) return file.resize(0) ? std::move(file) : File();
  file.close();
  return platform::remove_file(path) ? File(path, Access::create_new) : File();
}

}  // namespace hardball
