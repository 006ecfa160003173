// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <istream>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "hardball/errors/language.hpp"
#include "hardball/standard/number_text.hpp"

namespace hardball {

/// A location in the text being read, for messages.
struct TextLocation {
  std::string name;
  std::size_t line = 0;  ///< From 1 on; zero stands for the file as a whole.

  std::string text() const;
  std::string text(std::size_t offset) const;
};

/// A token of a line and its offset.
struct Token {
  std::string_view text;
  std::size_t offset = 0;
};

/// What separates the tokens of a line.
inline constexpr std::string_view kBlanks = " \t\r";

/// The next token from `offset` on; empty at the end of the line.
Token next_token(std::string_view line, std::size_t offset);

/// All tokens of a line.
std::vector<Token> tokens_of(std::string_view line);

/// Whether a text is a number, which it then becomes. Real numbers may have an exponent as Fortran writes it,
/// 1d-5.
template <class Number>
bool parse(std::string_view text, Number& number) {
  if constexpr (std::is_floating_point_v<Number>) {
    constexpr std::size_t kLongest = 40;
    const std::size_t exponent = text.find_first_of("dD");
    if (exponent != std::string_view::npos && exponent > 0 && text.size() <= kLongest) {
      std::string with_e(text);
      with_e[exponent] = 'e';
      return parse(std::string_view(with_e), number);
    }
  }
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, status] = from_chars(text.data(), text.data() + text.size(), number);
  return status == std::errc() && end == text.data() + text.size();
}

/// The token as a finite number, named in messages. Error, at its location: it is not one.
double parse_real(const Token& token, std::string_view name, const TextLocation& location);
/// The token as an integer, named in messages. Error, at its location: it is not one.
std::int64_t parse_integer(const Token& token, std::string_view name, const TextLocation& location);
/// The token as a mass, which may be "inf". Error, at its location: it is not one.
double parse_mass(const Token& token, const TextLocation& location);
/// The species of a type: types count from one; beyond what species there may be, they mean something else.
std::uint8_t species_of_type(std::int64_t type);

/// Reads a text line by line, counting lines, in bounded memory. A byte order mark at its beginning is not
/// part of the first line.
class Lines {
 public:
  /// `name` stands for the text in messages. Lines that begin with `comment_mark`, if it is not zero, are
  /// counted, but passed over.
  Lines(std::unique_ptr<std::istream> in, std::string name, char comment_mark = '\0');

  /// Reads the next line; false at the end. Error: a line is longer than a megabyte; the text is encoded in
  /// UTF-16.
  bool next();
  /// Reads on to a line that is not blank; false at the end.
  bool next_text();
  bool is_blank() const { return line_.find_first_not_of(kBlanks) == std::string_view::npos; }
  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }
  TextLocation location() const { return {name_, number_}; }
  const std::string& name() const { return name_; }

 private:
  bool next_of_any_kind();

  std::unique_ptr<std::istream> in_;
  std::string name_;
  char comment_mark_;
  std::unique_ptr<char[]> buffer_;
  std::string_view line_;
  std::size_t number_ = 0;
};

/// Reads the next line of a frame. Error: there is none.
void need_line(Lines& lines);
/// Error: the text ends after `found` of the `count` spheres of a frame.
[[noreturn]] void report_end(const Lines& lines, std::size_t count, std::size_t found);

/// Opens a text from its start.
using OpenText = std::function<std::unique_ptr<std::istream>()>;

}  // namespace hardball
