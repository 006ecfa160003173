// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <string>

#include "hardball/errors/export.hpp"
#include "hardball/interaction/contact.hpp"

namespace hardball {

/// The fingerprint of a run: a hash over all collisions and wall contacts in order, of their kind, ids and
/// every bit of their times. Two runs with the same hash went through the same history.
class EventLogHash {
 public:
  void note(const Contact& contact) {
    mix(std::bit_cast<std::uint64_t>(contact.time.high));
    // Zero has two signs but is one time.
    mix(std::bit_cast<std::uint64_t>(contact.time.low + 0.0));
    mix(std::uint64_t{contact.second} << 32 | contact.first);
    mix(static_cast<std::uint64_t>(contact.is_collision() ? 0 : 1));
  }

  std::uint64_t value() const { return hash_; }

  friend bool operator==(const EventLogHash&, const EventLogHash&) = default;

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) { archive(self.hash_); }

  // Source: Steele, Lea and Flood, OOPSLA (2014) 453, the finaliser of SplitMix.
  void mix(std::uint64_t word) {
    hash_ = (hash_ ^ word) * 0x9e3779b97f4a7c15;
    hash_ = (hash_ ^ (hash_ >> 32)) * 0xbf58476d1ce4e5b9;
    hash_ ^= hash_ >> 29;
  }

  std::uint64_t hash_ = 0x48617264'62616c6c;
};

/// A hash as it is shown: 16 hexadecimal digits.
HARDBALL_EXPORT std::string hash_text(std::uint64_t hash);

}  // namespace hardball
