// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <type_traits>
#include <version>

namespace hardball {

/// As std::from_chars, by the standard library's strtod: for libraries that lack it for floating-point
/// numbers, as those of macOS did. The locale may have any decimal point. Cost: an allocation.
std::from_chars_result from_chars_by_strtod(const char* first, const char* last, double& number);

/// As std::to_chars, by the standard library's snprintf. Cost: up to 17 attempts.
std::to_chars_result to_chars_by_snprintf(char* first, char* last, double number);

/// std::from_chars.
template <class Number>
std::from_chars_result from_chars(const char* first, const char* last, Number& number) {
#if !defined(__cpp_lib_to_chars)
  if constexpr (std::is_floating_point_v<Number>) {
    static_assert(std::is_same_v<Number, double>);
    return from_chars_by_strtod(first, last, number);
  } else {
    return std::from_chars(first, last, number);
  }
#else
  return std::from_chars(first, last, number);
#endif
}

/// std::to_chars: the shortest text from which from_chars reads the same number.
template <class Number>
std::to_chars_result to_chars(char* first, char* last, Number number) {
#if !defined(__cpp_lib_to_chars)
  if constexpr (std::is_floating_point_v<Number>) {
    static_assert(std::is_same_v<Number, double>);
    return to_chars_by_snprintf(first, last, number);
  } else {
    return std::to_chars(first, last, number);
  }
#else
  return std::to_chars(first, last, number);
#endif
}

}  // namespace hardball
