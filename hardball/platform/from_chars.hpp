// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <type_traits>

namespace hardball::platform {

/// As std::from_chars, by the standard library's strtod: for libraries that lack it for floating-point
/// numbers, as those of macOS did. The locale may have any decimal point. Cost: an allocation.
std::from_chars_result from_chars_by_strtod(const char* first, const char* last, double& number);

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

}  // namespace hardball::platform
