// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#if defined(__AVX2__)

#include "hardball/kernels/eight_lanes.hpp"
#include "hardball/kernels/four_lanes.hpp"
#include "hardball/kernels/kernels.hpp"

namespace hardball {
namespace {

struct Lanes::Mask {
  __m256d v;
  friend Mask operator&(const Mask& a, const Mask& b) { return {_mm256_and_pd(a.v, b.v)}; }
  friend Mask operator|(const Mask& a, const Mask& b) { return {_mm256_or_pd(a.v, b.v)}; }
};

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

// Moves the chosen slots to the front: the lanes to take for each choice.
void Floats::keep(const std::uint32_t* at, unsigned lanes, std::uint32_t* out) {
  struct Orders {
    alignas(8) unsigned char lanes[256][8];
    constexpr Orders() : lanes() {
      for (unsigned choice = 0; choice < 256; ++choice) {
        unsigned place = 0;
        for (unsigned char lane = 0; lane < 8; ++lane) {
          if ((choice >> lane & 1) != 0) lanes[choice][place++] = lane;
        }
      }
    }
  };
  static constexpr Orders kOrders;
  const __m256i order =
      _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(kOrders.lanes[lanes])));
  const __m256i slots = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(at));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), _mm256_permutevar8x32_epi32(slots, order));
}

}  // namespace

const Kernels kAvx2Kernels{earliest_contact<Lanes>, contacts_of_pairs<Lanes>, bound_contacts<Floats>,
                           pick_near<Floats>};

}  // namespace hardball

#endif
