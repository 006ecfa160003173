// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/crc32.hpp"

#include <array>

#include "hardball/platform/little_endian.hpp"

namespace hardball {
namespace {

constexpr std::size_t kBytesAtOnce = 8;
using Table = std::array<std::uint32_t, 256>;

// Table k: what a byte adds to the remainder if k more bytes follow.
constexpr std::array<Table, kBytesAtOnce> make_tables() {
  constexpr std::uint32_t kPolynomial = 0xedb88320;  // reflected
  std::array<Table, kBytesAtOnce> tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t remainder = byte;
    for (int bit = 0; bit < 8; ++bit) remainder = (remainder >> 1) ^ (kPolynomial & (0 - (remainder & 1)));
    tables[0][byte] = remainder;
  }
  for (std::size_t k = 1; k < kBytesAtOnce; ++k) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t before = tables[k - 1][byte];
      tables[k][byte] = (before >> 8) ^ tables[0][before & 0xff];
    }
  }
  return tables;
}

constexpr std::array<Table, kBytesAtOnce> kTables = make_tables();

}  // namespace

void Crc32::add(std::string_view bytes) {
  std::uint32_t state = state_;
  for (; bytes.size() >= kBytesAtOnce; bytes.remove_prefix(kBytesAtOnce)) {
    const auto next = read_little_endian<std::uint64_t>(bytes.data()) ^ state;
    state = 0;
    for (std::size_t k = 0; k < kBytesAtOnce; ++k) {
      state ^= kTables[kBytesAtOnce - 1 - k][(next >> (8 * k)) & 0xff];
    }
  }
  for (const char byte : bytes) {
    state = (state >> 8) ^ kTables[0][(state ^ static_cast<unsigned char>(byte)) & 0xff];
  }
  state_ = state;
}

}  // namespace hardball
