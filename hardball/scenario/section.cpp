// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/section.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/scenario/nearest_name.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

void check_range(double number, const KeyDescription& key, const std::string& where) {
  const auto refuse = [&](const std::string& remedy) {
    throw Error(std::string(key.name) + " is " + to_text(number), where, remedy);
  };
  switch (key.range) {
    case NumberRange::finite:
      return check_finite(number, key.name, where);
    case NumberRange::positive:
      return check_positive(number, key.name, where);
    case NumberRange::not_negative:
      check_finite(number, key.name, where);
      if (number < 0) refuse("give zero or a positive number");
      if (number > 0) check_positive(number, key.name, where);
      return;
    case NumberRange::fraction:
      if (!(number >= 0 && number <= 1)) refuse("give a number between 0 and 1");
      return;
    case NumberRange::signed_fraction:
      if (!(number >= -1 && number <= 1)) refuse("give a number between -1 and 1");
      return;
  }
}

// "a number", or what else the key takes.
std::string remedy_for(const KeyDescription& key, const std::string& what) {
  return "give " + what + (key.table ? ", or a table in braces" : "");
}

}  // namespace

double Value::number() const {
  double number = 0;
  if (const auto* const given = std::get_if<double>(&node_->value)) {
    number = *given;
  } else if (const auto* const integer = std::get_if<std::int64_t>(&node_->value)) {
    number = static_cast<double>(*integer);
  } else {
    wrong_kind(remedy_for(*key_, "a number"));
  }
  check_range(number, *key_, location());
  // Never minus zero where nothing is negative.
  return key_->range == NumberRange::not_negative ? std::fabs(number) : number;
}

std::uint64_t Value::integer() const {
  const auto refuse = [&](const std::string& given) -> std::uint64_t {
    throw Error(
        std::string(key_->name) + " is " + given, location(),
        "give an integer of at least " + to_text(key_->least) + " and at most " + to_text(key_->most));
  };
  const auto is_in_range = [&](std::uint64_t number) {
    return number >= key_->least && number <= key_->most;
  };
  if (const auto* const number = std::get_if<double>(&node_->value)) {
    const bool is_exact = *number >= 0 && *number <= 0x1p53 && *number == std::floor(*number);
    if (!is_exact || !is_in_range(static_cast<std::uint64_t>(*number))) return refuse(to_text(*number));
    return static_cast<std::uint64_t>(*number);
  }
  const auto* const integer = std::get_if<std::int64_t>(&node_->value);
  if (!integer) wrong_kind("give an integer");
  if (*integer < 0 || !is_in_range(static_cast<std::uint64_t>(*integer))) return refuse(to_text(*integer));
  return static_cast<std::uint64_t>(*integer);
}

bool Value::truth() const {
  const auto* const boolean = std::get_if<bool>(&node_->value);
  if (!boolean) wrong_kind("give true or false");
  return *boolean;
}

std::string Value::text() const {
  const auto* const string = std::get_if<std::string>(&node_->value);
  if (!string) wrong_kind("give a string in double quotes");
  if (string->empty()) {
    throw Error(std::string(key_->name) + " is empty", location(), "give a string that is not empty");
  }
  return *string;
}

std::size_t Value::choice() const {
  const std::string given = text();
  const auto found = ranges::find(key_->choices, given);
  if (found == key_->choices.end()) {
    throw Error(std::string(key_->name) + " is \"" + shortened(given) + "\"", location(),
                suggestion(given, key_->choices, '"'));
  }
  return static_cast<std::size_t>(found - key_->choices.begin());
}

std::vector<Value> Value::some() const {
  if (!std::holds_alternative<Node::Array>(node_->value)) return {*this};
  const std::string remedy = "give at least one string in brackets";
  std::vector<Value> values = entries(remedy);
  if (values.empty()) wrong_length(0, remedy);
  for (auto value = values.begin(); value != values.end(); ++value) {
    const std::string given = value->text();
    const auto is_given = [&](const Value& earlier) { return earlier.text() == given; };
    if (std::any_of(values.begin(), value, is_given)) {
      throw Error(std::string(key_->name) + " has \"" + shortened(given) + "\" twice", value->location(),
                  "remove one of the two");
    }
  }
  return values;
}

std::vector<double> Value::numbers() const {
  std::vector<double> numbers;
  for (const Value& entry : entries("give numbers in brackets")) numbers.push_back(entry.number());
  return numbers;
}

NamedNumbers Value::named_numbers() const {
  const auto* const table = std::get_if<Node::Table>(&node_->value);
  if (!table) wrong_kind("give names with a number each, such as " + std::string(key_->example));
  NamedNumbers numbers;
  for (const Entry& entry : *table)
    numbers.emplace_back(entry.key, Value(*document_, entry.node, *key_).number());
  return numbers;
}

std::vector<Value> Value::texts() const {
  std::vector<Value> texts = entries("give strings in brackets");
  for (const Value& entry : texts) static_cast<void>(entry.text());
  return texts;
}

Vec3 Value::vector(std::size_t dimensions) const {
  const std::string remedy =
      dimensions == 2 ? "give two numbers in brackets" : "give three numbers in brackets";
  const std::vector<Value> parts = entries(remedy);
  if (parts.size() != kAxes && parts.size() != dimensions) wrong_length(parts.size(), remedy);
  Vec3 vector;
  for (std::size_t axis = 0; axis < parts.size(); ++axis) vector[axis] = parts[axis].number();
  return vector;
}

std::vector<Vec3> Value::vectors(std::size_t dimensions) const {
  std::vector<Vec3> vectors;
  const char* const remedy =
      dimensions == 2 ? "give an array of arrays of two numbers" : "give an array of arrays of three numbers";
  for (const Value& entry : entries(remedy)) vectors.push_back(entry.vector(dimensions));
  return vectors;
}

std::vector<Value> Value::entries(const std::string& remedy) const {
  const auto* const array = std::get_if<Node::Array>(&node_->value);
  if (!array) wrong_kind(remedy);
  std::vector<Value> values;
  for (const Node& entry : *array) values.emplace_back(*document_, entry, *key_);
  return values;
}

std::optional<Section> Value::section() const {
  if (!std::holds_alternative<Node::Table>(node_->value)) return std::nullopt;
  return Section(*document_, *node_, *key_);
}

void Value::wrong_length(std::size_t length, const std::string& remedy) const {
  throw Error(std::string(key_->name) + " has " + to_text(length) + (length == 1 ? " entry" : " entries"),
              location(), remedy);
}

void Value::wrong_kind(const std::string& remedy) const {
  throw Error(std::string(key_->name) + " is " + kind_of(*node_), location(), remedy);
}

Section::Section(const Document& document)
    : document_(&document), node_(&document.root()), keys_(&scenario_keys()) {
  check_keys();
}

Section::Section(const Document& document, const Node& node, const KeyDescription& key)
    : document_(&document), node_(&node), keys_(key.table.get()) {
  if (!std::holds_alternative<Node::Table>(node.value)) {
    throw Error(in_quotes(key.name) + " is " + kind_of(node), location(), "make it a table, " + keys_->title);
  }
  check_keys();
}

void Section::check_keys() {
  for (const Entry& entry : std::get<Node::Table>(node_->value)) {
    const std::vector<std::string_view> names = keys_->names();
    if (ranges::find(names, entry.key) != names.end()) continue;
    throw Error("unknown key " + in_quotes(entry.key) + (keys_->title.empty() ? "" : " in " + keys_->title),
                document_->text_of(entry.location), suggestion(entry.key, names));
  }
  if (!keys_->has_variants()) return;
  const KeyDescription& first = keys_->keys.front();
  choice_ = first.choices[need(first.name).choice()];
  for (const Entry& entry : std::get<Node::Table>(node_->value)) {
    if (keys_->find(entry.key, choice_)) continue;
    throw Error("key " + in_quotes(entry.key) + " does not go with " + std::string(first.name) + " = \"" +
                    choice_ + "\"",
                document_->text_of(entry.location), "remove it or change the " + std::string(first.name));
  }
}

const Entry* Section::entry(std::string_view key) const {
  const auto& table = std::get<Node::Table>(node_->value);
  const auto found = ranges::find(table, key, &Entry::key);
  return found == table.end() ? nullptr : &*found;
}

const KeyDescription& Section::description(std::string_view key) const {
  const KeyDescription* const description = keys_->find(key, choice_);
  HARDBALL_CHECK(description);
  return *description;
}

std::optional<Value> Section::find(std::string_view key) const {
  const KeyDescription& description = this->description(key);
  const Entry* const entry = this->entry(key);
  if (!entry) return std::nullopt;
  return Value(*document_, entry->node, description);
}

Value Section::need(std::string_view key, std::string_view alternative) const {
  if (const std::optional<Value> value = find(key)) return *value;
  throw Error("key " + in_quotes(key) + " is missing in " + keys_->title, location(),
              "add it, such as " + std::string(key) + " = " + std::string(description(key).example) +
                  (alternative.empty() ? "" : ", or " + std::string(alternative)));
}

void Section::refuse_both(std::string_view first, std::string_view second, const char* remedy,
                          std::string_view removed) const {
  if (!find(first) || !find(second)) return;
  throw Error("both " + std::string(first) + " and " + std::string(second) + " are given",
              need(removed.empty() ? second : removed).location(), remedy);
}

std::optional<Section> Section::section(std::string_view key) const {
  const KeyDescription& description = this->description(key);
  const Entry* const entry = this->entry(key);
  if (!entry) return std::nullopt;
  return Section(*document_, entry->node, description);
}

std::vector<Section> Section::sections(std::string_view key) const {
  const KeyDescription& description = this->description(key);
  std::vector<Section> sections;
  const Entry* const entry = this->entry(key);
  if (!entry) return sections;
  const auto* const array = std::get_if<Node::Array>(&entry->node.value);
  if (!array) {
    throw Error(in_quotes(key) + " is " + kind_of(entry->node), document_->text_of(entry->node.location),
                "make it a table in an array, " + description.table->title);
  }
  for (const Node& node : *array) sections.emplace_back(*document_, node, description);
  return sections;
}

}  // namespace hardball
