// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace hardball {

/// The CRC-32 of bytes that come one part after the other, as of zip and zlib.
///
/// It detects every change of up to 32 adjacent bits, and of any two bits in less than 512 MB; of other
/// changes, it misses one in 2^32. Source: ISO 3309; eight bytes at a time by tables (Kounavis and Berry, "A
/// systematic approach to building high performance software-based CRC generators", 2005). Cost: O(bytes).
class Crc32 {
 public:
  void add(std::string_view bytes);
  std::uint32_t value() const { return ~state_; }

 private:
  std::uint32_t state_ = 0xffffffff;
};

/// The checksum of one part.
inline std::uint32_t crc32_of(std::string_view bytes) {
  Crc32 crc;
  crc.add(bytes);
  return crc.value();
}

}  // namespace hardball
