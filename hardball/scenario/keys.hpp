// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/describe/field.hpp"

namespace hardball {

/// The shapes of walls that are meshes: of a file, or of a few triangles.
inline constexpr std::array<std::string_view, 5> kMeshShapes{"mesh", "box", "capsule", "plate",
                                                             "height_field"};

/// The shapes of walls that stand for several surfaces.
inline constexpr std::array<std::string_view, 3> kJoinedShapes{"truncated_cone", "shell", "annulus"};

/// What a value is.
enum class ValueType {
  number,
  numbers,        ///< A list.
  named_numbers,  ///< A table of numbers, whose keys are names.
  integer,
  truth,    ///< true or false.
  text,     ///< A string that is not empty.
  texts,    ///< A list of such strings.
  choice,   ///< One of several strings.
  choices,  ///< A list of some of them.
  some,     ///< One of several strings, or a list of some of them.
  vector,   ///< Three numbers, or two in two dimensions.
  vectors,  ///< A list of vectors.
  table,
  tables,  ///< One or more tables of the same name, [[name]].
};

struct TableDescription;

/// A key of a scenario: the one source of what the reader accepts, of docs/scenarios.md and of the JSON
/// Schema.
struct KeyDescription {
  std::string_view name;
  ValueType type = ValueType::number;
  NumberRange range = NumberRange::finite;
  std::uint64_t least = 0;                     ///< Least value of an integer.
  std::uint64_t most = 0;                      ///< Greatest value of an integer.
  std::vector<std::string_view> choices = {};  ///< In the order of the enumeration that they stand for.
  std::string_view dimension = {};             ///< Such as "L/T"; nothing for pure numbers.
  bool is_required = false;
  std::string_view default_value = {};  ///< As in TOML; nothing if none can be written.
  std::string meaning = {};             ///< A sentence without its full stop.
  std::string_view example = {};        ///< A value as in TOML.
  /// The choices of the table's first key that the key goes with, all if there are none. Keys of one name
  /// that go with different choices may differ.
  std::vector<std::string_view> only_for = {};
  /// The keys of a table; for another type, a table that may be given instead.
  std::shared_ptr<const TableDescription> table = {};
};

/// A table of a scenario.
struct TableDescription {
  std::string title;  ///< In messages: "[box]"; nothing for the scenario as a whole.
  std::vector<KeyDescription> keys;
  /// Groups of keys: exactly one key of each group must be given.
  std::vector<std::vector<std::string_view>> one_of = {};

  /// The key of this name that goes with this choice of the first key; null if there is none.
  const KeyDescription* find(std::string_view name, std::string_view choice = {}) const;
  /// Whether some keys go only with some choices of the first key.
  bool has_variants() const;
  /// The names of all keys, each once.
  std::vector<std::string_view> names() const;
};

/// All tables of a scenario, each a key of this one.
const TableDescription& scenario_keys();

/// What a key's value may be, for people: "positive number [L]".
std::string values_of(const KeyDescription& key);

}  // namespace hardball
