// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "hardball/errors/export.hpp"

namespace hardball {

/// Heights above the points of a grid, row by row.
struct HeightField {
  std::vector<double> heights;  ///< [L]
  std::size_t columns = 0;      ///< Heights in a row.
};

/// What a text file of heights has: on each line a row of numbers, with blanks or commas between them; lines
/// that are empty or begin with # are left out. Error, with the file and the line: it cannot be read,
/// something is no number, or a row is not as long as the first. Cost: O(bytes).
HARDBALL_EXPORT HeightField read_height_field(const std::filesystem::path& path);

}  // namespace hardball
