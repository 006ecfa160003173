// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/numbers/exact_sum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

constexpr std::uint32_t kSignBit = 0x800;       // of sign and exponent
constexpr std::uint32_t kExponentMask = 0x7ff;  // the exponent of infinity and NaN, too
constexpr int kDigitBits = 32;
constexpr std::int64_t kDigitMask = 0xffffffff;
constexpr std::int64_t kHalfDigit = std::int64_t{1} << (kDigitBits - 1);
// Digits grow by less than 2^32 with each number.
constexpr std::uint32_t kMostUncarried = std::uint32_t{1} << 30;
// More than 2^64 of the largest doubles need.
constexpr std::size_t kMostDigits = 70;
constexpr int kLowestExponent = -1074;  // of the least double

}  // namespace

void ExactSum::add_outside(std::uint64_t bits) {
  const std::uint32_t place = sign_and_exponent(bits);
  const std::uint32_t exponent = place & kExponentMask;
  if (exponent == kExponentMask) return add_special(bits);
  const std::uint64_t fraction = bits & kFraction;
  const auto mantissa = static_cast<std::int64_t>(exponent == 0 ? fraction : fraction | kLeadingBit);
  add_at((place & kSignBit) != 0 ? -mantissa : mantissa, exponent == 0 ? 0 : exponent - 1);
  if (exponent != 0 && (window_ == kNowhere || ++outside_ > kPatience)) move_window(place);
}

void ExactSum::add_special(std::uint64_t bits) {
  if ((bits & kFraction) != 0) {
    specials_ |= kNan;
  } else {
    specials_ |= (sign_and_exponent(bits) & kSignBit) != 0 ? kMinusInfinity : kInfinity;
  }
}

// Adds a number times 2^(place - 1074).
void ExactSum::add_at(std::int64_t number, std::uint32_t place) {
  const std::uint32_t digit = place / kDigitBits;
  const std::uint32_t shift = place % kDigitBits;
  make_room(digit, digit + 3);
  std::int64_t* const at = &digits_[digit - first_];
  const std::int64_t rest = number >> (kDigitBits - shift);
  at[0] += static_cast<std::int64_t>(static_cast<std::uint64_t>(number) << shift) & kDigitMask;
  at[1] += rest & kDigitMask;
  at[2] += rest >> kDigitBits;
  if (++uncarried_ == kMostUncarried) carry();
}

// So that there are the digits from `first` up to `end`.
void ExactSum::make_room(std::size_t first, std::size_t end) {
  if (digits_.empty()) first_ = static_cast<std::uint32_t>(first);
  if (first < first_) {
    digits_.insert(digits_.begin(), first_ - first, 0);
    first_ = static_cast<std::uint32_t>(first);
  }
  if (end > first_ + digits_.size()) digits_.resize(end - first_);
}

void ExactSum::empty_bins() {
  const bool is_negative = (window_ & kSignBit) != 0;
  const std::uint32_t exponent = window_ & kExponentMask;
  for (std::uint32_t bin = 0; bin < kBins; ++bin) {
    if (bins_[bin] == 0) continue;
    const auto sum = static_cast<std::int64_t>(bins_[bin]);
    add_at(is_negative ? -sum : sum, exponent + bin - 1);
    bins_[bin] = 0;
  }
  room_ = kRoom;
  outside_ = 0;
}

// Where a number lies in its upper quarter, without zero, subnormal numbers and infinity.
void ExactSum::move_window(std::uint32_t sign_and_exponent) {
  empty_bins();
  constexpr std::uint32_t kBelow = kBins / 4 * 3;
  const std::uint32_t exponent = std::max(sign_and_exponent & kExponentMask, kBelow + 1) - kBelow;
  window_ = (sign_and_exponent & kSignBit) | std::min(exponent, kExponentMask - kBins);
}

void ExactSum::carry() {
  if (digits_.empty()) return;
  for (std::size_t k = 0; k + 1 < digits_.size(); ++k) {
    digits_[k + 1] += digits_[k] >> kDigitBits;
    digits_[k] &= kDigitMask;
  }
  while (digits_.back() < -kHalfDigit || digits_.back() >= kHalfDigit) {
    const std::int64_t rest = digits_.back() >> kDigitBits;
    digits_.back() &= kDigitMask;
    digits_.push_back(rest);
  }
  uncarried_ = 0;
}

// Removes digits without which the carried number is the same: there is one number of least digits.
void ExactSum::trim() {
  while (digits_.size() > 1) {
    const std::int64_t below = digits_[digits_.size() - 2];
    const bool is_needless = digits_.back() == (below < kHalfDigit ? 0 : -1);
    if (!is_needless) break;
    digits_.pop_back();
    if (below >= kHalfDigit) digits_.back() -= kDigitMask + 1;
  }
  const auto nonzero = ranges::find_if(digits_, [](std::int64_t digit) { return digit != 0; });
  first_ += static_cast<std::uint32_t>(nonzero - digits_.begin());
  digits_.erase(digits_.begin(), nonzero);
  if (digits_.empty()) first_ = 0;
}

// This sum in canonical form: nothing in the bins, the fewest digits, and none beside infinity or NaN.
ExactSum ExactSum::reduced() const {
  ExactSum sum;
  if (specials_ != 0) {
    const bool is_infinite = specials_ == kInfinity || specials_ == kMinusInfinity;
    sum.specials_ = is_infinite ? specials_ : std::uint8_t{kNan};
    return sum;
  }
  sum = *this;
  sum.empty_bins();
  sum.carry();
  sum.trim();
  return sum;
}

void ExactSum::add(const ExactSum& other) {
  const ExactSum added = other.reduced();
  specials_ |= added.specials_;
  if (added.digits_.empty()) return;
  make_room(added.first_, added.first_ + added.digits_.size());
  for (std::size_t k = 0; k < added.digits_.size(); ++k) {
    digits_[added.first_ + k - first_] += added.digits_[k];
  }
  carry();
}

void ExactSum::negate() {
  for (std::int64_t& digit : digits_) digit = -digit;
  carry();
}

double ExactSum::value() const {
  ExactSum sum = reduced();
  if (sum.specials_ == kNan) return std::numeric_limits<double>::quiet_NaN();
  if (sum.specials_ != 0) {
    const double infinity = std::numeric_limits<double>::infinity();
    return sum.specials_ == kInfinity ? infinity : -infinity;
  }
  const bool is_negative = sum.is_negative();
  if (is_negative) sum.negate();
  while (!sum.digits_.empty() && sum.digits_.back() == 0) sum.digits_.pop_back();
  if (sum.digits_.empty()) return 0;
  // The upper 64 bits, and whether there are more.
  const auto digit_below_top = [&sum](std::size_t k) {
    return k < sum.digits_.size() ? static_cast<std::uint64_t>(sum.digits_[sum.digits_.size() - 1 - k]) : 0;
  };
  std::uint64_t top = digit_below_top(0) << kDigitBits | digit_below_top(1);
  const int shift = std::countl_zero(top);
  top = top << shift | digit_below_top(2) >> (kDigitBits - shift);
  bool has_more = (digit_below_top(2) << shift & std::uint64_t{kDigitMask}) != 0;
  for (std::size_t k = 3; k < sum.digits_.size(); ++k) has_more = has_more || digit_below_top(k) != 0;
  // Rounded to 53 of them.
  constexpr int kDropped = 64 - kFractionBits - 1;
  constexpr std::uint64_t kHalf = std::uint64_t{1} << (kDropped - 1);
  std::uint64_t mantissa = top >> kDropped;
  const std::uint64_t dropped = top & (2 * kHalf - 1);
  if (dropped > kHalf || (dropped == kHalf && (has_more || mantissa % 2 != 0))) ++mantissa;
  const int place = kDigitBits * (static_cast<int>(sum.first_ + sum.digits_.size()) - 2) - shift + kDropped;
  const double magnitude = std::ldexp(static_cast<double>(mantissa), place + kLowestExponent);
  return is_negative ? -magnitude : magnitude;
}

bool ExactSum::restored() const {
  if (specials_ > (kInfinity | kMinusInfinity | kNan)) return false;
  if (digits_.empty()) return true;
  if (first_ > kMostDigits || digits_.size() > kMostDigits - first_) return false;
  return std::all_of(digits_.begin(), digits_.end() - 1,
                     [](std::int64_t digit) { return digit >= 0 && digit <= kDigitMask; }) &&
         digits_.back() >= -kHalfDigit && digits_.back() < kHalfDigit;
}

}  // namespace hardball
