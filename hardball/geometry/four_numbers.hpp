// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace hardball {

/// Four numbers with which the same is done: all machines have instructions for two at a time.
class FourNumbers {
  using Two = double __attribute__((vector_size(16)));

 public:
  static constexpr std::size_t kCount = 4;

  /// Four zeros.
  FourNumbers() = default;
  /// One number four times.
  explicit FourNumbers(double all) : first_{all, all}, second_{all, all} {}
  template <class Number>
  explicit FourNumbers(const std::array<Number, kCount>& numbers)
      : first_{static_cast<double>(numbers[0]), static_cast<double>(numbers[1])},
        second_{static_cast<double>(numbers[2]), static_cast<double>(numbers[3])} {}

  double operator[](std::size_t i) const { return i < 2 ? first_[i] : second_[i - 2]; }

  friend FourNumbers operator+(const FourNumbers& a, const FourNumbers& b) {
    return {a.first_ + b.first_, a.second_ + b.second_};
  }
  friend FourNumbers operator-(const FourNumbers& a, const FourNumbers& b) {
    return {a.first_ - b.first_, a.second_ - b.second_};
  }
  friend FourNumbers operator*(const FourNumbers& a, const FourNumbers& b) {
    return {a.first_ * b.first_, a.second_ * b.second_};
  }
  friend FourNumbers operator/(const FourNumbers& a, const FourNumbers& b) {
    return {a.first_ / b.first_, a.second_ / b.second_};
  }
  /// Where a > b, a, elsewhere b: b where one is not a number.
  friend FourNumbers larger(const FourNumbers& a, const FourNumbers& b) {
#ifdef __SSE2__
    return {__builtin_ia32_maxpd(a.first_, b.first_), __builtin_ia32_maxpd(a.second_, b.second_)};
#else
    return select(a, b, a, b);
#endif
  }
  /// Where a < b, a, elsewhere b: b where one is not a number.
  friend FourNumbers smaller(const FourNumbers& a, const FourNumbers& b) {
#ifdef __SSE2__
    return {__builtin_ia32_minpd(a.first_, b.first_), __builtin_ia32_minpd(a.second_, b.second_)};
#else
    return select(b, a, a, b);
#endif
  }
  /// Whether a > b for all four.
  friend bool are_larger(const FourNumbers& a, const FourNumbers& b) {
#ifdef __SSE2__
    const int lanes =
        __builtin_ia32_movmskpd(a.first_ > b.first_) & __builtin_ia32_movmskpd(a.second_ > b.second_);
    return lanes == 3;
#else
    return a[0] > b[0] && a[1] > b[1] && a[2] > b[2] && a[3] > b[3];
#endif
  }
  /// Where a > b, one number, elsewhere another.
  friend FourNumbers select(const FourNumbers& a, const FourNumbers& b, const FourNumbers& where_larger,
                            const FourNumbers& elsewhere) {
    return {a.first_ > b.first_ ? where_larger.first_ : elsewhere.first_,
            a.second_ > b.second_ ? where_larger.second_ : elsewhere.second_};
  }
  friend FourNumbers square_root(const FourNumbers& a) {
    return {Two{std::sqrt(a.first_[0]), std::sqrt(a.first_[1])},
            Two{std::sqrt(a.second_[0]), std::sqrt(a.second_[1])}};
  }

 private:
  FourNumbers(const Two& first, const Two& second) : first_(first), second_(second) {}

  Two first_{};
  Two second_{};
};

}  // namespace hardball
