// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/document.hpp"

// Some invalid texts, such as "[.[a]]", fail an assertion in toml++, which aborts or carries on, depending on
// NDEBUG. Here it throws in every build.
namespace hardball {
namespace {

struct ParserFault {};

constexpr void expect(bool condition) {
  if (!condition) throw ParserFault();
}

}  // namespace
}  // namespace hardball
#undef NDEBUG
#define TOML_ASSERT(condition) hardball::expect(static_cast<bool>(condition))
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>
#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

std::string in_quotes(std::string_view text) {
  return "'" + std::string(text) + "'";
}

bool has_parser_fault(std::string_view text) {
  try {
    static_cast<void>(toml::parse(text));
  } catch (const toml::parse_error&) {
    return false;
  } catch (const ParserFault&) {
    return true;
  }
  return false;
}

// The line and column of the character at which the parser throws ParserFault. Precondition: it does.
std::string place_of_fault(std::string_view text) {
  // The end of that character: in a shorter text the parser finds another error, or none.
  std::size_t low = 0;
  std::size_t high = text.size();
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (has_parser_fault(text.substr(0, middle))) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  const std::string_view read = text.substr(0, low);
  const std::size_t line_begin = read.substr(0, low > 0 ? low - 1 : 0).rfind('\n') + 1;
  const auto is_first_of_character = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  const auto count = [](auto begin, auto end, auto condition) {
    return to_text(static_cast<std::size_t>(std::count_if(begin, end, condition)));
  };
  const std::string_view line = read.substr(line_begin);
  const auto lines_before = static_cast<std::size_t>(
      std::count(read.begin(), read.begin() + static_cast<std::ptrdiff_t>(line_begin), '\n'));
  return to_text(lines_before + 1) + ":" + count(line.begin(), line.end(), is_first_of_character);
}

toml::table parse_toml(std::string_view text, const std::string& name) {
  const std::string remedy = "see toml.io for how to write it";
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    // One line, whatever the parser says.
    std::string message(error.description());
    std::replace(message.begin(), message.end(), '\n', ' ');
    std::replace(message.begin(), message.end(), ';', ',');
    const toml::source_position begin = error.source().begin;
    throw Error("invalid TOML: " + message, name + ":" + to_text(begin.line) + ":" + to_text(begin.column),
                remedy);
  } catch (const ParserFault&) {
    throw Error("invalid TOML", name + ":" + place_of_fault(text),
                "put keys in quotes unless they consist of letters a to z, digits, _ and -; " + remedy);
  }
}

Place place_of(const toml::source_region& source) {
  return {0, source.begin.line, source.begin.column};
}

// The tree of the parser as one of ours.
Node convert(const toml::node& node) {
  Node converted{Node::Date(), place_of(node.source())};
  switch (node.type()) {
    case toml::node_type::table: {
      Node::Table table;
      for (const auto& [key, value] : *node.as_table()) {
        table.push_back({std::string(key.str()), place_of(key.source()), convert(value)});
      }
      converted.value = std::move(table);
      break;
    }
    case toml::node_type::array: {
      Node::Array array;
      for (const toml::node& entry : *node.as_array()) array.push_back(convert(entry));
      converted.value = std::move(array);
      break;
    }
    case toml::node_type::string:
      converted.value = node.as_string()->get();
      break;
    case toml::node_type::integer:
      converted.value = node.as_integer()->get();
      break;
    case toml::node_type::floating_point:
      converted.value = node.as_floating_point()->get();
      break;
    case toml::node_type::boolean:
      converted.value = node.as_boolean()->get();
      break;
    default:
      break;
  }
  return converted;
}

// The value of an override: as in TOML, or a plain word, which TOML would require in quotes.
Node parse_override(const std::string& value, const std::string& where) {
  const auto is_plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("_-./").find(c) != std::string::npos;
  };
  try {
    const toml::table parsed = parse_toml("value = " + value, where);
    if (parsed.size() == 1) return convert(*parsed.get("value"));
  } catch (const Error&) {
    const bool is_word = !value.empty() && std::isdigit(static_cast<unsigned char>(value[0])) == 0 &&
                         value[0] != '-' && std::all_of(value.begin(), value.end(), is_plain);
    if (is_word) return {value, {}};
  }
  throw Error("the value " + in_quotes(value) + " is not valid TOML", where,
              "give a number, true, false, a word, a string in double quotes, or an array in brackets");
}

void set_place(Node& node, const Place& place) {
  node.place = place;
  if (auto* const array = std::get_if<Node::Array>(&node.value)) {
    for (Node& entry : *array) set_place(entry, place);
  }
  if (auto* const table = std::get_if<Node::Table>(&node.value)) {
    for (Entry& entry : *table) {
      entry.place = place;
      set_place(entry.node, place);
    }
  }
}

std::optional<std::size_t> parse_index(std::string_view text) {
  std::size_t index = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (status != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return index;
}

// The value of a key, which is an empty table written at `place` if there is none.
Node& at_key(Node::Table& table, const std::string& key, const Place& place) {
  auto entry = std::lower_bound(table.begin(), table.end(), key,
                                [](const Entry& a, const std::string& b) { return a.key < b; });
  if (entry == table.end() || entry->key != key) {
    entry = table.insert(entry, {key, place, {Node::Table(), place}});
  }
  return entry->node;
}

}  // namespace

Document::Document(std::string name, std::string_view text)
    : name_(std::move(name)), root_(convert(parse_toml(text, name_))) {}

void Document::apply_override(const std::string& override_text) {
  const std::size_t equals = override_text.find('=');
  const std::string key = override_text.substr(0, equals);
  const std::string where = "--set " + key;
  if (equals == std::string::npos || key.empty() || key.back() == '.') {
    throw Error(in_quotes(override_text) + " is not of the form key=value", "--set",
                "write it like run.until=5");
  }
  Node value = parse_override(override_text.substr(equals + 1), where);
  overridden_.push_back(key);
  const Place place{static_cast<std::uint32_t>(overridden_.size()), 0, 0};
  set_place(value, place);
  Node* node = &root_;
  for (std::size_t begin = 0; begin < key.size();) {
    const std::size_t dot = std::min(key.find('.', begin), key.size());
    const std::string part = key.substr(begin, dot - begin);
    begin = dot + 1;
    if (auto* const table = std::get_if<Node::Table>(&node->value)) {
      node = &at_key(*table, part, place);
    } else if (auto* const array = std::get_if<Node::Array>(&node->value)) {
      const std::optional<std::size_t> index = parse_index(part);
      if (!index || *index >= array->size()) {
        throw Error("there is no entry " + in_quotes(part), where,
                    "entries are counted from 0, and there are " + to_text(array->size()));
      }
      node = &(*array)[*index];
    } else {
      throw Error(in_quotes(part) + " would be inside a plain value", where, "name a table and a key in it");
    }
  }
  *node = std::move(value);
}

std::string Document::text_of(const Place& place) const {
  if (place.origin > 0) return "--set " + overridden_[place.origin - 1];
  if (place.line == 0) return name_;
  return name_ + ":" + to_text(place.line) + ":" + to_text(place.column);
}

std::string kind_of(const Node& node) {
  // In the order of the variant.
  constexpr std::array<const char*, 7> kKinds{"an integer",       "a number", "true or false", "a string",
                                              "a date or a time", "an array", "a table"};
  return kKinds[node.value.index()];
}

}  // namespace hardball
