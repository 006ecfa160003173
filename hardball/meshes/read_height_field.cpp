// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/meshes/read_height_field.hpp"

#include <algorithm>
#include <string>

#include "hardball/io/read_file.hpp"
#include "hardball/meshes/words.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {

HeightField read_height_field(const std::filesystem::path& path) {
  std::string text = read_file(path);
  ranges::replace(text, ',', ' ');
  HeightField field;
  Words words(text, path.string());
  while (words.next_line()) {
    std::size_t columns = 0;
    for (std::string_view word = words.next(); !word.empty() && !word.starts_with('#'); word = words.next()) {
      field.heights.push_back(words.number(word));
      ++columns;
    }
    if (columns == 0) continue;
    if (field.columns == 0) field.columns = columns;
    if (columns != field.columns)
      words.fail("a row has " + to_text(columns) + " heights, and the first " + to_text(field.columns));
  }
  return field;
}

}  // namespace hardball
