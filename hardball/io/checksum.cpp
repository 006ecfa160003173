// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/checksum.hpp"

#include <xxhash.h>

namespace hardball {

std::uint64_t checksum_of(std::string_view bytes) {
  return XXH64(bytes.data(), bytes.size(), 0);
}

}  // namespace hardball
