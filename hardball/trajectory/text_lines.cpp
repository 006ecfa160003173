// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/text_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

constexpr std::streamsize kLongestLine = 1 << 20;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kLittleEndianMark = "\xFF\xFE";
constexpr std::string_view kBigEndianMark = "\xFE\xFF";
constexpr const char* kRemedyOfCut = "remove the incomplete frame, or convert an earlier one with --frame";

}  // namespace

std::string TextLocation::text() const {
  return line == 0 ? name : name + ":" + to_text(line);
}

std::string TextLocation::text(std::size_t offset) const {
  return line == 0 ? name : text() + ":" + to_text(offset + 1);
}

Token next_token(std::string_view line, std::size_t offset) {
  const std::size_t begin = std::min(line.find_first_not_of(kBlanks, offset), line.size());
  const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
  return {line.substr(begin, end - begin), begin};
}

std::vector<Token> tokens_of(std::string_view line) {
  std::vector<Token> tokens;
  std::size_t at = 0;
  for (Token token = next_token(line, at); !token.text.empty(); token = next_token(line, at)) {
    tokens.push_back(token);
    at = token.offset + token.text.size();
  }
  return tokens;
}

double parse_real(const Token& token, std::string_view name, const TextLocation& location) {
  double number = 0;
  if (parse(token.text, number) && std::isfinite(number)) return number;
  const bool has_comma = token.text.find(',') != std::string_view::npos;
  throw Error(std::string(name) + " is '" + shortened(token.text) + "'", location.text(token.offset),
              has_comma ? "give a finite number, with a point before its decimals" : "give a finite number");
}

std::int64_t parse_integer(const Token& token, std::string_view name, const TextLocation& location) {
  std::int64_t number = 0;
  if (parse(token.text, number)) return number;
  throw Error(std::string(name) + " is '" + shortened(token.text) + "'", location.text(token.offset),
              "give an integer");
}

double parse_mass(const Token& token, const TextLocation& location) {
  return token.text == "inf" ? std::numeric_limits<double>::infinity() : parse_real(token, "mass", location);
}

std::uint8_t species_of_type(std::int64_t type) {
  constexpr std::int64_t kMaxTypes = std::numeric_limits<std::uint8_t>::max() + 1;
  return type >= 1 && type <= kMaxTypes ? static_cast<std::uint8_t>(type - 1) : std::uint8_t{0};
}

Lines::Lines(std::unique_ptr<std::istream> in, std::string name, char comment_mark)
    : in_(std::move(in)),
      name_(std::move(name)),
      comment_mark_(comment_mark),
      buffer_(new char[kLongestLine]) {}

bool Lines::next() {
  while (next_of_any_kind()) {
    if (comment_mark_ == '\0' || !next_token(line_, 0).text.starts_with(comment_mark_)) return true;
  }
  return false;
}

bool Lines::next_of_any_kind() {
  in_->getline(buffer_.get(), kLongestLine);
  const auto read = static_cast<std::size_t>(in_->gcount());
  if (read == 0) return false;
  ++number_;
  if (in_->fail()) {
    throw Error("the line is longer than a megabyte", location().text(),
                "give a text file with a line for each sphere");
  }
  // The end of the line is read, but not stored; the last line may lack it.
  line_ = {buffer_.get(), in_->eof() ? read : read - 1};
  if (number_ > 1) return true;
  if (line_.starts_with(kLittleEndianMark) || line_.starts_with(kBigEndianMark))
    throw Error("the text is encoded in UTF-16", location().text(), "save it in UTF-8");
  if (line_.starts_with(kByteOrderMark)) line_.remove_prefix(kByteOrderMark.size());
  return true;
}

bool Lines::next_text() {
  while (next()) {
    if (!is_blank()) return true;
  }
  return false;
}

void need_line(Lines& lines) {
  if (lines.next()) return;
  throw Error("the file ends within a frame", lines.location().text(), kRemedyOfCut);
}

void report_end(const Lines& lines, std::size_t count, std::size_t found) {
  throw Error(
      "the file ends after " + to_text(found) + " of the " + to_text(count) + " spheres of its last frame",
      lines.location().text(), kRemedyOfCut);
}

}  // namespace hardball
