// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/standard/number_text.hpp"

#include <algorithm>
#include <array>
#include <clocale>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "hardball/standard/ranges.hpp"

namespace hardball {
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
  return ranges::equal(text.substr(0, lower_case.size()), lower_case,
                       [](char a, char b) { return a == b || a - 'A' + 'a' == b; });
}

// A number in decimal: the digits, of which the first is not zero unless all are, and the power of ten of the
// first.
struct Decimal {
  std::string digits;
  int exponent = 0;
};

// The digits of a finite number that is not negative, rounded to so many.
Decimal rounded(double number, int digits) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.*e", digits - 1, number);
  Decimal made;
  const char* at = text.data();
  for (; *at != 'e'; ++at)
    if (*at >= '0' && *at <= '9') made.digits += *at;
  made.exponent = std::atoi(at + 1);
  return made;
}

std::string scientific(const Decimal& decimal) {
  std::string text = decimal.digits.substr(0, 1);
  if (decimal.digits.size() > 1) text += "." + decimal.digits.substr(1);
  std::array<char, 8> power;
  std::snprintf(power.data(), power.size(), "e%+03d", decimal.exponent);
  return text + power.data();
}

bool reads_as(const Decimal& decimal, double number) {
  double found = 0;
  const std::string text = scientific(decimal);
  from_chars_by_strtod(text.data(), text.data() + text.size(), found);
  return found == number;
}

// As few digits as read as the number, and of these the nearest to it.
Decimal shortest(double number) {
  for (int digits = 1;; ++digits) {
    Decimal decimal = rounded(number, digits);
    if (reads_as(decimal, number) || digits == Limits::max_digits10) return decimal;
    // Above a power of two more numbers are read as it than below: there, one digit more may do.
    if (decimal.digits.back() == '9') continue;
    ++decimal.digits.back();
    if (reads_as(decimal, number)) return decimal;
  }
}

std::string fixed(const Decimal& decimal, double number) {
  const int behind_point = static_cast<int>(decimal.digits.size()) - 1 - decimal.exponent;
  // A whole number has all its digits.
  if (behind_point <= 0) {
    std::array<char, 512> text;
    std::snprintf(text.data(), text.size(), "%.0f", number);
    return text.data();
  }
  if (decimal.exponent < 0)
    return "0." + std::string(static_cast<std::size_t>(-decimal.exponent - 1), '0') + decimal.digits;
  const auto whole = static_cast<std::size_t>(decimal.exponent) + 1;
  return decimal.digits.substr(0, whole) + "." + decimal.digits.substr(whole);
}

std::string shortest_text(double number) {
  if (std::isnan(number)) return "nan";
  if (std::isinf(number)) return "inf";
  if (number == 0) return "0";
  const Decimal decimal = shortest(number);
  const std::string with_power = scientific(decimal);
  const std::string plain = fixed(decimal, number);
  return plain.size() <= with_power.size() ? plain : with_power;
}

}  // namespace

std::to_chars_result to_chars_by_snprintf(char* first, char* last, double number) {
  const std::string text = (std::signbit(number) ? "-" : "") + shortest_text(std::fabs(number));
  if (static_cast<std::size_t>(last - first) < text.size()) return {last, std::errc::value_too_large};
  return {std::copy(text.begin(), text.end(), first), std::errc()};
}

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

}  // namespace hardball
