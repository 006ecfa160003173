// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/nearest_name.hpp"

#include <algorithm>
#include <vector>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

std::size_t distance(std::string_view a, std::string_view b) {
  // Entry j of a row: the distance of the first i letters of `a` from the first j of `b`; i grows row by row.
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before_last, last);
    std::swap(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replacement = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replacement});
      const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (exchanged) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string all_of(std::span<const std::string_view> names, char quote) {
  std::string all;
  for (const std::string_view name : names)
    all += (all.empty() ? "choose among " : ", ") + (quote + std::string(name) + quote);
  return all;
}

}  // namespace

std::string suggestion(std::string_view word, std::span<const std::string_view> names, char quote) {
  HARDBALL_CHECK(!names.empty());
  // A word this long is no misspelling, and takes time to compare.
  constexpr std::size_t kLongest = 100;
  if (word.size() > kLongest) return all_of(names, quote);
  const std::string_view nearest = *std::min_element(
      names.begin(), names.end(),
      [&](std::string_view a, std::string_view b) { return distance(word, a) < distance(word, b); });
  constexpr std::size_t kLettersPerEdit = 3;
  const std::size_t edits = std::max<std::size_t>(1, std::max(word.size(), nearest.size()) / kLettersPerEdit);
  if (distance(word, nearest) <= edits) return "did you mean " + (quote + std::string(nearest) + quote) + "?";
  return all_of(names, quote);
}

}  // namespace hardball
