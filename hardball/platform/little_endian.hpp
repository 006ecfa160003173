// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace hardball {

/// Numbers, and classes that say by PlainNumber that their objects are numbers of that type, one after the
/// other.
template <class Value>
concept Plain = std::is_arithmetic_v<Value> || std::is_enum_v<Value> || requires {
  typename Value::PlainNumber;
};

/// Sizes, where they have fewer bits than the 64 that they have in files.
template <class Value>
concept NarrowSize = std::is_same_v<Value, std::size_t> && sizeof(Value) < sizeof(std::uint64_t);

namespace platform {

template <class Value>
constexpr std::size_t number_bytes() {
  if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
    return sizeof(Value);
  } else {
    static_assert(sizeof(Value) % sizeof(typename Value::PlainNumber) == 0);
    return sizeof(typename Value::PlainNumber);
  }
}

/// Turns numbers as they lie in memory into little-endian ones, or back. Does nothing where they are.
template <class Value>
void exchange_endianness([[maybe_unused]] char* bytes, [[maybe_unused]] std::size_t count) {
  static_assert(std::is_trivially_copyable_v<Value>);
  static_assert(std::endian::native == std::endian::little || std::endian::native == std::endian::big);
  if constexpr (std::endian::native == std::endian::big) {
    constexpr std::size_t kBytes = number_bytes<Value>();
    for (char* const end = bytes + count * sizeof(Value); bytes != end; bytes += kBytes)
      std::reverse(bytes, bytes + kBytes);
  }
}

}  // namespace platform

/// Appends numbers, or those of objects, to `bytes`, least significant byte first.
template <Plain Value>
void append_little_endian(std::string& bytes, const Value* values, std::size_t count) {
  static_assert(!NarrowSize<Value>);
  const std::size_t before = bytes.size();
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(Value));
  platform::exchange_endianness<Value>(bytes.data() + before, count);
}
template <Plain Value>
void append_little_endian(std::string& bytes, const Value& value) {
  append_little_endian(bytes, &value, 1);
}

/// Reads numbers, or objects, at `bytes`, least significant byte first. Precondition: they lie within the
/// buffer.
template <Plain Value>
void read_little_endian(const char* bytes, Value* values, std::size_t count) {
  if (count == 0) return;
  std::memcpy(static_cast<void*>(values), bytes, count * sizeof(Value));
  platform::exchange_endianness<Value>(reinterpret_cast<char*>(values), count);
}
template <Plain Value>
Value read_little_endian(const char* bytes) {
  Value value;
  read_little_endian(bytes, &value, 1);
  return value;
}

}  // namespace hardball
