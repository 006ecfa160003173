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

// What programs call a quantity, normalized.
struct Synonym {
  std::string_view text;
  std::string_view column;
};

// For each column the plainest name first.
constexpr std::array<Synonym, 21> kScalarSynonyms{{{"radius", "radius"},
                                                   {"radii", "radius"},
                                                   {"rad", "radius"},
                                                   {"r", "radius"},
                                                   {"diameter", "diameter"},
                                                   {"diameters", "diameter"},
                                                   {"diam", "diameter"},
                                                   {"d", "diameter"},
                                                   {"mass", "mass"},
                                                   {"masses", "mass"},
                                                   {"m", "mass"},
                                                   {"id", "id"},
                                                   {"ids", "id"},
                                                   {"particleid", "id"},
                                                   {"particleidentifier", "id"},
                                                   {"atomid", "id"},
                                                   {"type", "type"},
                                                   {"types", "type"},
                                                   {"particletype", "type"},
                                                   {"moment", "moment"},
                                                   {"moments", "moment"}}};

// The components of which vector a name stands for, if x, y or z, or the number of one, follows it.
struct VectorSynonym {
  std::string_view text;
  std::array<std::string_view, kAxes> columns;
};

constexpr std::array<std::string_view, kAxes> kPositionNames{"x", "y", "z"};
constexpr std::array<std::string_view, kAxes> kVelocityNames{"vx", "vy", "vz"};
constexpr std::array<std::string_view, kAxes> kSpinNames{"omegax", "omegay", "omegaz"};
constexpr std::array<std::string_view, kAxes> kImageNames{"ix", "iy", "iz"};
constexpr std::array<VectorSynonym, 22> kVectorSynonyms{
    {{"", kPositionNames},           {"pos", kPositionNames},
     {"position", kPositionNames},   {"positions", kPositionNames},
     {"point", kPositionNames},      {"points", kPositionNames},
     {"coord", kPositionNames},      {"coords", kPositionNames},
     {"coordinate", kPositionNames}, {"coordinates", kPositionNames},
     {"center", kPositionNames},     {"v", kVelocityNames},
     {"vel", kVelocityNames},        {"velo", kVelocityNames},
     {"velocity", kVelocityNames},   {"velocities", kVelocityNames},
     {"omega", kSpinNames},          {"angularvelocity", kSpinNames},
     {"angvel", kSpinNames},         {"i", kImageNames},
     {"image", kImageNames},         {"images", kImageNames}}};

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
  for (const auto& [text, column] : kScalarSynonyms) renaming.rename(std::string(text), column);
  for (const auto& [text, columns] : kVectorSynonyms) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      renaming.rename(std::string(text) + "xyz"[axis], columns[axis]);
      if (!text.empty()) renaming.rename(std::string(text) + "012"[axis], columns[axis]);
      if (text.size() >= kWordLetters) renaming.rename("xyz"[axis] + std::string(text), columns[axis]);
    }
  }
  return renaming.take();
}

}  // namespace hardball
