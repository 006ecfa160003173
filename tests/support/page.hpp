// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>

namespace hardball::support {

/// What check_page.py finds wrong with a page; empty if nothing.
inline std::string faults_of_page(const std::filesystem::path& path) {
  const std::string command =
      std::string(HARDBALL_PYTHON) + " " HARDBALL_TEST_SUPPORT "/check_page.py '" + path.string() + "' 2>&1";
  std::FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return "cannot start Python";
  std::string faults;
  char buffer[512];
  while (std::fgets(buffer, sizeof buffer, pipe)) faults += buffer;
  const int status = pclose(pipe);
  return status != 0 && faults.empty() ? "the check did not run" : faults;
}

}  // namespace hardball::support
