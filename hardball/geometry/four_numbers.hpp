// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

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
    return {_mm_max_pd(a.first_, b.first_), _mm_max_pd(a.second_, b.second_)};
#else
    return select(a, b, a, b);
#endif
  }
  /// Where a < b, a, elsewhere b: b where one is not a number.
  friend FourNumbers smaller(const FourNumbers& a, const FourNumbers& b) {
#ifdef __SSE2__
    return {_mm_min_pd(a.first_, b.first_), _mm_min_pd(a.second_, b.second_)};
#else
    return select(b, a, a, b);
#endif
  }
  /// Whether a > b for all four.
  friend bool are_larger(const FourNumbers& a, const FourNumbers& b) {
#ifdef __SSE2__
    const __m128d both = _mm_and_pd(_mm_cmpgt_pd(a.first_, b.first_), _mm_cmpgt_pd(a.second_, b.second_));
    return _mm_movemask_pd(both) == 3;
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
#ifdef __SSE2__
    return {_mm_sqrt_pd(a.first_), _mm_sqrt_pd(a.second_)};
#else
    return {Two{std::sqrt(a.first_[0]), std::sqrt(a.first_[1])},
            Two{std::sqrt(a.second_[0]), std::sqrt(a.second_[1])}};
#endif
  }

 private:
  FourNumbers(const Two& first, const Two& second) : first_(first), second_(second) {}

  Two first_{};
  Two second_{};
};

}  // namespace hardball
