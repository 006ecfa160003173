// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/column_names.hpp"

#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {
namespace {

// What programs call a quantity, normalized: the column, and the names in a row, the plainest first.
struct Scalar {
  std::string_view column;
  std::string_view names;
};

constexpr std::array<Scalar, 6> kScalars{{{"radius", "radius radii rad r"},
                                          {"diameter", "diameter diameters diam d"},
                                          {"mass", "mass masses m"},
                                          {"id", "id ids particleid particleidentifier atomid"},
                                          {"type", "type types particletype"},
                                          {"moment", "moment moments"}}};

// The names stand for the components of a vector if x, y or z, or the number of one, follows them.
struct Vector {
  std::array<std::string_view, kAxes> columns;
  std::string_view names;
};

constexpr std::array<std::string_view, kAxes> kPositionNames{"x", "y", "z"};
constexpr std::array<Vector, 4> kVectors{
    {{kPositionNames, "pos position positions point points coord coords coordinate coordinates center"},
     {{"vx", "vy", "vz"}, "v vel velo velocity velocities"},
     {{"omegax", "omegay", "omegaz"}, "omega angularvelocity angvel"},
     {{"ix", "iy", "iz"}, "i image images"}}};

// From how many letters on a name is a word, which may also follow the component.
constexpr std::size_t kWordLetters = 3;

// Without a unit in brackets at its end; an index in brackets is not a unit.
std::string_view without_unit(std::string_view name) {
  if (!name.ends_with(']') && !name.ends_with(')')) return name;
  const std::size_t open = name.find_last_of("[(");
  if (open == std::string_view::npos || open == 0) return name;
  const std::string_view inside = name.substr(open + 1, name.size() - open - 2);
  const bool is_component =
      inside.size() == 1 && std::string_view("012xyzXYZ").find(inside[0]) != std::string_view::npos;
  return is_component ? name : name.substr(0, open);
}

// Lower-case letters and digits alone.
std::string normalized(std::string_view name) {
  std::string text;
  for (const char c : without_unit(name)) {
    if (c >= 'A' && c <= 'Z') {
      text += static_cast<char>(c - 'A' + 'a');
    } else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
      text += c;
    }
  }
  return text;
}

class Renaming {
 public:
  Renaming(std::vector<Token> names, const TextLocation& where) : names_(std::move(names)), where_(where) {
    for (std::size_t i = 0; i < names_.size(); ++i) places_.emplace(normalized(names_[i].text), i);
  }

  // Gives the column of this normalized name another, unless there is one that has it.
  void rename(const std::string& text, std::string_view column) {
    const auto [first, last] = places_.equal_range(text);
    if (first == last || !named_.insert(column).second) return;
    if (std::next(first) != last) {
      const Token& second = names_[std::next(first)->second];
      throw Error("column '" + shortened(second.text) + "' appears twice", where_.text(second.offset),
                  "remove one of the two");
    }
    names_[first->second].text = column;
  }

  std::vector<Token> take() { return std::move(names_); }

 private:
  std::vector<Token> names_;
  const TextLocation& where_;
  std::multimap<std::string, std::size_t> places_;  // by normalized name
  std::set<std::string_view> named_;                // the columns that there are
};

}  // namespace

std::vector<Token> known_columns(std::vector<Token> names, const TextLocation& where) {
  Renaming renaming(std::move(names), where);
  for (const auto& [column, synonyms] : kScalars) {
    for (const Token& name : tokens_of(synonyms)) renaming.rename(std::string(name.text), column);
  }
  for (const std::string_view name : kPositionNames) renaming.rename(std::string(name), name);
  for (const auto& [columns, synonyms] : kVectors) {
    for (const Token& name : tokens_of(synonyms)) {
      const std::string text(name.text);
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        renaming.rename(text + "xyz"[axis], columns[axis]);
        renaming.rename(text + "012"[axis], columns[axis]);
        if (text.size() >= kWordLetters) renaming.rename("xyz"[axis] + text, columns[axis]);
      }
    }
  }
  return renaming.take();
}

}  // namespace hardball
