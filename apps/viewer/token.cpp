// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/viewer/token.hpp"

#include <random>

namespace hardball::viewer {

std::string make_token() {
  constexpr int kBytes = 16;
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::random_device source;
  std::string token;
  for (int k = 0; k < kBytes; ++k) {
    const unsigned byte = source() & 0xff;
    token += {kDigits[byte / 16], kDigits[byte % 16]};
  }
  return token;
}

bool is_same_secret(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    difference |= static_cast<unsigned char>(a[k]) ^ static_cast<unsigned>(static_cast<unsigned char>(b[k]));
  }
  return difference == 0;
}

}  // namespace hardball::viewer
