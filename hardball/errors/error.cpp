// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/errors/error.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "hardball/standard/number_text.hpp"

namespace hardball {

namespace {

// Whatever it quotes, a message is short enough to be read.
constexpr std::size_t kLongestPart = 4000;

}  // namespace

Error::Error(std::string what, std::string where, std::string remedy)
    : std::invalid_argument(shortened(where, kLongestPart) + ": " + shortened(what, kLongestPart) + "; " +
                            shortened(remedy, kLongestPart)),
      problem_(std::move(what)),
      where_(std::move(where)),
      remedy_(std::move(remedy)) {}

void report_broken_invariant(const char* condition, const char* file, int line) {
  throw BrokenInvariant(std::string("broken invariant: ") + condition + " (" + file + ":" +
                        std::to_string(line) + "); please report it with the scenario that shows it");
}

std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  std::size_t end = most - 3;
  // Not within a character of UTF-8.
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return std::string(text.substr(0, end)) + "...";
}

std::string to_text(double number) {
  if (std::isnan(number)) return "nan";  // whose sign says nothing
  std::array<char, 32> buffer;
  const auto [end, status] = to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  HARDBALL_CHECK(status == std::errc());
  return std::string(buffer.data(), end);
}

}  // namespace hardball
