// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/read_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "hardball/errors/error.hpp"

namespace hardball {

std::string read_file(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) throw Error("is a directory", path.string(), "name a file in it");
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in || in.bad()) {
    throw Error(std::string("cannot be read: ") + std::strerror(errno), path.string(),
                "check the path and its permissions");
  }
  return bytes;
}

std::string read_part(std::istream& file, std::uint64_t offset, std::uint64_t length) {
  std::string bytes(length, '\0');
  file.clear();
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(bytes.data(), static_cast<std::streamsize>(length));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

}  // namespace hardball
