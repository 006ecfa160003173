// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/platform/from_chars.hpp"

#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace hardball::platform {
namespace {

using Limits = std::numeric_limits<double>;

// The length of the longest decimal number at the begin of a text; zero if there is none.
std::size_t decimal_length(std::string_view text) {
  const auto behind_digits = [&](std::size_t at) {
    return std::min(text.find_first_not_of("0123456789", at), text.size());
  };
  const auto has = [&](std::size_t at, std::string_view any) {
    return at < text.size() && any.find(text[at]) != std::string_view::npos;
  };
  const std::size_t begin = has(0, "-") ? 1 : 0;
  std::size_t end = behind_digits(begin);
  std::size_t digits = end - begin;
  if (has(end, ".")) {
    const std::size_t end_of_fraction = behind_digits(end + 1);
    digits += end_of_fraction - end - 1;
    end = end_of_fraction;
  }
  if (digits == 0) return 0;
  if (has(end, "eE")) {
    const std::size_t power = has(end + 1, "+-") ? end + 2 : end + 1;
    if (const std::size_t end_of_power = behind_digits(power); end_of_power > power) end = end_of_power;
  }
  return end;
}

bool begins_with(std::string_view text, std::string_view lower_case) {
  return std::ranges::equal(text.substr(0, lower_case.size()), lower_case,
                            [](char a, char b) { return a == b || a - 'A' + 'a' == b; });
}

}  // namespace

std::from_chars_result from_chars_by_strtod(const char* first, const char* last, double& number) {
  const std::string_view all(first, static_cast<std::size_t>(last - first));
  std::string text(all.substr(0, decimal_length(all)));
  if (text.empty()) {
    const std::size_t sign = all.starts_with('-') ? 1 : 0;
    using Name = std::pair<std::string_view, double>;
    for (const auto& [name, value] : {Name("infinity", Limits::infinity()), Name("inf", Limits::infinity()),
                                      Name("nan", Limits::quiet_NaN())}) {
      if (!begins_with(all.substr(sign), name)) continue;
      number = sign > 0 ? -value : value;
      return {first + sign + name.size(), std::errc()};
    }
    return {first, std::errc::invalid_argument};
  }
  const char* const end = first + text.size();
  if (const std::size_t dot = text.find('.'); dot != std::string::npos)
    text.replace(dot, 1, std::localeconv()->decimal_point);
  const double found = std::strtod(text.c_str(), nullptr);
  // Only too large numbers, and those too near to zero, are found to be these.
  const bool is_zero = text.find_first_of("123456789") >= text.find_first_of("eE");
  if (std::isinf(found) || (found == 0 && !is_zero)) return {end, std::errc::result_out_of_range};
  number = found;
  return {end, std::errc()};
}

}  // namespace hardball::platform
