// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <regex>
#include <string>

#include "support/scratch_folder.hpp"

/// The lines by which commands say what they have written.
namespace hardball::support {

/// Expects one line "wrote NAME, SIZE, CONTENTS" in `output`, of a size that is that of the file, or of the
/// files that `name` stands for, `bytes` in all, to the last digit given; CONTENTS may be empty.
inline void expect_written(const std::string& output, const std::string& name, std::uintmax_t bytes,
                           const std::string& contents) {
  const std::regex line("(^|\n)wrote " + std::regex_replace(name, std::regex(R"(\.)"), R"(\.)") +
                        ", ([0-9]+)([.][0-9])? (bytes?|kB|MB)" + (contents.empty() ? "" : ", ") + contents +
                        "\n");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(output, found, line)) << name << " in\n" << output;
  EXPECT_FALSE(std::regex_search(found.suffix().first, output.end(), line)) << "twice";
  const double unit = found[4] == "MB" ? 1e6 : found[4] == "kB" ? 1e3 : 1;
  const double size = unit * std::stod(found[2].str() + found[3].str());
  const double last_digit = unit * (found[3].matched ? 0.1 : 1);
  EXPECT_LE(std::abs(size - static_cast<double>(bytes)), unit == 1 ? 0 : 0.5001 * last_digit) << found[0];
  // At least two digits, unless there is only one.
  EXPECT_TRUE(unit == 1 || found[3].matched || found[2].length() >= 2) << found[0];
}

/// Expects the line of the file of this name in `folder`.
inline void expect_written(const std::string& output, const ScratchFolder& folder, const std::string& name,
                           const std::string& contents) {
  expect_written(output, name, std::filesystem::file_size(folder / name), contents);
}

}  // namespace hardball::support
