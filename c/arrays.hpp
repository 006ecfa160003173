// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

#include "c/guard.hpp"
#include "c/hardball.h"
#include "hardball/world.hpp"

/// The caller's arrays: rows of numbers, wherever they lie.
namespace hardball::c {

inline Vec3 vector_of(const double* numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

inline void store(const Vec3& vector, double* numbers) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) numbers[axis] = vector[axis];
}

/// Bytes of one number of a type; zero if there is no such type.
inline std::size_t size_of(hb_type type) {
  return type == HB_F64 || type == HB_U64 ? 8 : type == HB_F32 || type == HB_U32 ? 4 : 0;
}

/// Error: the numbers of an array have another type than a column of the library, which has real numbers,
/// HB_U32 or HB_U64.
inline void check_type(hb_type type, hb_type column, const char* argument) {
  const bool is_real = column == HB_F64;
  if (type == column || (is_real && type == HB_F32)) return;
  throw Error("its type does not fit", argument,
              is_real            ? "give HB_F64 or HB_F32"
              : column == HB_U32 ? "give HB_U32"
                                 : "give HB_U64");
}

/// An array that the library reads, or for all rows the defaults.
class Rows {
 public:
  /// Error: see check_type; data is NULL although it `is_needed`.
  Rows(const hb_const_array& array, hb_type column, bool is_needed, const char* argument) : array_(array) {
    if (is_needed) check_given(array.data, argument);
    if (array.data != nullptr) check_type(array.type, column, argument);
  }

  double number(std::size_t row, double otherwise, std::size_t column = 0) const {
    if (array_.data == nullptr) return otherwise;
    return array_.type == HB_F32 ? static_cast<double>(read<float>(row, column)) : read<double>(row, column);
  }
  Vec3 vector(std::size_t row) const { return {number(row, 0, 0), number(row, 0, 1), number(row, 0, 2)}; }
  std::uint32_t integer(std::size_t row) const {
    return array_.data == nullptr ? 0 : read<std::uint32_t>(row, 0);
  }

 private:
  template <class Number>
  Number read(std::size_t row, std::size_t column) const {
    Number number;
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(row) * array_.stride;
    std::memcpy(&number, static_cast<const char*>(array_.data) + offset + column * sizeof number,
                sizeof number);
    return number;
  }

  hb_const_array array_;
};

/// An array that the library writes.
class OutputRows {
 public:
  /// Error: see check_type; data is NULL although there are rows; rows of this many columns overlap.
  OutputRows(const hb_array& array, hb_type type, std::size_t count, std::size_t columns,
             const char* argument)
      : array_(array) {
    if (count == 0) return;
    check_given(array.data, argument);
    check_type(array.type, type, argument);
    const std::size_t row = columns * size_of(array.type);
    const auto stride = static_cast<std::size_t>(array.stride < 0 ? -array.stride : array.stride);
    if (count == 1 || stride >= row) return;
    throw Error("its rows of " + to_text(row) + " bytes overlap, as the stride is " + to_text(array.stride),
                argument, "give the bytes from each row to the next");
  }

  void write_number(std::size_t row, double number, std::size_t column = 0) const {
    if (array_.type == HB_F32) {
      write(row, column, static_cast<float>(number));
    } else {
      write(row, column, number);
    }
  }
  void write_vector(std::size_t row, const Vec3& vector) const {
    for (std::size_t axis = 0; axis < kAxes; ++axis) write_number(row, vector[axis], axis);
  }
  /// Writes an integer. Precondition: it has the type of the array.
  template <class Integer>
  void write_integer(std::size_t row, Integer integer) const {
    write(row, 0, integer);
  }

 private:
  template <class Number>
  void write(std::size_t row, std::size_t column, const Number& number) const {
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(row) * array_.stride;
    std::memcpy(static_cast<char*>(array_.data) + offset + column * sizeof number, &number, sizeof number);
  }

  hb_array array_;
};

}  // namespace hardball::c
