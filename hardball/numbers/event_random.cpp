// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/numbers/event_random.hpp"

namespace hardball {
namespace {

// Each bit of the result depends on all bits of key and word. Source: Steele, Lea and Flood, Proc. OOPSLA
// 2014, 453 (SplitMix64).
std::uint64_t mixed(std::uint64_t key, std::uint64_t word) {
  std::uint64_t z = (key ^ word) + 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

}  // namespace

Random event_random(std::uint64_t seed, SphereId sphere, std::uint64_t count) {
  return Random(mixed(mixed(mixed(0, seed), sphere), count));
}

}  // namespace hardball
