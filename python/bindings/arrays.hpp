// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hardball/geometry/vec3.hpp"

/// Conversions between the numbers and arrays of Python and the types of the library.
namespace hardball::python {

/// An array of doubles in the order of C. Error: it is not made of real numbers.
using Doubles = pybind11::array_t<double, pybind11::array::c_style>;
Doubles doubles(const pybind11::handle& object, const std::string& name);

/// A vector of three numbers or, if `is_flat`, also of two: z is zero. Error: it is neither.
Vec3 vector_of(const pybind11::handle& object, const std::string& name, bool is_flat);

/// A vector that is a list or tuple of floats, or an array of doubles: what takes little time to recognize.
/// Nothing if it is anything else, which may be right, too.
std::optional<Vec3> plain_vector(const pybind11::handle& object, bool is_flat);
/// A whole number that is an int; nothing if it is anything else, or out of range.
std::optional<std::uint32_t> plain_count(const pybind11::handle& object);

/// The rows of an array of shape (n, 3) or, if `is_flat`, also of (n, 2): z is zero. Error: it has another
/// shape.
std::vector<Vec3> vectors_of(const pybind11::handle& object, const std::string& name, bool is_flat);
/// The rows of an array of shape (count, 3) or, if `is_flat`, also of (count, 2), where z is zero; a single
/// vector stands for all rows. Error: the array has another shape.
std::vector<Vec3> vectors_of(const pybind11::handle& object, const std::string& name, bool is_flat,
                             std::size_t count);

/// An array of shape (count), or one number for all. Error: it has another shape or length.
std::vector<double> numbers_of(const pybind11::handle& object, const std::string& name, std::size_t count);

/// An array of shape (count) of whole numbers from 0 to `most`, or one number for all. Error: it has another
/// shape or length; an element is not such a number.
std::vector<std::uint32_t> counts_of(const pybind11::handle& object, const std::string& name,
                                     std::size_t count, std::uint32_t most);
/// An array of shape (n), or a single number. Error: it has another shape.
std::vector<std::uint32_t> counts_of(const pybind11::handle& object, const std::string& name,
                                     std::uint32_t most);

/// An array of shape (count) of whole numbers of 64 bits, or one number for all. Error: it has another shape
/// or length; an element is not such a number.
std::vector<std::uint64_t> bits_of(const pybind11::handle& object, const std::string& name,
                                   std::size_t count);

/// A new array.
pybind11::array_t<double> array_of(const Vec3& vector);

/// A read-only array.
template <class Array>
Array read_only(Array array) {
  array.attr("setflags")(pybind11::arg("write") = false);
  return array;
}

/// An array around the elements of a vector, which are not copied.
template <class Element>
pybind11::array_t<Element> array_around(std::vector<Element> elements) {
  auto owner = std::make_unique<std::vector<Element>>(std::move(elements));
  const Element* const data = owner->data();
  const auto size = static_cast<pybind11::ssize_t>(owner->size());
  const pybind11::capsule capsule(owner.release(),
                                  [](void* vector) { delete static_cast<std::vector<Element>*>(vector); });
  return pybind11::array_t<Element>(size, data, capsule);
}
/// An array of shape (n, 3) that takes over the memory of the vectors.
pybind11::array_t<double> array_around(std::vector<Vec3> vectors);

}  // namespace hardball::python
