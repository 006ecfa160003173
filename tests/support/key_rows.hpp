// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "hardball/scenario/keys.hpp"

/// Keys as pages of the documentation list them.
namespace hardball::support {

/// A cell of a table in Markdown.
inline std::string cell(const std::string& text) {
  std::string cell = " ";
  for (const char c : text) cell += c == '|' ? "\\|" : std::string(1, c);
  return cell + " |";
}

/// The row of a key in a page.
inline std::string row_of(const KeyDescription& key) {
  std::string name = "`" + std::string(key.name) + "`";
  for (const std::string_view choice : key.only_for) {
    name += (choice == key.only_for.front() ? " of `\"" : ", `\"") + std::string(choice) + "\"`";
  }
  std::string default_value = "–";
  if (key.is_required) default_value = "required";
  if (!key.default_value.empty()) default_value = "`" + std::string(key.default_value) + "`";
  return "|" + cell(name) + cell(values_of(key)) + cell(default_value) + cell(std::string(key.meaning)) +
         "\n";
}

/// The table of the keys of a table in a page.
inline std::string rows_of(const TableDescription& table) {
  std::string rows = "| key | value | default | meaning |\n|---|---|---|---|\n";
  for (const KeyDescription& key : table.keys) rows += row_of(key);
  return rows + "\n";
}

}  // namespace hardball::support
