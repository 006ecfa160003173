// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "hardball/error.hpp"

namespace hardball::cli {

void write_output(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) {
    throw RunFailure(std::string("cannot write to the standard output: ") + std::strerror(errno));
  }
}

void write_message(std::string message) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' '; };
  std::replace_if(message.begin(), message.end(), is_control, ' ');
  std::fputs(("hardball: " + message + "\n").c_str(), stderr);
}

void write_notes(const std::vector<std::string>& notes, bool is_quiet) {
  if (is_quiet) return;
  for (const std::string& note : notes) write_message(note);
}

std::string table_line(std::string_view name, const std::string& value) {
  return fmt::format("{:<24}{}\n", name, value);
}

}  // namespace hardball::cli
