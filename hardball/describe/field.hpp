// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <tuple>
#include <type_traits>

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

}  // namespace hardball
