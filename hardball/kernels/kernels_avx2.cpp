// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#if defined(__AVX2__)

#include "hardball/kernels/four_lanes.hpp"
#include "hardball/kernels/kernels.hpp"

namespace hardball {
namespace {

struct Lanes::Mask {
  __m256d v;
  friend Mask operator&(const Mask& a, const Mask& b) { return {_mm256_and_pd(a.v, b.v)}; }
  friend Mask operator|(const Mask& a, const Mask& b) { return {_mm256_or_pd(a.v, b.v)}; }
};

// Moves the chosen slots to the front: the byte order for each choice.
void Lanes::keep(const std::uint32_t* at, unsigned lanes, std::uint32_t* out) {
  struct Orders {
    alignas(16) unsigned char bytes[16][16];
    constexpr Orders() : bytes() {
      for (unsigned choice = 0; choice < 16; ++choice) {
        unsigned place = 0;
        for (unsigned lane = 0; lane < 4; ++lane) {
          if ((choice >> lane & 1) == 0) continue;
          for (unsigned byte = 0; byte < 4; ++byte) {
            bytes[choice][place++] = static_cast<unsigned char>(4 * lane + byte);
          }
        }
      }
    }
  };
  static constexpr Orders kOrders;
  const __m128i order = _mm_load_si128(reinterpret_cast<const __m128i*>(kOrders.bytes[lanes]));
  const __m128i slots = _mm_loadu_si128(reinterpret_cast<const __m128i*>(at));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(out), _mm_shuffle_epi8(slots, order));
}
Lanes::Mask operator<(const Lanes& a, const Lanes& b) {
  return {_mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ)};
}
Lanes::Mask operator>(const Lanes& a, const Lanes& b) {
  return {_mm256_cmp_pd(a.v, b.v, _CMP_GT_OQ)};
}
Lanes::Mask operator<=(const Lanes& a, const Lanes& b) {
  return {_mm256_cmp_pd(a.v, b.v, _CMP_LE_OQ)};
}
Lanes::Mask operator==(const Lanes& a, const Lanes& b) {
  return {_mm256_cmp_pd(a.v, b.v, _CMP_EQ_OQ)};
}
Lanes::Mask not_(const Lanes::Mask& mask) {
  return {_mm256_xor_pd(mask.v, _mm256_castsi256_pd(_mm256_set1_epi64x(-1)))};
}
unsigned bits(const Lanes::Mask& mask) {
  return static_cast<unsigned>(_mm256_movemask_pd(mask.v));
}
Lanes select(const Lanes::Mask& mask, const Lanes& a, const Lanes& b) {
  return _mm256_blendv_pd(b.v, a.v, mask.v);
}

}  // namespace

const Kernels kAvx2Kernels{earliest_contact<Lanes>, pick_near<Lanes>};

}  // namespace hardball

#endif
