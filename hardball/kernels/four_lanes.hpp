// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#if defined(__AVX2__)

#include <immintrin.h>

#include "hardball/kernels/contact_kernel_body.hpp"

namespace hardball {
// Each file that includes this has its own copy, compiled for its own instructions, and defines masks,
// comparison and selection itself.
namespace {

/// Four numbers in 256 bits.
struct Lanes {
  static constexpr std::size_t kWidth = 4;
  struct Mask;

  Lanes() = default;
  Lanes(__m256d vector) : v(vector) {}
  explicit Lanes(double value) : v(_mm256_set1_pd(value)) {}

  static Lanes load(const double* values) { return _mm256_loadu_pd(values); }
  static Lanes gather(const double* values, const std::uint32_t* at) {
    return _mm256_setr_pd(values[at[0]], values[at[1]], values[at[2]], values[at[3]]);
  }
  // Two members of four paths: the rows of pairs (0, 2) and (1, 3), interleaved.
  static void load_pair(const Path* paths, const std::uint32_t* at, std::size_t member, Lanes& first,
                        Lanes& second) {
    const auto pair = [&](int lane) {
      return _mm_load_pd(reinterpret_cast<const double*>(paths + at[lane]) + member);
    };
    const __m256d even = _mm256_insertf128_pd(_mm256_castpd128_pd256(pair(0)), pair(2), 1);
    const __m256d odd = _mm256_insertf128_pd(_mm256_castpd128_pd256(pair(1)), pair(3), 1);
    first = _mm256_unpacklo_pd(even, odd);
    second = _mm256_unpackhi_pd(even, odd);
  }
  static void load(const Path* paths, const std::uint32_t* at, PathOf<Lanes>& out) {
    static_assert(sizeof(Path) == 8 * sizeof(double));
    load_pair(paths, at, 0, out.position.x, out.position.y);
    load_pair(paths, at, 2, out.position.z, out.velocity.x);
    load_pair(paths, at, 4, out.velocity.y, out.velocity.z);
    load_pair(paths, at, 6, out.time.high, out.time.low);
  }
  void store(double* out) const { _mm256_storeu_pd(out, v); }

  __m256d v;
};

Lanes operator+(const Lanes& a, const Lanes& b) {
  return _mm256_add_pd(a.v, b.v);
}
Lanes operator-(const Lanes& a, const Lanes& b) {
  return _mm256_sub_pd(a.v, b.v);
}
Lanes operator*(const Lanes& a, const Lanes& b) {
  return _mm256_mul_pd(a.v, b.v);
}
Lanes operator/(const Lanes& a, const Lanes& b) {
  return _mm256_div_pd(a.v, b.v);
}
Lanes product_error(const Lanes& a, const Lanes& b, const Lanes& product) {
  return _mm256_fmsub_pd(a.v, b.v, product.v);
}
Lanes maximum(const Lanes& a, const Lanes& b) {
  return _mm256_max_pd(a.v, b.v);
}
Lanes minimum(const Lanes& a, const Lanes& b) {
  return _mm256_min_pd(a.v, b.v);
}
Lanes square_root(const Lanes& a) {
  return _mm256_sqrt_pd(a.v);
}
double least_of(const Lanes& a) {
  const __m128d half = _mm_min_pd(_mm256_castpd256_pd128(a.v), _mm256_extractf128_pd(a.v, 1));
  return _mm_cvtsd_f64(_mm_min_sd(half, _mm_unpackhi_pd(half, half)));
}
Lanes round_to_integer(const Lanes& a) {
  return _mm256_round_pd(a.v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}

}  // namespace
}  // namespace hardball

#endif
