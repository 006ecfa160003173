// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>

#include "hardball/errors/language.hpp"

namespace hardball {

/// Appends a number to `bytes`, least significant byte first.
template <std::unsigned_integral Word>
void append_little_endian(std::string& bytes, Word word) {
  char parts[sizeof(Word)];
  for (std::size_t byte = 0; byte < sizeof(Word); ++byte) {
    parts[byte] = static_cast<char>(static_cast<unsigned char>(word >> (8 * byte)));
  }
  bytes.append(parts, sizeof(Word));
}
inline void append_little_endian(std::string& bytes, double number) {
  append_little_endian(bytes, std::bit_cast<std::uint64_t>(number));
}

/// The number at `bytes`, least significant byte first. Precondition: it lies within the buffer.
template <class Number>
Number read_little_endian(const char* bytes) {
  if constexpr (std::unsigned_integral<Number>) {
    Number word = 0;
    for (std::size_t byte = 0; byte < sizeof(Number); ++byte) {
      word = static_cast<Number>(word | static_cast<Number>(static_cast<unsigned char>(bytes[byte]))
                                            << (8 * byte));
    }
    return word;
  } else {
    static_assert(std::same_as<Number, double>);
    return std::bit_cast<double>(read_little_endian<std::uint64_t>(bytes));
  }
}

}  // namespace hardball
