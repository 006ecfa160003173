// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/motions/keyframes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/motions/check_motion.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/trajectory/text_lines.hpp"

namespace hardball {
namespace {

constexpr double kJoint = 1e-12;  // how far the ends of a motion that repeats may be apart

std::string knot(std::size_t row, const Keyframe& frame) {
  return "knot " + to_text(row) + " (t = " + to_text(frame.time) + ")";
}

void check_times(const std::vector<Keyframe>& rows) {
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const double time = rows[row].time;
    check_finite(time, "the time of knot " + to_text(row), "keyframes");
    if (row == 0 && time < 0) {
      throw Error(knot(row, rows[row]) + " is before the motion begins", "keyframes",
                  "let times count from the begin of the motion");
    }
    if (row > 0 && !(time > rows[row - 1].time)) {
      throw Error(knot(row, rows[row]) + " is not later than " + knot(row - 1, rows[row - 1]), "keyframes",
                  "let times increase");
    }
  }
}

void check_joint(const std::vector<Keyframe>& rows) {
  if (rows.size() < 2) throw Error("a motion of one knot repeats", "keyframes", "give it two knots or more");
  const Vec3 gap = rows.back().position - rows.front().position;
  const double widest = std::max({std::fabs(gap.x), std::fabs(gap.y), std::fabs(gap.z)});
  if (widest <= kJoint) return;
  throw Error("the motion repeats, and " + knot(rows.size() - 1, rows.back()) + " is " + to_text(widest) +
                  " away from the first one",
              "keyframes", "let it end where it begins, or do not repeat it");
}

// Turns what may stand between numbers into blanks.
std::string spaced(std::string_view line) {
  std::string text(line);
  ranges::replace_if(
      text, [](char c) { return c == ',' || c == ';'; }, ' ');
  return text;
}

std::vector<Keyframe> read_rows(Lines& lines, std::size_t dimensions) {
  constexpr std::array<std::string_view, 1 + kAxes> kColumns{"t", "x", "y", "z"};
  std::vector<Keyframe> rows;
  bool is_first = true;
  while (lines.next_text()) {
    const std::string text = spaced(lines.line());
    const std::vector<Token> tokens = tokens_of(text);
    double first = 0;
    // The names of the columns.
    if (std::exchange(is_first, false) && !tokens.empty() && !parse(tokens[0].text, first)) continue;
    const bool is_whole = tokens.size() == 1 + kAxes || (dimensions == 2 && tokens.size() == 3);
    if (!is_whole) {
      throw Error("there are " + to_text(tokens.size()) + " values", lines.location().text(),
                  dimensions == 2 ? "give t, x and y" : "give t, x, y and z");
    }
    std::array<double, 1 + kAxes> numbers{};
    for (std::size_t i = 0; i < tokens.size(); ++i)
      numbers[i] = parse_real(tokens[i], kColumns[i], lines.location());
    const Keyframe frame{numbers[0], {numbers[1], numbers[2], numbers[3]}};
    if (!rows.empty() && !(frame.time > rows.back().time)) {
      throw Error(knot(rows.size(), frame) + " is not later than " + knot(rows.size() - 1, rows.back()),
                  lines.location().text(), "let times increase");
    }
    rows.push_back(frame);
  }
  if (rows.empty()) throw Error("there are no rows", lines.name(), "give lines of t, x, y and z");
  return rows;
}

}  // namespace

Keyframes::Keyframes(std::vector<Keyframe> rows, bool repeats) : rows_(std::move(rows)), repeats_(repeats) {
  constexpr std::size_t kMost = std::size_t{1} << 31;
  if (rows_.empty() || rows_.size() > kMost)
    throw Error("there are " + to_text(rows_.size()) + " knots", "keyframes", "give one to 2^31");
  check_times(rows_);
  for (const Keyframe& row : rows_) check_motion_vector(row.position, "the position of a knot");
  if (repeats) check_joint(rows_);
}

Vec3 Keyframes::span() const {
  Vec3 span;
  for (const Keyframe& row : rows_) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (row.position[axis] != rows_.front().position[axis]) span[axis] = 1;
    }
  }
  return span;
}

std::vector<Keyframe> read_keyframes(const std::filesystem::path& file, std::size_t dimensions) {
  auto in = std::make_unique<std::ifstream>(file, std::ios::binary);
  if (!*in || !std::filesystem::is_regular_file(file))
    throw Error("the file cannot be read", file.string(), "name a file of lines of t, x, y and z");
  Lines lines(std::move(in), file.string(), '#');
  return read_rows(lines, dimensions);
}

std::vector<Keyframe> parse_keyframes(std::string_view text, const std::string& name,
                                      std::size_t dimensions) {
  Lines lines(std::make_unique<std::istringstream>(std::string(text)), name, '#');
  return read_rows(lines, dimensions);
}

}  // namespace hardball
