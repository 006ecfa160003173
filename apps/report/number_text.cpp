// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/report/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hardball::report {
namespace {

constexpr std::string_view kNone = "–";
constexpr std::string_view kMinus = "−";

// Beyond these, a power of ten is split off.
constexpr int kLeastExponent = -4;
constexpr int kMaxExponent = 5;
constexpr int kMaxExactExponent = 8;  // of a number all of whose digits count

std::string raised(std::string_view digits) {
  constexpr std::array<std::string_view, 10> kRaised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : digits) {
    if (c == '-') text += "⁻";
    if (c >= '0' && c <= '9') text += kRaised[static_cast<std::size_t>(c - '0')];
  }
  return text;
}

std::string with_true_minus(std::string text) {
  if (text.starts_with('-')) text.replace(0, 1, kMinus);
  return text;
}

std::string without_end_zeros(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string power_of_ten(int exponent) {
  return "10" + raised(std::to_string(exponent));
}

// The exponent of the first digit once the number is rounded to `digits` digits. Precondition: not zero.
int exponent_of(double value, int digits) {
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);
  return std::stoi(text.substr(text.find('e') + 1));
}

}  // namespace

std::string number_text(double value, int digits) {
  if (std::isnan(value)) return std::string(kNone);
  if (std::isinf(value)) return value > 0 ? "∞" : std::string(kMinus) + "∞";
  if (value == 0) return "0";
  const int exponent = exponent_of(value, digits);
  if (exponent >= kLeastExponent && exponent <= kMaxExponent) {
    return with_true_minus(
        without_end_zeros(fmt::format("{:.{}f}", value, std::max(0, digits - 1 - exponent))));
  }
  std::string text = fmt::format("{:.{}e}", value, digits - 1);
  text.erase(text.find('e'));
  return with_true_minus(without_end_zeros(text)) + "·" + power_of_ten(exponent);
}

std::string count_text(std::uint64_t count) {
  std::string text = std::to_string(count);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
  return text;
}

bool is_known_error(double value, double error) {
  constexpr double kRounding = 1e-12;
  return std::isfinite(error) && error > kRounding * std::abs(value);
}

std::string measured_text(double value, double error) {
  constexpr int kErrorDigits = 2;
  if (!std::isfinite(value) || !is_known_error(value, error)) return number_text(value);
  const int error_exponent = exponent_of(error, kErrorDigits);
  const int exponent =
      value == 0 ? error_exponent : std::max(exponent_of(value, kErrorDigits), error_exponent);
  // Split off as well if the last digit of the error is left of the point.
  const bool is_plain =
      exponent >= kLeastExponent && exponent <= kMaxExactExponent && error_exponent < kErrorDigits;
  const int shift = is_plain ? 0 : exponent;
  const int decimals = std::max(0, kErrorDigits - 1 - (error_exponent - shift));
  const double scale = std::pow(10, shift);
  // An error beyond one keeps its point: "123.4(5.6)".
  const double unit = error_exponent - shift < 0 ? std::pow(10, -decimals) : 1;
  const std::string text = with_true_minus(fmt::format("{:.{}f}", value / scale, decimals)) +
                           fmt::format("({:.{}f})", error / scale / unit, unit == 1 ? decimals : 0);
  return is_plain ? text : text + "·" + power_of_ten(shift);
}

std::string deviation_text(double value, double error, double theory) {
  const double difference = value - theory;
  if (is_known_error(value, error) && std::isfinite(difference)) {
    const std::string text = fmt::format("{:+.1f} σ", difference / error);
    return text.substr(1) == "0.0 σ" ? text.substr(1) : with_true_minus(text);
  }
  if (std::isfinite(difference / theory)) {
    const double percent = 100 * difference / std::abs(theory);
    const std::string sign = percent > 0 ? "+" : "";
    return sign +
           (std::abs(percent) < 1 ? number_text(percent, 2)
                                  : with_true_minus(fmt::format("{:.1f}", percent))) +
           "%";
  }
  return std::string(kNone);
}

std::string unit_text(std::string_view unit) {
  if (unit == "1") return {};
  std::string text;
  while (!unit.empty()) {
    if (unit.front() != '^') {
      text += unit.front();
      unit.remove_prefix(1);
      continue;
    }
    const std::size_t end = std::min(unit.find_first_not_of("-0123456789", 1), unit.size());
    text += raised(unit.substr(1, end - 1));
    unit.remove_prefix(end);
  }
  return text;
}

std::string bytes_text(double bytes) {
  constexpr std::array<std::string_view, 4> kUnits = {"B", "kB", "MB", "GB"};
  std::size_t unit = 0;
  while (bytes >= 1000 && unit + 1 < kUnits.size()) {
    bytes /= 1000;
    ++unit;
  }
  return number_text(bytes, 3) + " " + std::string(kUnits[unit]);
}

std::string rate_text(double rate) {
  const double power = rate > 1000 ? std::pow(10, std::floor(std::log10(rate)) - 2) : 0;
  return power > 0 ? count_text(static_cast<std::uint64_t>(std::llround(std::round(rate / power) * power)))
                   : number_text(rate, 3);
}

std::string seconds_text(double seconds) {
  if (!(seconds >= 100)) return number_text(seconds, 3) + " s";
  const auto whole = static_cast<std::uint64_t>(std::llround(seconds));
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace hardball::report
