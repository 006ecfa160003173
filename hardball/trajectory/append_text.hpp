// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/standard/number_text.hpp"

namespace hardball {

/// Appends to a line the shortest decimal text that reads back as the same number, and a blank.
template <class Number>
void append_text(std::string& line, Number number) {
  std::array<char, 32> digits;
  const auto [end, status] = to_chars(digits.data(), digits.data() + digits.size(), number);
  HARDBALL_CHECK(status == std::errc());
  line.append(digits.data(), end);
  line += ' ';
}
inline void append_text(std::string& line, const Vec3& vector) {
  append_text(line, vector.x);
  append_text(line, vector.y);
  append_text(line, vector.z);
}
inline void append_text(std::string& line, const Image& image) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) append_text(line, image[axis]);
}

}  // namespace hardball
