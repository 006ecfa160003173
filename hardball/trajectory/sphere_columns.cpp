// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/sphere_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

using enum SphereColumn;

constexpr std::array<SphereColumn, 3> kPosition{x, y, z};
constexpr std::array<SphereColumn, 3> kVelocity{vx, vy, vz};
constexpr std::array<SphereColumn, 3> kImage{ix, iy, iz};
constexpr std::array<SphereColumn, 3> kSpin{omegax, omegay, omegaz};

// An integer, perhaps written as a real number, as programs do that have nothing but these.
std::int64_t whole_number(const Token& token, const std::string& name, const TextLocation& location) {
  constexpr double kMax = 0x1p53;
  double number = 0;
  if (parse(token.text, number) && std::fabs(number) <= kMax && std::trunc(number) == number &&
      token.text.find('.') != std::string_view::npos) {
    return static_cast<std::int64_t>(number);
  }
  return parse_integer(token, name, location);
}

std::string name_of(SphereColumn column) {
  return std::string(kSphereColumnNames[static_cast<std::size_t>(column)]);
}

}  // namespace

SphereColumns::SphereColumns(std::span<const Token> names, const TextLocation& where) : count_(names.size()) {
  for (const Token& name : names) names_.emplace_back(name.text);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto known = ranges::find(kSphereColumnNames, names[i].text);
    if (known == kSphereColumnNames.end()) continue;
    std::optional<std::size_t>& index = index_[static_cast<std::size_t>(known - kSphereColumnNames.begin())];
    if (index) {
      throw Error("column '" + shortened(names[i].text) + "' appears twice", where.text(names[i].offset),
                  "remove one of the two");
    }
    index = i;
  }
  const auto need = [&](SphereColumn column) {
    if (has(column)) return;
    throw Error("there is no column '" + name_of(column) + "'", where.text(),
                "name the columns, among them x, y, z and radius, and vx, vy, vz if there are velocities");
  };
  for (const SphereColumn column : kPosition) need(column);
  if (!has(diameter)) need(radius);
  for (const auto& group : {kVelocity, kImage, kSpin}) {
    if (ranges::any_of(group, [&](SphereColumn column) { return has(column); }))
      ranges::for_each(group, need);
  }
}

void SphereColumns::add(std::span<const Token> values, const TextLocation& location,
                        Snapshot& snapshot) const {
  if (values.size() != count_) {
    throw Error("the line has " + to_text(values.size()) + " values for " + to_text(count_) + " columns",
                location.text(), "give one value for each column");
  }
  const std::size_t mass_index = has(mass) ? at(mass) : count_;
  add(
      snapshot, location.text(),
      [&](std::size_t column) {
        return column == mass_index ? parse_mass(values[column], location)
                                    : parse_real(values[column], names_[column], location);
      },
      [&](std::size_t column) { return whole_number(values[column], names_[column], location); });
  snapshot.lines.push_back(location.line);
}

std::int32_t SphereColumns::box_count(std::int64_t number, const std::string& location) {
  using Limits = std::numeric_limits<std::int32_t>;
  if (number >= Limits::min() && number <= Limits::max()) return static_cast<std::int32_t>(number);
  throw Error("an image is " + to_text(number) + " boxes away", location, "give a smaller number of boxes");
}

}  // namespace hardball
