// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace hardball {

/// The range of a number, within the operating range (geometry/range.hpp).
enum class NumberRange : std::uint8_t {
  finite,
  positive,
  not_negative,
  fraction,         ///< From 0 to 1.
  signed_fraction,  ///< From -1 to 1.
};

/// The type of the value to which a pointer to a member, or to a member function, leads.
template <class Get>
struct ValueOf;
template <class Value, class Type>
struct ValueOf<Value Type::*> {
  using type = Value;
};
template <class Value, class Type>
struct ValueOf<Value (Type::*)() const> {
  using type = std::remove_cvref_t<Value>;
};

/// What an optional value is when it is given; otherwise the type itself.
template <class Value>
struct GivenValueOf {
  using type = Value;
};
template <class Value>
struct GivenValueOf<std::optional<Value>> {
  using type = Value;
};
template <class Value>
using GivenValue = typename GivenValueOf<Value>::type;

/// Numbers with names, in the order of the names.
using NamedNumbers = std::vector<std::pair<std::string, double>>;

/// A list of values of an enumeration.
template <class List>
concept ListOfChoices = std::is_enum_v<typename List::value_type> && requires(List list) {
  list.push_back({});
};

/// A value that describes an object, under one name everywhere: in scenarios, recordings and Python.
///
/// A type whose objects are described has `static constexpr auto fields()`, a tuple of these in the order of
/// the arguments of its constructor. Readers make objects from values, writers list values, and the
/// documentation lists fields, without naming any of them again.
template <class Get>
struct Field {
  using Value = typename ValueOf<Get>::type;

  std::string_view name;
  Get get;  ///< The member, or the member function that returns the value.
  NumberRange range = NumberRange::finite;
  std::string_view dimension = {};                 ///< Such as "L/T"; nothing for pure numbers.
  std::string_view meaning = {};                   ///< A sentence without its full stop.
  std::string_view example = {};                   ///< A value as in TOML.
  bool is_required = true;                         ///< Otherwise the value is the default if it is not given.
  std::uint64_t least = 0;                         ///< Least value of an integer.
  std::uint64_t most = 0;                          ///< Greatest value of an integer.
  std::string_view default_value = {};             ///< As in TOML; nothing if none can be written.
  std::span<const std::string_view> choices = {};  ///< The strings that a list may have; any if none.

  /// The field of an integer with these least and greatest values.
  constexpr Field within(std::uint64_t smallest, std::uint64_t greatest) const {
    Field field = *this;
    field.least = smallest;
    field.most = greatest;
    return field;
  }
  /// The field of a list of some of these strings.
  constexpr Field one_of(std::span<const std::string_view> strings) const {
    Field field = *this;
    field.choices = strings;
    return field;
  }
};
template <class Get, class... Rest>
Field(std::string_view, Get, Rest...) -> Field<Get>;

/// The field of a member that keeps its initial value where none is given.
template <class Get>
constexpr Field<Get> option(std::string_view name, Get get, NumberRange range, std::string_view dimension,
                            std::string_view meaning, std::string_view example,
                            std::string_view default_value = {}) {
  return {.name = name,
          .get = get,
          .range = range,
          .dimension = dimension,
          .meaning = meaning,
          .example = example,
          .is_required = false,
          .default_value = default_value};
}

/// The field of a member without a dimension that keeps its initial value where none is given.
template <class Get>
constexpr Field<Get> option(std::string_view name, Get get, std::string_view meaning,
                            std::string_view example, std::string_view default_value = {}) {
  return option(name, get, NumberRange::finite, {}, meaning, example, default_value);
}

/// Calls visit(field) for each field of a type.
template <class Type, class Visit>
constexpr void for_each_field(Visit&& visit) {
  std::apply([&](const auto&... field) { (visit(field), ...); }, Type::fields());
}

/// Calls visit(field, value) for each field of an object.
template <class Type, class Visit>
constexpr void for_each_value(const Type& object, Visit&& visit) {
  for_each_field<Type>([&](const auto& field) { visit(field, std::invoke(field.get, object)); });
}

/// The object whose values are read(field), called in the order of the fields.
template <class Type, class Read>
constexpr Type from_fields(Read&& read) {
  return std::apply([&](const auto&... field) { return Type{read(field)...}; }, Type::fields());
}

/// Calls visit(std::type_identity<Kind>()) for each alternative of a variant.
template <class Variant, class Visit>
constexpr void for_each_alternative(Visit&& visit) {
  [&]<class... Kind>(std::type_identity<std::variant<Kind...>>) {
    (visit(std::type_identity<Kind>()), ...);
  }(std::type_identity<Variant>());
}

/// The alternative of a variant with this kName, made by from_fields; none if there is none. Alternatives
/// without a kMeaning are not made by name. Error: that of the alternative.
template <class Variant, class Read>
std::optional<Variant> from_description(std::string_view name, Read&& read) {
  std::optional<Variant> made;
  for_each_alternative<Variant>([&]<class Kind>(std::type_identity<Kind>) {
    if constexpr (requires { Kind::kMeaning; })
      if (Kind::kName == name) made = from_fields<Kind>(read);
  });
  return made;
}

}  // namespace hardball
