// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/xml_text.hpp"

#include <cstddef>

namespace hardball {
namespace {

// The code point at the start of a text, and its length in bytes; none if that is not UTF-8.
struct CodePoint {
  char32_t value = 0;
  std::size_t size = 0;
};

CodePoint first_code_point(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t size = lead >= 0xc2 && lead < 0xe0 ? 2
                           : (lead & 0xf0) == 0xe0     ? 3
                           : (lead & 0xf8) == 0xf0     ? 4
                                                       : 0;
  if (size == 0 || size > text.size()) return {};
  char32_t value = lead & (0xffU >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    value = value << 6 | (byte(i) & 0x3fU);
  }
  const bool is_overlong = (size == 3 && value < 0x800) || (size == 4 && value < 0x10000);
  const bool is_surrogate = value >= 0xd800 && value < 0xe000;
  if (is_overlong || is_surrogate || value > 0x10ffff) return {};
  return {value, size};
}

bool is_allowed(char32_t value) {
  if (value < ' ') return value == '\t' || value == '\n';
  return value != 0xfffe && value != 0xffff;
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const CodePoint point = first_code_point(text);
    if (point.size == 0) {
      result += "\uFFFD";
      text.remove_prefix(1);
      continue;
    }
    switch (point.value) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        if (is_allowed(point.value)) result += text.substr(0, point.size);
    }
    text.remove_prefix(point.size);
  }
  return result;
}

}  // namespace hardball
