// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "hardball/describe/field.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/scenario/document.hpp"
#include "hardball/scenario/keys.hpp"

namespace hardball {

class Section;

/// A value of a scenario. Each function reads it as one type and checks it against the description of its
/// key. Error, with the value's location: the wrong type, or out of range.
class Value {
 public:
  Value(const Document& document, const Node& node, const KeyDescription& key)
      : document_(&document), node_(&node), key_(&key) {}

  std::string location() const { return document_->text_of(node_->location); }

  double number() const;
  /// The value as an integer; accepts numbers such as 1e5, too.
  std::uint64_t integer() const;
  bool truth() const;
  std::string text() const;
  /// The index of the text among the key's choices.
  std::size_t choice() const;
  /// The values of a list, or this one. Error: the list is empty, or has a text twice.
  std::vector<Value> some() const;
  std::vector<double> numbers() const;
  NamedNumbers named_numbers() const;
  /// The values of a list, all of which have a text.
  std::vector<Value> texts() const;
  /// In two dimensions z may be left out: it is zero.
  Vec3 vector(std::size_t dimensions) const;
  std::vector<Vec3> vectors(std::size_t dimensions) const;
  /// The values of a list. `remedy` says what the list should hold.
  std::vector<Value> entries(const std::string& remedy) const;
  /// The values of one string, or of a list of strings, that stand for those of an enumeration.
  template <class Enum>
  std::vector<Enum> some_of() const;
  /// The table that may be given instead of a plain value; none if it is a plain value.
  std::optional<Section> section() const;

  [[noreturn]] void wrong_length(std::size_t length, const std::string& remedy) const;

 private:
  [[noreturn]] void wrong_kind(const std::string& remedy) const;

  const Document* document_;
  const Node* node_;
  const KeyDescription* key_;
};

/// A table of a scenario. All of its keys are known, and go with the choice of its first key where that
/// matters.
class Section {
 public:
  /// The scenario as a whole.
  explicit Section(const Document& document);
  /// The table that `node` is, the value of `key`. Error: it is not a table; an unknown key.
  Section(const Document& document, const Node& node, const KeyDescription& key);

  std::string location() const { return document_->text_of(node_->location); }

  std::optional<Value> find(std::string_view key) const;
  /// Error: there is no such key, of which `alternative` names another that would do, if there is one.
  Value need(std::string_view key, std::string_view alternative = "") const;
  /// Error, with the location of the second, or of another that is to be removed: both keys are given.
  void refuse_both(std::string_view first, std::string_view second,
                   const char* remedy = "remove one of the two", std::string_view removed = "") const;
  /// Gives the members of an object the values of their fields; those that may be left out, and are, keep
  /// theirs. Error: a value is missing, or as of Value.
  template <class Type>
  void read_fields(Type& object) const;
  /// The table of this name, none if it is missing.
  std::optional<Section> section(std::string_view key) const;
  /// The tables of this name, none if they are missing.
  std::vector<Section> sections(std::string_view key) const;

 private:
  void check_keys();
  const Entry* entry(std::string_view key) const;
  const KeyDescription& description(std::string_view key) const;

  const Document* document_;
  const Node* node_;
  const TableDescription* keys_;
  std::string choice_;  // of the first key, if other keys depend on it
};

/// What make() returns; errors of it get this place.
template <class Make>
auto made_at(const std::string& place, Make&& make) {
  try {
    return make();
  } catch (const Error& error) {
    throw Error(error.problem(), place, error.remedy());
  }
}

template <class Enum>
std::vector<Enum> Value::some_of() const {
  std::vector<Enum> values;
  for (const Value& value : some()) values.push_back(static_cast<Enum>(value.choice()));
  return values;
}

template <class Type>
void Section::read_fields(Type& object) const {
  for_each_field<Type>([&](const auto& field) {
    const std::optional<Value> given = field.is_required ? need(field.name) : find(field.name);
    if (!given) return;
    auto& member = object.*field.get;
    using Member = GivenValue<std::remove_reference_t<decltype(member)>>;
    if constexpr (std::is_same_v<Member, bool>) {
      member = given->truth();
    } else if constexpr (std::is_integral_v<Member>) {
      member = given->integer();
    } else if constexpr (std::is_floating_point_v<Member>) {
      member = given->number();
    } else if constexpr (std::is_same_v<Member, std::vector<double>>) {
      member = given->numbers();
    } else if constexpr (std::is_same_v<Member, NamedNumbers>) {
      member = given->named_numbers();
    } else if constexpr (ListOfChoices<Member>) {
      member = given->some_of<typename Member::value_type>();
    } else {
      member = given->text();
    }
  });
}

}  // namespace hardball
