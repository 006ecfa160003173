// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstring>
#include <string>

#include "c/hardball.h"
#include "hardball/error.hpp"

/// What all functions of the C API share: exceptions become a status, and arguments are checked.
namespace hardball::c {

/// Stores the exception that is being handled as the last error of this thread, and returns its status.
hb_status report_failure() noexcept;

/// Runs the body of a function; no exception leaves it.
template <class Body>
hb_status guarded(Body&& body) noexcept {
  try {
    body();
    return HB_OK;
  } catch (...) {
    return report_failure();
  }
}

/// Runs the body of a function that returns a value, and returns `otherwise` if it fails.
template <class Value, class Body>
Value value_or(const Value& otherwise, Body&& body) noexcept {
  Value value = otherwise;
  guarded([&] { value = body(); });
  return value;
}

/// Error: a pointer is NULL.
inline void check_given(const void* pointer, const char* argument) {
  if (pointer == nullptr) throw Error("it is NULL", argument, "pass a pointer to an object");
}

/// What a pointer points to. Error: it is NULL.
template <class T>
T& given(T* pointer, const char* argument) {
  check_given(pointer, argument);
  return *pointer;
}

/// What an array points to, which may be empty. Error: it is NULL, but not empty.
template <class T>
T* given_array(T* pointer, std::size_t count, const char* argument) {
  if (count > 0) check_given(pointer, argument);
  return pointer;
}

/// Error: a struct was not initialized, or by a later header than that of the library.
inline void check_struct_size(std::size_t struct_size, std::size_t known, const char* argument) {
  const std::size_t step = alignof(std::size_t);
  if (struct_size >= sizeof(std::size_t) && struct_size <= known && struct_size % step == 0) return;
  throw Error("its struct_size is " + to_text(struct_size) + ", that of this library " + to_text(known),
              argument,
              "initialize it by the macro of its type, with a header that is not newer than the library");
}

/// What a caller describes, with the defaults of members that its program does not know. Error: see
/// check_struct_size.
template <class Struct>
Struct completed(const Struct* description, const Struct& defaults, const char* argument) {
  const std::size_t size = given(description, argument).struct_size;
  check_struct_size(size, sizeof(Struct), argument);
  Struct complete = defaults;
  std::memcpy(&complete, description, size);
  complete.struct_size = sizeof(Struct);
  return complete;
}

/// Error: see check_struct_size.
template <class Struct>
void check_result(const Struct* out) {
  check_struct_size(given(out, "out").struct_size, sizeof(Struct), "out");
}

/// Writes a result, as much of it as the caller's program knows. Precondition: check_result.
template <class Struct>
void write(Struct result, Struct* out) {
  result.struct_size = out->struct_size;
  std::memcpy(out, &result, out->struct_size);
}

}  // namespace hardball::c
