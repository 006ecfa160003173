// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#if defined(__AVX2__)

#include <immintrin.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "hardball/kernels/bound_kernel_body.hpp"
#include "hardball/kernels/near_kernel_body.hpp"

namespace hardball {
namespace {

/// Eight numbers of single precision in 256 bits.
struct Floats {
  static constexpr std::size_t kWidth = 8;

  struct Mask {
    __m256 v;
    friend Mask operator&&(const Mask& a, const Mask& b) { return {_mm256_and_ps(a.v, b.v)}; }
    friend Mask operator||(const Mask& a, const Mask& b) { return {_mm256_or_ps(a.v, b.v)}; }
  };

  struct Integers {
    Integers() = default;
    Integers(__m256i vector) : v(vector) {}
    explicit Integers(std::int32_t value) : v(_mm256_set1_epi32(value)) {}
    explicit Integers(std::uint32_t value) : Integers(static_cast<std::int32_t>(value)) {}
    static Integers load(const std::uint32_t* values) {
      return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(values));
    }
    static Integers load_halves(const std::uint32_t* block, const std::uint32_t* /*none*/) {
      return load(block);
    }
    static Integers of_halves(std::int32_t value, std::int32_t /*none*/) { return Integers(value); }
    void store(std::uint32_t* values) const { _mm256_storeu_si256(reinterpret_cast<__m256i*>(values), v); }
    // Moves the chosen numbers to the front.
    void keep(unsigned lanes, std::uint32_t* out) const {
      // The lanes to take for each choice.
      struct Orders {
        alignas(8) unsigned char lanes[256][8];
        constexpr Orders() : lanes() {
          for (unsigned choice = 0; choice < 256; ++choice) {
            unsigned kept = 0;
            for (unsigned char lane = 0; lane < 8; ++lane) {
              if ((choice >> lane & 1) != 0) lanes[choice][kept++] = lane;
            }
          }
        }
      };
      static constexpr Orders kOrders;
      const __m256i order =
          _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(kOrders.lanes[lanes])));
      Integers(_mm256_permutevar8x32_epi32(v, order)).store(out);
    }
    static Integers ascending() { return _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7); }
    friend Integers operator+(const Integers& a, const Integers& b) { return _mm256_add_epi32(a.v, b.v); }
    friend Integers operator-(const Integers& a, const Integers& b) { return _mm256_sub_epi32(a.v, b.v); }
    friend Integers operator&(const Integers& a, const Integers& b) { return _mm256_and_si256(a.v, b.v); }
    friend Integers operator|(const Integers& a, const Integers& b) { return _mm256_or_si256(a.v, b.v); }

    __m256i v;
  };

  Floats() = default;
  Floats(__m256 vector) : v(vector) {}
  explicit Floats(float value) : v(_mm256_set1_ps(value)) {}

  static Floats load(const float* values) { return _mm256_loadu_ps(values); }
  static Floats gather(const float* values, const std::uint32_t* at) {
    return _mm256_setr_ps(values[at[0]], values[at[1]], values[at[2]], values[at[3]], values[at[4]],
                          values[at[5]], values[at[6]], values[at[7]]);
  }

  // Each lane's number modulo eight says which of eight values.
  static Floats pick(const float* eight, const Integers& which) {
    return _mm256_permutevar8x32_ps(_mm256_loadu_ps(eight), which.v);
  }

  // Four numbers of single precision at an address, from each of eight structures: rows (0, 4), (1, 5), (2,
  // 6) and (3, 7) are transposed.
  struct Four {
    __m256 a, b, c, d;
  };
  using Addresses = std::array<const float*, kWidth>;
  template <class Structure>
  static Addresses addresses(const Structure* structures, const std::uint32_t* at) {
    Addresses found;
    for (std::size_t lane = 0; lane < kWidth; ++lane) {
      found[lane] = reinterpret_cast<const float*>(structures + at[lane]);
    }
    return found;
  }
  static Four transposed(const Addresses& at, std::size_t member) {
    const auto rows = [&](std::size_t lane) {
      return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(at[lane] + member)),
                                  _mm_loadu_ps(at[lane + 4] + member), 1);
    };
    const __m256 r0 = rows(0);
    const __m256 r1 = rows(1);
    const __m256 r2 = rows(2);
    const __m256 r3 = rows(3);
    const __m256d low01 = _mm256_castps_pd(_mm256_unpacklo_ps(r0, r1));
    const __m256d high01 = _mm256_castps_pd(_mm256_unpackhi_ps(r0, r1));
    const __m256d low23 = _mm256_castps_pd(_mm256_unpacklo_ps(r2, r3));
    const __m256d high23 = _mm256_castps_pd(_mm256_unpackhi_ps(r2, r3));
    return {_mm256_castpd_ps(_mm256_unpacklo_pd(low01, low23)),
            _mm256_castpd_ps(_mm256_unpackhi_pd(low01, low23)),
            _mm256_castpd_ps(_mm256_unpacklo_pd(high01, high23)),
            _mm256_castpd_ps(_mm256_unpackhi_pd(high01, high23))};
  }
  static void load(const CompactPath* paths, const std::uint32_t* at, CompactPathsOfLanes<Floats>& out) {
    static_assert(sizeof(CompactPath) == 8 * sizeof(float));
    const Addresses from = addresses(paths, at);
    const Four position = transposed(from, 0);
    out.x = _mm256_castps_si256(position.a);
    out.y = _mm256_castps_si256(position.b);
    out.z = _mm256_castps_si256(position.c);
    out.tick = _mm256_castps_si256(position.d);
    const Four velocity = transposed(from, 4);
    out.velocity = {velocity.a, velocity.b, velocity.c};
    out.revision = _mm256_castps_si256(velocity.d);
  }

  __m256 v;
};

Floats operator+(const Floats& a, const Floats& b) {
  return _mm256_add_ps(a.v, b.v);
}
Floats operator-(const Floats& a, const Floats& b) {
  return _mm256_sub_ps(a.v, b.v);
}
Floats operator*(const Floats& a, const Floats& b) {
  return _mm256_mul_ps(a.v, b.v);
}
Floats operator/(const Floats& a, const Floats& b) {
  return _mm256_div_ps(a.v, b.v);
}
Floats multiply_add(const Floats& a, const Floats& b, const Floats& c) {
  return _mm256_fmadd_ps(a.v, b.v, c.v);
}
Floats::Mask operator<(const Floats& a, const Floats& b) {
  return {_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)};
}
// Of numbers with a sign.
Floats::Mask operator<(const Floats::Integers& a, const Floats::Integers& b) {
  return {_mm256_castsi256_ps(_mm256_cmpgt_epi32(b.v, a.v))};
}
Floats::Mask operator>=(const Floats& a, const Floats& b) {
  return {_mm256_cmp_ps(a.v, b.v, _CMP_GE_OQ)};
}
Floats::Mask operator==(const Floats::Integers& a, const Floats::Integers& b) {
  return {_mm256_castsi256_ps(_mm256_cmpeq_epi32(a.v, b.v))};
}
Floats::Mask operator!(const Floats::Mask& mask) {
  return {_mm256_xor_ps(mask.v, _mm256_castsi256_ps(_mm256_set1_epi32(-1)))};
}
unsigned bits(const Floats::Mask& mask) {
  return static_cast<unsigned>(_mm256_movemask_ps(mask.v));
}
Floats select(const Floats::Mask& mask, const Floats& a, const Floats& b) {
  return _mm256_blendv_ps(b.v, a.v, mask.v);
}
Floats::Integers select(const Floats::Mask& mask, const Floats::Integers& a, const Floats::Integers& b) {
  return _mm256_blendv_epi8(b.v, a.v, _mm256_castps_si256(mask.v));
}
// Of a NaN and a number, the second argument.
Floats maximum(const Floats& a, const Floats& b) {
  return _mm256_max_ps(a.v, b.v);
}
Floats minimum(const Floats& a, const Floats& b) {
  return _mm256_min_ps(a.v, b.v);
}
Floats square_root(const Floats& a) {
  return _mm256_sqrt_ps(a.v);
}
Floats to_floats(const Floats::Integers& a) {
  return _mm256_cvtepi32_ps(a.v);
}
Floats::Integers bits_of(const Floats& a) {
  return _mm256_castps_si256(a.v);
}
template <int count>
Floats::Integers shifted_right(const Floats::Integers& a) {
  return _mm256_srli_epi32(a.v, count);
}
Floats::Integers minimum(const Floats::Integers& a, const Floats::Integers& b) {
  return _mm256_min_epu32(a.v, b.v);
}
std::uint32_t least_of(const Floats::Integers& a) {
  const __m128i four = _mm_min_epu32(_mm256_castsi256_si128(a.v), _mm256_extracti128_si256(a.v, 1));
  const __m128i two = _mm_min_epu32(four, _mm_shuffle_epi32(four, 0b01'00'11'10));
  return static_cast<std::uint32_t>(_mm_cvtsi128_si32(_mm_min_epu32(two, _mm_srli_epi64(two, 32))));
}

}  // namespace
}  // namespace hardball

#endif
