// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstring>
#include <string>
#include <type_traits>

#include "hardball/errors/language.hpp"

namespace hardball {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

/// Numbers, and classes that say by kIsPlain that their objects are numbers one after the other.
template <class Value>
concept Plain = std::is_arithmetic_v<Value> || Value::kIsPlain;

/// Appends a number, or the numbers of an object, to `bytes`, least significant byte first.
template <Plain Value>
void append_little_endian(std::string& bytes, const Value& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(Value));
}

/// The number, or the object, at `bytes`, least significant byte first. Precondition: it lies within the
/// buffer.
template <Plain Value>
Value read_little_endian(const char* bytes) {
  Value value;
  std::memcpy(&value, bytes, sizeof(Value));
  return value;
}

}  // namespace hardball
