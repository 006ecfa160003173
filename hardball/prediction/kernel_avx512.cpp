// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#if defined(__AVX512F__) && defined(__AVX512DQ__)

#include <immintrin.h>

#include "hardball/prediction/kernel_body.hpp"

namespace hardball {
namespace {

struct Lanes {
  static constexpr int kWidth = 8;
  struct Mask {
    __mmask8 v;
    friend Mask operator&(const Mask& a, const Mask& b) { return {_kand_mask8(a.v, b.v)}; }
    friend Mask operator|(const Mask& a, const Mask& b) { return {_kor_mask8(a.v, b.v)}; }
  };

  Lanes() = default;
  Lanes(__m512d vector) : v(vector) {}
  explicit Lanes(double value) : v(_mm512_set1_pd(value)) {}

  static Lanes load(const double* values) { return _mm512_loadu_pd(values); }
  static Lanes gather(const double* values, const std::uint32_t* at) {
    return _mm512_setr_pd(values[at[0]], values[at[1]], values[at[2]], values[at[3]], values[at[4]],
                          values[at[5]], values[at[6]], values[at[7]]);
  }
  // Four members of eight paths: the rows of pairs that lie two apart, interleaved, then sorted by member.
  static void load_quarter(const Path* paths, const std::uint32_t* at, std::size_t member, Lanes& first,
                           Lanes& second, Lanes& third, Lanes& fourth) {
    const auto row = [&](int lane) {
      return _mm256_load_pd(reinterpret_cast<const double*>(paths + at[lane]) + member);
    };
    const auto rows = [&](int lane) {
      return _mm512_insertf64x4(_mm512_castpd256_pd512(row(lane)), row(lane + 2), 1);
    };
    const __m512d a = rows(0);
    const __m512d b = rows(1);
    const __m512d c = rows(4);
    const __m512d d = rows(5);
    const __m512d odd_low = _mm512_unpacklo_pd(a, b);
    const __m512d even_low = _mm512_unpackhi_pd(a, b);
    const __m512d odd_high = _mm512_unpacklo_pd(c, d);
    const __m512d even_high = _mm512_unpackhi_pd(c, d);
    first = _mm512_shuffle_f64x2(odd_low, odd_high, 0x88);
    second = _mm512_shuffle_f64x2(even_low, even_high, 0x88);
    third = _mm512_shuffle_f64x2(odd_low, odd_high, 0xdd);
    fourth = _mm512_shuffle_f64x2(even_low, even_high, 0xdd);
  }
  static void load(const Path* paths, const std::uint32_t* at, PathsOfLanes<Lanes>& out) {
    static_assert(sizeof(Path) == 8 * sizeof(double));
    load_quarter(paths, at, 0, out.position.x, out.position.y, out.position.z, out.velocity.x);
    load_quarter(paths, at, 4, out.velocity.y, out.velocity.z, out.high, out.low);
  }
  void store(double* out) const { _mm512_storeu_pd(out, v); }

  __m512d v;
};

Lanes operator+(const Lanes& a, const Lanes& b) {
  return _mm512_add_pd(a.v, b.v);
}
Lanes operator-(const Lanes& a, const Lanes& b) {
  return _mm512_sub_pd(a.v, b.v);
}
Lanes operator*(const Lanes& a, const Lanes& b) {
  return _mm512_mul_pd(a.v, b.v);
}
Lanes operator/(const Lanes& a, const Lanes& b) {
  return _mm512_div_pd(a.v, b.v);
}
Lanes::Mask operator<(const Lanes& a, const Lanes& b) {
  return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ)};
}
Lanes::Mask operator>(const Lanes& a, const Lanes& b) {
  return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_GT_OQ)};
}
Lanes::Mask operator<=(const Lanes& a, const Lanes& b) {
  return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LE_OQ)};
}
Lanes::Mask operator==(const Lanes& a, const Lanes& b) {
  return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_EQ_OQ)};
}
Lanes::Mask not_(const Lanes::Mask& mask) {
  return {_knot_mask8(mask.v)};
}
unsigned bits(const Lanes::Mask& mask) {
  return _cvtmask8_u32(mask.v);
}
Lanes select(const Lanes::Mask& mask, const Lanes& a, const Lanes& b) {
  return _mm512_mask_blend_pd(mask.v, b.v, a.v);
}
Lanes maximum(const Lanes& a, const Lanes& b) {
  return _mm512_max_pd(a.v, b.v);
}
Lanes minimum(const Lanes& a, const Lanes& b) {
  return _mm512_min_pd(a.v, b.v);
}
Lanes square_root(const Lanes& a) {
  return _mm512_sqrt_pd(a.v);
}
double least_of(const Lanes& a) {
  return _mm512_reduce_min_pd(a.v);
}
Lanes round_to_integer(const Lanes& a) {
  return _mm512_roundscale_pd(a.v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}

}  // namespace

KernelResult avx512_kernel(const KernelQuery& query) {
  return run_kernel<Lanes>(query);
}

}  // namespace hardball

#endif
