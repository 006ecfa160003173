// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/refuse_to_overwrite.hpp"

#include <system_error>

#include "hardball/error.hpp"
#include "hardball/io/open_output.hpp"

namespace hardball::cli {

void refuse_to_overwrite(const std::filesystem::path& file, bool may_replace) {
  refuse_link(file);
  std::error_code missing;
  if (may_replace || !std::filesystem::is_regular_file(file, missing)) return;
  throw Error("the file exists already", file.string(), "name another file, or replace it with --overwrite");
}

}  // namespace hardball::cli
