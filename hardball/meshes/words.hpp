// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>

#include "hardball/errors/error.hpp"
#include "hardball/standard/number_text.hpp"

namespace hardball {

/// The words of a text, line by line, and errors that say where they are.
class Words {
 public:
  Words(std::string_view text, std::string where) : text_(text), where_(std::move(where)) {}

  /// Whether a line remains; makes it the present one.
  bool next_line() {
    if (position_ >= text_.size()) return false;
    std::size_t end = text_.find('\n', position_);
    if (end == std::string_view::npos) end = text_.size();
    rest_ = text_.substr(position_, end - position_);
    position_ = end + 1;
    ++line_;
    return true;
  }
  /// The next word of the present line; empty at its end.
  std::string_view next() {
    const auto begin = std::find_if_not(rest_.begin(), rest_.end(), is_blank);
    const auto end = std::find_if(begin, rest_.end(), is_blank);
    const std::string_view word = part_of_rest(begin, end);
    rest_ = part_of_rest(end, rest_.end());
    return word;
  }
  /// What is left of the line, without blanks around it.
  std::string_view rest_of_line() {
    const auto begin = std::find_if_not(rest_.begin(), rest_.end(), is_blank);
    const auto end = std::find_if_not(rest_.rbegin(), std::reverse_iterator(begin), is_blank).base();
    return part_of_rest(begin, end);
  }
  /// Where the next line begins, as an offset in the text.
  std::size_t position() const { return position_; }

  /// The next word as a number. Error: it is none.
  double number() { return number(next()); }
  /// A word as a number. Error: it is none.
  double number(std::string_view word) const { return parsed<double>(word); }
  /// A word as an integer. Error: it is none.
  std::int64_t integer(std::string_view word) const { return parsed<std::int64_t>(word); }

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(what, where_ + ", line " + to_text(line_), "correct the line, or write the file again");
  }

 private:
  using Place = std::string_view::const_iterator;

  std::string_view part_of_rest(Place begin, Place end) const {
    return rest_.substr(static_cast<std::size_t>(begin - rest_.begin()),
                        static_cast<std::size_t>(end - begin));
  }
  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  template <class Number>
  Number parsed(std::string_view word) const {
    // Some writers put a sign before positive numbers.
    if (word.starts_with('+')) word.remove_prefix(1);
    Number number{};
    const auto [end, failure] = from_chars(word.data(), word.data() + word.size(), number);
    if (failure != std::errc() || end != word.data() + word.size() || word.empty())
      fail("'" + std::string(word.substr(0, 40)) + "' is not a number");
    return number;
  }

  std::string_view text_;
  std::string where_;
  std::string_view rest_;
  std::size_t position_ = 0;
  std::size_t line_ = 0;
};

}  // namespace hardball
