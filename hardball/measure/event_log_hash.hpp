// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <type_traits>

#include "hardball/errors/export.hpp"
#include "hardball/interaction/contact.hpp"
#include "hardball/standard/bit_cast.hpp"

namespace hardball {

/// The fingerprint of a run: the sum, modulo 2^64, of a hash of each collision and wall contact: of its kind,
/// with the number of a step and whether it is passed, its ids, every bit of its time, and every bit of the
/// times since when the motions of its spheres had not changed (minus infinity for a wall).
///
/// It is the same in whichever order contacts are added, and however they are divided among several hashes.
/// Two runs with the same hash went through the same history: the times order their contacts. Among the
/// contacts of a sphere at one moment, these times distinguish the first from the others. Which of three or
/// more was the second, and which came later, is not covered.
class EventLogHash {
 public:
  /// Cost: some 50 instructions, which depend on few others.
  void record(const Contact& contact) { sum_ += hash_of(contact); }
  /// Adds all contacts of another hash.
  void add(const EventLogHash& other) { sum_ += other.sum_; }

  std::uint64_t value() const { return kStart + sum_; }

  friend bool operator==(const EventLogHash&, const EventLogHash&) = default;

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) { archive(self.sum_); }

  static std::uint64_t hash_of(const Contact& contact) {
    // The products do not depend on each other. Each is turned by a number of bits of its own, so that words
    // that differ in a few high bits only do not cancel out. Low parts: zero has two signs but is one time.
    const std::uint64_t ids = std::uint64_t{contact.second} << 32 | contact.first;
    const std::uint64_t kind = contact.step.happens()   ? kind_of(contact.step)
                               : contact.is_collision() ? 0
                                                        : kWall;
    return mixed(kind + ids * 0x9e3779b97f4a7c15 + product(contact.time.high, 0xbf58476d1ce4e5b9, 11) +
                 product(contact.time.low + 0.0, 0x94d049bb133111eb, 23) +
                 product(contact.first_since.high, 0xd6e8feb86659fd93, 31) +
                 product(contact.first_since.low + 0.0, 0xa0761d6478bd642f, 41) +
                 product(contact.second_since.high, 0xe7037ed1a0b428db, 47) +
                 product(contact.second_since.low + 0.0, 0x8ebc6af09c88c6e3, 59));
  }
  static std::uint64_t kind_of(const StepAttempt& step) {
    const std::uint64_t side = 2U * (step.is_outward ? 1U : 0U) + (step.passes ? 1U : 0U);
    return kStep * (1 + 4 * (std::uint64_t{step.step} + 256 * std::uint64_t{step.potential}) + side);
  }
  static std::uint64_t product(double number, std::uint64_t factor, int turn) {
    return std::rotl(bit_cast<std::uint64_t>(number) * factor, turn);
  }
  // Source: Steele, Lea and Flood, OOPSLA (2014) 453, the finaliser of SplitMix.
  static std::uint64_t mixed(std::uint64_t word) {
    word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9;
    word = (word ^ (word >> 27)) * 0x94d049bb133111eb;
    return word ^ (word >> 31);
  }

  static constexpr std::uint64_t kStart = 0x48617264'62616c6c;  // the value before the first contact
  static constexpr std::uint64_t kWall = 0x589965cc75374cc3;
  static constexpr std::uint64_t kStep = 0xd1342543de82ef95;

  std::uint64_t sum_ = 0;
};

/// A hash as it is shown: 16 hexadecimal digits.
HARDBALL_EXPORT std::string hash_text(std::uint64_t hash);

}  // namespace hardball
