// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#if defined(__AVX512F__)

#include <immintrin.h>

#include <cstddef>
#include <cstdint>

#include "hardball/kernels/bound_kernel_body.hpp"
#include "hardball/kernels/near_kernel_body.hpp"

namespace hardball {
namespace {

/// Sixteen numbers of single precision in 512 bits.
struct Floats {
  static constexpr std::size_t kWidth = 16;

  struct Mask {
    __mmask16 v;
    friend Mask operator&&(const Mask& a, const Mask& b) { return {_kand_mask16(a.v, b.v)}; }
    friend Mask operator||(const Mask& a, const Mask& b) { return {_kor_mask16(a.v, b.v)}; }
  };

  struct Integers {
    Integers() = default;
    Integers(__m512i vector) : v(vector) {}
    explicit Integers(std::int32_t value) : v(_mm512_set1_epi32(value)) {}
    explicit Integers(std::uint32_t value) : Integers(static_cast<std::int32_t>(value)) {}
    static Integers load(const std::uint32_t* values) { return _mm512_loadu_si512(values); }
    static Integers load_halves(const std::uint32_t* low, const std::uint32_t* high) {
      return of(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(low)),
                _mm256_loadu_si256(reinterpret_cast<const __m256i*>(high)));
    }
    static Integers of_halves(std::int32_t low, std::int32_t high) {
      return of(_mm256_set1_epi32(low), _mm256_set1_epi32(high));
    }
    void store(std::uint32_t* values) const { _mm512_storeu_si512(values, v); }
    // Compress to a register, then store: some processors are very slow at doing both in one instruction.
    void keep(unsigned lanes, std::uint32_t* out) const {
      _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(static_cast<__mmask16>(lanes), v));
    }
    static Integers ascending() {
      return _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    }
    friend Integers operator+(const Integers& a, const Integers& b) { return _mm512_add_epi32(a.v, b.v); }
    friend Integers operator-(const Integers& a, const Integers& b) { return _mm512_sub_epi32(a.v, b.v); }
    friend Integers operator&(const Integers& a, const Integers& b) { return _mm512_and_si512(a.v, b.v); }
    friend Integers operator|(const Integers& a, const Integers& b) { return _mm512_or_si512(a.v, b.v); }

    __m512i v;

   private:
    static Integers of(__m256i low, __m256i high) {
      return _mm512_inserti64x4(_mm512_castsi256_si512(low), high, 1);
    }
  };

  Floats() = default;
  Floats(__m512 vector) : v(vector) {}
  explicit Floats(float value) : v(_mm512_set1_ps(value)) {}

  static Floats load(const float* values) { return _mm512_loadu_ps(values); }
  static Floats gather(const float* values, const std::uint32_t* at) {
    return _mm512_i32gather_ps(_mm512_loadu_si512(at), values, sizeof(float));
  }
  // Each lane's number modulo eight says which of eight values.
  static Floats pick(const float* eight, const Integers& which) {
    return _mm512_permutexvar_ps(which.v, _mm512_broadcast_f32x8(_mm256_loadu_ps(eight)));
  }

  // Rows of eight numbers are transposed in four by four: in each result positions are in the even quarters
  // and velocities in the odd ones.
  struct Eight {
    __m512 a, b, c, d;
  };
  static Eight transposed(const CompactPath* paths, const std::uint32_t* at) {
    const auto row = [&](std::size_t lane) {
      return _mm256_load_ps(reinterpret_cast<const float*>(paths + at[lane]));
    };
    const auto rows = [&](std::size_t lane) {
      return _mm512_insertf32x8(_mm512_castps256_ps512(row(lane)), row(lane + 4), 1);
    };
    const __m512 r0 = rows(0);
    const __m512 r1 = rows(1);
    const __m512 r2 = rows(2);
    const __m512 r3 = rows(3);
    const __m512d low01 = _mm512_castps_pd(_mm512_unpacklo_ps(r0, r1));
    const __m512d high01 = _mm512_castps_pd(_mm512_unpackhi_ps(r0, r1));
    const __m512d low23 = _mm512_castps_pd(_mm512_unpacklo_ps(r2, r3));
    const __m512d high23 = _mm512_castps_pd(_mm512_unpackhi_ps(r2, r3));
    return {_mm512_castpd_ps(_mm512_unpacklo_pd(low01, low23)),
            _mm512_castpd_ps(_mm512_unpackhi_pd(low01, low23)),
            _mm512_castpd_ps(_mm512_unpacklo_pd(high01, high23)),
            _mm512_castpd_ps(_mm512_unpackhi_pd(high01, high23))};
  }
  static void load(const CompactPath* paths, const std::uint32_t* at, CompactPathsOfLanes<Floats>& out) {
    static_assert(sizeof(CompactPath) == 8 * sizeof(float));
    constexpr int kEven = 0b10'00'10'00;
    constexpr int kOdd = 0b11'01'11'01;
    const Eight low = transposed(paths, at);
    const Eight high = transposed(paths, at + 8);
    out.x = _mm512_castps_si512(_mm512_shuffle_f32x4(low.a, high.a, kEven));
    out.y = _mm512_castps_si512(_mm512_shuffle_f32x4(low.b, high.b, kEven));
    out.z = _mm512_castps_si512(_mm512_shuffle_f32x4(low.c, high.c, kEven));
    out.tick = _mm512_castps_si512(_mm512_shuffle_f32x4(low.d, high.d, kEven));
    out.velocity = {_mm512_shuffle_f32x4(low.a, high.a, kOdd), _mm512_shuffle_f32x4(low.b, high.b, kOdd),
                    _mm512_shuffle_f32x4(low.c, high.c, kOdd)};
    out.revision = _mm512_castps_si512(_mm512_shuffle_f32x4(low.d, high.d, kOdd));
  }

  __m512 v;
};

Floats operator+(const Floats& a, const Floats& b) {
  return _mm512_add_ps(a.v, b.v);
}
Floats operator-(const Floats& a, const Floats& b) {
  return _mm512_sub_ps(a.v, b.v);
}
Floats operator*(const Floats& a, const Floats& b) {
  return _mm512_mul_ps(a.v, b.v);
}
Floats operator/(const Floats& a, const Floats& b) {
  return _mm512_div_ps(a.v, b.v);
}
Floats multiply_add(const Floats& a, const Floats& b, const Floats& c) {
  return _mm512_fmadd_ps(a.v, b.v, c.v);
}
Floats::Mask operator<(const Floats& a, const Floats& b) {
  return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ)};
}
// Of numbers with a sign.
Floats::Mask operator<(const Floats::Integers& a, const Floats::Integers& b) {
  return {_mm512_cmplt_epi32_mask(a.v, b.v)};
}
Floats::Mask operator>=(const Floats& a, const Floats& b) {
  return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_GE_OQ)};
}
Floats::Mask operator==(const Floats::Integers& a, const Floats::Integers& b) {
  return {_mm512_cmpeq_epi32_mask(a.v, b.v)};
}
Floats::Mask operator!(const Floats::Mask& mask) {
  return {_knot_mask16(mask.v)};
}
unsigned bits(const Floats::Mask& mask) {
  return _cvtmask16_u32(mask.v);
}
Floats select(const Floats::Mask& mask, const Floats& a, const Floats& b) {
  return _mm512_mask_blend_ps(mask.v, b.v, a.v);
}
Floats::Integers select(const Floats::Mask& mask, const Floats::Integers& a, const Floats::Integers& b) {
  return _mm512_mask_blend_epi32(mask.v, b.v, a.v);
}
// Of a NaN and a number, the second argument.
Floats maximum(const Floats& a, const Floats& b) {
  return _mm512_max_ps(a.v, b.v);
}
Floats minimum(const Floats& a, const Floats& b) {
  return _mm512_min_ps(a.v, b.v);
}
Floats square_root(const Floats& a) {
  return _mm512_sqrt_ps(a.v);
}
Floats to_floats(const Floats::Integers& a) {
  return _mm512_cvtepi32_ps(a.v);
}
Floats::Integers bits_of(const Floats& a) {
  return _mm512_castps_si512(a.v);
}
template <int count>
Floats::Integers shifted_right(const Floats::Integers& a) {
  return _mm512_srli_epi32(a.v, count);
}
Floats::Integers minimum(const Floats::Integers& a, const Floats::Integers& b) {
  return _mm512_min_epu32(a.v, b.v);
}
std::uint32_t least_of(const Floats::Integers& a) {
  const __m256i eight = _mm256_min_epu32(_mm512_castsi512_si256(a.v), _mm512_extracti64x4_epi64(a.v, 1));
  const __m128i four = _mm_min_epu32(_mm256_castsi256_si128(eight), _mm256_extracti128_si256(eight, 1));
  const __m128i two = _mm_min_epu32(four, _mm_shuffle_epi32(four, 0b01'00'11'10));
  return static_cast<std::uint32_t>(_mm_cvtsi128_si32(_mm_min_epu32(two, _mm_srli_epi64(two, 32))));
}

}  // namespace
}  // namespace hardball

#endif
