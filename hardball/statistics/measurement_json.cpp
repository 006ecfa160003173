// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/statistics/measurement_json.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

std::string json(double number) {
  return std::isfinite(number) ? to_text(number) : "null";
}

std::string json(bool is_so) {
  return is_so ? "true" : "false";
}

std::string json(const std::string& text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string quoted = "\"";
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (code < 0x20) {
      quoted += "\\u00";
      quoted += kDigits[code / 16];
      quoted += kDigits[code % 16];
      continue;
    }
    if (letter == '"' || letter == '\\') quoted += '\\';
    quoted += letter;
  }
  return quoted + "\"";
}

std::string json(ColumnRole role) {
  constexpr std::array<const char*, 4> kRoles{"argument", "value", "error", "theory"};
  return json(std::string(kRoles[static_cast<std::size_t>(role)]));
}

std::string json(const Quantity& quantity);
std::string json(const Column& column);
std::string json(const Measurement& measurement);

template <class Values>
std::string json_list(const Values& values) {
  std::string text;
  for (const auto& value : values) text += (text.empty() ? "" : ",") + json(value);
  return "[" + text + "]";
}

// An object of members, each a name and its value in JSON.
std::string json_object(std::initializer_list<std::pair<const char*, std::string>> members) {
  std::string text;
  for (const auto& [name, value] : members) {
    text += text.empty() ? "" : ",";
    text += json(std::string(name)) + ":" + value;
  }
  return "{" + text + "}";
}

std::string json(const Quantity& quantity) {
  return json_object({{"name", json(quantity.name)},
                      {"unit", json(quantity.unit)},
                      {"value", json(quantity.value)},
                      {"error", json(quantity.error)},
                      {"theory", json(quantity.theory)},
                      {"tolerance", json(quantity.tolerance)},
                      {"reason", json(quantity.reason)}});
}

std::string json(const Column& column) {
  return json_object({{"name", json(column.name)},
                      {"unit", json(column.unit)},
                      {"role", json(column.role)},
                      {"values", json_list(column.values)}});
}

std::string json(const Measurement& measurement) {
  return json_object({{"name", json(measurement.name)},
                      {"title", json(measurement.title)},
                      {"formula", json(measurement.formula)},
                      {"source", json(measurement.source)},
                      {"quantities", json_list(measurement.quantities)},
                      {"columns", json_list(measurement.columns)},
                      {"duration", json(measurement.duration)},
                      {"transient", json(measurement.transient)},
                      {"transient_over", json(measurement.is_transient_over)},
                      {"unsettled", json(measurement.unsettled)},
                      {"logarithmic_in_argument", json(measurement.is_logarithmic_in_argument)},
                      {"logarithmic_in_value", json(measurement.is_logarithmic_in_value)}});
}

}  // namespace

std::string measurements_json(std::span<const Measurement> measurements) {
  return json_list(measurements);
}

}  // namespace hardball
