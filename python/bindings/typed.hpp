// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace hardball::python {

/// The name of a type, as a template argument.
template <std::size_t Size>
struct TypeName {
  consteval TypeName(const char (&name)[Size]) { std::copy_n(name, Size, text); }
  char text[Size];
};

/// Any Python object; signatures in docstrings, and with them the stubs, give it the type `name`. Neither
/// pybind11 nor this class checks it.
template <TypeName name>
class Typed : public pybind11::object {
 public:
  using pybind11::object::object;
  Typed(pybind11::object any) : object(std::move(any)) {}
  static bool check_(pybind11::handle) { return true; }
};

/// What NumPy makes an array of.
using ArrayLike = Typed<"ArrayLike">;
using OptionalArrayLike = Typed<"ArrayLike | None">;

/// Types of python/hardball/_typing.py.
using AnyBounce = Typed<"AnyBounce">;
using OptionalResponse = Typed<"Response | None">;
using OptionalThermostat = Typed<"Thermostat | None">;

/// What a sphere meets.
using BodyKind = Typed<"Literal['collision', 'wall']">;

}  // namespace hardball::python

template <hardball::python::TypeName type>
struct pybind11::detail::handle_type_name<hardball::python::Typed<type>> {
  static constexpr auto name = const_name(type.text);
};
