// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "hardball/error.hpp"
#include "hardball/standard/number_text.hpp"

namespace hardball::cli {

/// Parses the whole text of an option as a number. Error: it is not one.
template <class Number>
Number parse_number(const std::string& text, const std::string& option, const std::string& remedy) {
  Number number{};
  const auto [end, status] = from_chars(text.data(), text.data() + text.size(), number);
  if (status == std::errc() && end == text.data() + text.size()) return number;
  throw Error("'" + shortened(text) + "' is not accepted", option, remedy);
}

}  // namespace hardball::cli
