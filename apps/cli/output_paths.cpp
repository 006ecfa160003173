// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/output_paths.hpp"

#include <system_error>

#include "hardball/error.hpp"
#include "hardball/io/open_output.hpp"

namespace hardball::cli {

std::vector<std::filesystem::path> make_directory(const std::filesystem::path& directory) {
  std::vector<std::filesystem::path> created;
  std::error_code failure;
  for (auto path = directory; !path.empty() && !std::filesystem::exists(path, failure);
       path = path.parent_path()) {
    created.push_back(path);
    if (path == path.parent_path()) break;
  }
  std::filesystem::create_directories(directory, failure);
  if (std::filesystem::is_directory(directory)) return created;
  throw Error("cannot be created as a directory" + (failure ? ": " + failure.message() : std::string()),
              directory.string(), "name another directory for the output");
}

void refuse_to_overwrite(const std::filesystem::path& file, bool may_replace) {
  refuse_link(file);
  std::error_code missing;
  if (may_replace || !std::filesystem::is_regular_file(file, missing)) return;
  throw Error("the file exists already", file.string(), "name another file, or replace it with --overwrite");
}

}  // namespace hardball::cli
