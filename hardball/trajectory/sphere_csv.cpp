// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/standard/ranges.hpp"
#include "hardball/trajectory/text_formats.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/trajectory/append_text.hpp"
#include "hardball/trajectory/column_names.hpp"
#include "hardball/trajectory/sphere_columns.hpp"
#include "hardball/trajectory/sphere_types.hpp"

namespace hardball {
namespace {

constexpr char kComment = '#';

bool is_comment(std::string_view line) {
  return next_token(line, 0).text.starts_with(kComment);
}

// What separates the values of a line: the first of these that it has outside of quotes, or blanks.
char separator_of(std::string_view line, std::string_view choices) {
  for (const char choice : choices) {
    bool is_quoted = false;
    for (const char c : line) {
      if (c == '"') is_quoted = !is_quoted;
      if (c == choice && !is_quoted) return choice;
    }
  }
  return ' ';
}

// The value in quotes that begins at `at`, and the end of them. A quote in it stands twice.
Token quoted_value(std::string_view line, std::size_t& at, const TextLocation& location) {
  const std::size_t begin = at + 1;
  for (at = begin; at < line.size(); ++at) {
    if (line[at] != '"') continue;
    if (at + 1 == line.size() || line[at + 1] != '"') break;
    ++at;
  }
  if (at >= line.size())
    throw Error("the quote is never closed", location.text(begin - 1), "end the value with a quote");
  return {line.substr(begin, at++ - begin), begin};
}

// The values of a line, without blanks or quotes around them. Error, at the location: what is in quotes does
// not end, or is followed by more.
std::vector<Token> values_of(std::string_view line, char separator, const TextLocation& location) {
  const bool is_blank = separator == ' ';
  const std::string_view blanks = separator == '\t' ? " \r" : kBlanks;
  const auto past_blanks = [&](std::size_t from) {
    return std::min(line.find_first_not_of(blanks, from), line.size());
  };
  std::vector<Token> values;
  for (std::size_t at = past_blanks(0); !is_blank || at < line.size(); at = past_blanks(at)) {
    if (at < line.size() && line[at] == '"') {
      values.push_back(quoted_value(line, at, location));
      if (is_blank) continue;
      at = past_blanks(at);
      if (at < line.size() && line[at] != separator) {
        throw Error("there is '" + shortened(line.substr(at)) + "' after a value in quotes",
                    location.text(at), "separate the values");
      }
    } else {
      const std::size_t end = is_blank ? std::min(line.find_first_of(kBlanks, at), line.size())
                                       : std::min(line.find(separator, at), line.size());
      std::size_t last = end;
      while (last > at && blanks.find(line[last - 1]) != std::string_view::npos) --last;
      values.push_back({line.substr(at, last - at), at});
      at = end;
    }
    if (is_blank) continue;
    if (at >= line.size()) break;
    ++at;
  }
  return values;
}

SphereColumns columns_of(const std::string& line, char separator, const TextLocation& location) {
  return {known_columns(values_of(line, separator, location), location), location};
}

// The columns that a comment names, as NumPy and YADE write them: `# x y z radius`, `#format x_y_z_r`. A
// comment that names none is prose.
std::optional<SphereColumns> columns_in_comment(std::string_view line, const TextLocation& location) {
  std::string text(line);
  text[text.find(kComment)] = ' ';
  constexpr std::string_view kFormat = "format";
  char separator = separator_of(text, ";,\t");
  if (const Token first = next_token(text, 0); first.text == kFormat) {
    text.replace(first.offset, kFormat.size(), kFormat.size(), ' ');
    separator = '_';
  }
  try {
    return columns_of(text, separator, location);
  } catch (const Error&) {
    return std::nullopt;
  }
}

bool is_number(std::string text) {
  ranges::replace(text, ',', '.');
  double number = 0;
  return parse(std::string_view(text), number);
}

void skip_table(Lines& lines) {
  while (lines.next()) continue;
}

Snapshot read_table(Lines& lines) {
  std::optional<SphereColumns> columns;
  constexpr std::string_view kExcelHint = "sep=";
  while (is_comment(lines.line()) || lines.line().starts_with(kExcelHint)) {
    if (is_comment(lines.line())) {
      if (auto found = columns_in_comment(lines.line(), lines.location())) columns = std::move(found);
    }
    if (lines.next_text()) continue;
    throw Error("the file has only comments", lines.location().text(), csv_format().remedy);
  }
  const std::string first(lines.line());
  char separator = separator_of(first, ";,\t");
  const std::vector<Token> values = values_of(first, separator, lines.location());
  bool is_there = true;
  if (values.empty() || !is_number(std::string(next_token(values.front().text, 0).text))) {
    columns = columns_of(first, separator, lines.location());
    is_there = lines.next_text();
  } else if (columns) {
    // Where tabs separate numbers, commas are in them, and blanks may separate them, too.
    separator = separator_of(first, ";\t,");
    if (separator == '\t') separator = ' ';
  } else {
    throw Error("the first line has numbers, and no line before it names the columns",
                lines.location().text(), csv_format().remedy);
  }
  Snapshot snapshot;
  columns->describe(snapshot);
  for (; is_there; is_there = lines.next_text()) {
    if (is_comment(lines.line())) continue;
    std::string line(lines.line());
    if (separator != ',') ranges::replace(line, ',', '.');
    const std::vector<Token> numbers = values_of(line, separator, lines.location());
    if (separator == ',' && numbers.size() > columns->size()) {
      throw Error(
          "the line has " + to_text(numbers.size()) + " values for " + to_text(columns->size()) + " columns",
          lines.location().text(),
          "give one value for each column; where commas separate values, decimals need points");
    }
    columns->add(numbers, lines.location(), snapshot);
  }
  return snapshot;
}

void append_csv_head(const Snapshot& head, std::size_t /*spheres*/, const SphereTypes& types,
                     std::uint64_t /*frame*/, const AppendText& append) {
  append(std::string("id,type,x,y,z,vx,vy,vz,radius,mass,ix,iy,iz") +
         (types.are_finer_than_species() ? ",species_id" : "") +
         (head.has_spins ? ",omegax,omegay,omegaz,moment" : "") + "\n");
}

void append_csv_spheres(const Snapshot& snapshot, const SphereTypes& types, const AppendText& append) {
  const bool has_species = types.are_finer_than_species();
  std::string line;
  for (std::size_t i = 0; i < snapshot.spheres.size(); ++i) {
    const Sphere& sphere = snapshot.spheres[i];
    line.clear();
    append_text(line, snapshot.id(i));
    append_text(line, types.type_of(sphere) + 1);
    append_text(line, sphere.position);
    append_text(line, sphere.velocity);
    append_text(line, sphere.radius);
    append_text(line, sphere.mass);
    append_text(line, snapshot.image(i));
    if (has_species) append_text(line, sphere.species + 1);
    if (snapshot.has_spins) {
      append_text(line, sphere.spin);
      append_text(line, sphere.inertia_factor);
    }
    ranges::replace(line, ' ', ',');
    line.back() = '\n';
    append(line);
  }
}

}  // namespace

TextFrame csv_frame() {
  return {append_csv_head, append_csv_spheres};
}

TextFormat csv_format() {
  return {skip_table, read_table,
          "begin with a line that names the columns, such as x,y,z,vx,vy,vz,radius or x,y,z,radius"};
}

}  // namespace hardball
