// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace hardball {

/// A location in a file or an override.
struct Location {
  std::uint32_t origin = 0;  ///< 0 the file, i + 1 the override i.
  std::uint32_t line = 0;    ///< In the file from 1, or 0 for the file as a whole.
  std::uint32_t column = 0;  ///< From 1.
};

struct Entry;

/// A value in a scenario file or an override.
struct Node {
  struct Date {};  ///< A date or a time, which no key takes.
  using Array = std::vector<Node>;
  using Table = std::vector<Entry>;  ///< In the order of keys.

  std::variant<std::int64_t, double, bool, std::string, Date, Array, Table> value;
  Location location;
};

/// A key of a table with its value.
struct Entry {
  std::string key;
  Location location;
  Node node;
};

/// A scenario as a tree of keys and values that knows where each of them comes from.
class Document {
 public:
  /// `name` stands for the file in messages. Error: the text is not TOML.
  Document(std::string name, std::string_view text);

  /// Replaces a value or adds one, as load_scenario describes. Error: the text is not of the form key=value,
  /// or there is no such place.
  void apply_override(const std::string& override_text);

  const std::string& name() const { return name_; }
  const Node& root() const { return root_; }

  /// file:line:column, the file alone, or `--set key`.
  std::string text_of(const Location& location) const;

 private:
  std::string name_;
  Node root_;
  std::vector<std::string> overridden_;  // dotted keys
};

/// The kind of a value with its article, as in "an integer".
std::string kind_of(const Node& node);

/// A name or value as messages show it.
std::string in_quotes(std::string_view text);

}  // namespace hardball
