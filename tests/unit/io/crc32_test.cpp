// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/crc32.hpp"

#include <gtest/gtest.h>

#include <string>

namespace hardball::crc32_test {
namespace {

// Of each byte by itself, from the definition: the remainder of a division by the polynomial.
std::uint32_t plain_crc32(std::string_view bytes) {
  std::uint32_t remainder = 0xffffffff;
  for (const char byte : bytes) {
    remainder ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) remainder = (remainder >> 1) ^ ((remainder & 1) != 0 ? 0xedb88320 : 0);
  }
  return ~remainder;
}

TEST(Crc32, IsTheUsualOne) {
  EXPECT_EQ(crc32_of(""), 0U);
  EXPECT_EQ(crc32_of("123456789"), 0xcbf43926U);
}

TEST(Crc32, OfAnyPartsIsThatOfTheWhole) {
  std::string bytes;
  for (int i = 0; i < 40; ++i) bytes += static_cast<char>(37 * i * i + 11);
  for (std::size_t first = 0; first <= bytes.size(); ++first) {
    for (std::size_t second = first; second <= bytes.size(); ++second) {
      Crc32 crc;
      const std::string_view whole = bytes;
      crc.add(whole.substr(0, first));
      crc.add(whole.substr(first, second - first));
      crc.add(whole.substr(second));
      ASSERT_EQ(crc.value(), plain_crc32(bytes)) << first << ", " << second;
    }
  }
}

}  // namespace
}  // namespace hardball::crc32_test
