// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/replace_file.hpp"

#include <string>
#include <system_error>

#include "hardball/errors/error.hpp"
#include "hardball/io/output_file.hpp"

namespace hardball {

void replace_file(const std::filesystem::path& path, std::string_view bytes) {
  const std::filesystem::path unfinished = path.string() + ".part";
  std::error_code failure;
  try {
    OutputFile file(unfinished);
    file.append(bytes);
    file.sync();
    file.close();
  } catch (...) {
    std::filesystem::remove(unfinished, failure);
    throw;
  }
  std::filesystem::rename(unfinished, path, failure);
  if (failure) throw RunFailure("cannot write " + path.string() + ": " + failure.message());
}

}  // namespace hardball
