// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/platform/little_endian.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "hardball/geometry/path.hpp"

namespace hardball::little_endian_test {
namespace {

using namespace std::string_literals;

const std::string kOne = "\x00\x00\x00\x00\x00\x00\xf0\x3f"s;
const std::string kTwo = "\x00\x00\x00\x00\x00\x00\x00\x40"s;
const std::string kThree = "\x00\x00\x00\x00\x00\x00\x08\x40"s;

TEST(LittleEndian, HasTheLeastSignificantByteFirst) {
  std::string bytes;
  append_little_endian(bytes, std::uint32_t{0x04030201});
  append_little_endian(bytes, std::uint16_t{0x0605});
  append_little_endian(bytes, std::uint8_t{0x07});
  append_little_endian(bytes, 1.0);
  EXPECT_EQ(bytes, "\x01\x02\x03\x04\x05\x06\x07" + kOne);
  EXPECT_EQ(read_little_endian<std::uint32_t>(bytes.data()), 0x04030201U);
  EXPECT_EQ(read_little_endian<std::uint16_t>(&bytes[4]), 0x0605U);
  EXPECT_EQ(read_little_endian<double>(&bytes[7]), 1.0);
}

TEST(LittleEndian, HasTheNumbersOfAnObjectInTheirOrder) {
  const std::vector<Vec3> vectors{{1, 2, 3}, {3, 1, 2}};
  std::string bytes;
  append_little_endian(bytes, vectors.data(), vectors.size());
  EXPECT_EQ(bytes, kOne + kTwo + kThree + kThree + kOne + kTwo);
  std::vector<Vec3> read(2);
  read_little_endian(bytes.data(), read.data(), read.size());
  EXPECT_EQ(read, vectors);

  bytes.clear();
  append_little_endian(bytes, Image{{0x04030201, 5, -1}});
  EXPECT_EQ(bytes, "\x01\x02\x03\x04\x05\x00\x00\x00\xff\xff\xff\xff"s);
}

}  // namespace
}  // namespace hardball::little_endian_test
