// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>

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
  std::string_view dimension = {};  ///< Such as "L/T"; nothing for pure numbers.
  std::string_view meaning = {};    ///< A sentence without its full stop.
  std::string_view example = {};    ///< A value as in TOML.
  bool is_required = true;          ///< Otherwise the value is zero if it is not given.
  std::uint64_t least = 0;          ///< Least value of an integer.
  std::uint64_t most = 0;           ///< Greatest value of an integer.
};
template <class Get, class... Rest>
Field(std::string_view, Get, Rest...) -> Field<Get>;

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
