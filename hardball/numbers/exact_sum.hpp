// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/standard/bit_cast.hpp"

namespace hardball {

/// A sum of doubles without rounding errors, rounded once when it is read: the same to the bit in whichever
/// order the numbers are added, and however they are divided among several sums.
///
/// Numbers whose sign and exponent lie in a window of 32 go to a bin of their own, where their mantissas are
/// added as integers. All others, and from time to time what is in the bins, go to a number of as many bits
/// as the sum needs. The window follows the numbers. Memory: some 400 bytes for numbers of similar magnitude,
/// at most 900. Source: Neal, arXiv:1505.05571 (2015), whose large superaccumulator has bins for all
/// exponents.
class HARDBALL_EXPORT ExactSum {
 public:
  ExactSum() = default;
  explicit ExactSum(double number) { *this += number; }

  /// Adds a number. Cost: some 10 instructions for most numbers of similar magnitude and one sign, some 50
  /// for others.
  ExactSum& operator+=(double number) {
    const auto bits = bit_cast<std::uint64_t>(number);
    const std::uint32_t bin = sign_and_exponent(bits) - window_;
    if (bin >= kBins) [[unlikely]] {
      if (number != 0) add_outside(bits);
      return *this;
    }
    bins_[bin] += (bits & kFraction) | kLeadingBit;
    if (--room_ == 0) [[unlikely]]
      empty_bins();
    return *this;
  }
  /// Adds all numbers of another sum.
  void add(const ExactSum& other);
  /// The sum, rounded to the nearest double, to even in the middle. As a sum of doubles in any order it is
  /// infinite or NaN if a number was, or NaN for infinities of both signs; but no sum in between overflows.
  /// Zero is positive.
  double value() const;

 private:
  friend class Persistence;
  // Equal sums have equal bytes.
  static void persist(auto& archive, auto& self) {
    if constexpr (std::remove_cvref_t<decltype(archive)>::kIsReading) {
      self = ExactSum();
      archive(self.specials_, self.first_, self.digits_);
    } else {
      const ExactSum reduced = self.reduced();
      archive(reduced.specials_, reduced.first_, reduced.digits_);
    }
  }
  bool restored() const;

  static constexpr int kFractionBits = 52;
  static constexpr std::uint64_t kLeadingBit = std::uint64_t{1} << kFractionBits;
  static constexpr std::uint64_t kFraction = kLeadingBit - 1;
  static constexpr std::uint32_t kBins = 32;
  static constexpr std::uint32_t kRoom = 1024;     // so many mantissas of 53 bits are less than 2^63
  static constexpr std::uint32_t kNowhere = 4096;  // beyond all signs and exponents
  // Numbers outside after which the window moves.
  static constexpr std::uint32_t kPatience = 16;
  // What has been added besides finite numbers, as bits.
  enum Special : std::uint8_t { kInfinity = 1, kMinusInfinity = 2, kNan = 4 };

  static std::uint32_t sign_and_exponent(std::uint64_t bits) {
    return static_cast<std::uint32_t>(bits >> kFractionBits);
  }
  void add_outside(std::uint64_t bits);
  void add_special(std::uint64_t bits);
  void add_at(std::int64_t number, std::uint32_t place);
  void make_room(std::size_t first, std::size_t end);
  void empty_bins();
  void move_window(std::uint32_t sign_and_exponent);
  void carry();
  void trim();
  ExactSum reduced() const;
  bool is_negative() const { return !digits_.empty() && digits_.back() < 0; }
  void negate();

  // Sums of mantissas, the first for the sign and exponent `window_`.
  std::array<std::uint64_t, kBins> bins_{};
  std::uint32_t window_ = kNowhere;
  std::uint32_t room_ = kRoom;  // how many more mantissas the bins hold
  std::uint32_t outside_ = 0;   // numbers outside the window since the bins were emptied
  std::uint32_t uncarried_ = 0;
  std::uint32_t first_ = 0;
  std::uint8_t specials_ = 0;
  // The sum of digits_[k] * 2^(32 * (first_ + k) - 1074). After `carry` they are nonnegative and below 2^32,
  // but for the last, which has the sign of the sum and is at least -2^31 and less than 2^31.
  std::vector<std::int64_t> digits_;
};

}  // namespace hardball
