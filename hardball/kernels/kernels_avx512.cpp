// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)

#include "hardball/kernels/eight_lanes.hpp"
#include "hardball/kernels/four_lanes.hpp"
#include "hardball/kernels/kernels.hpp"

// Mask registers, and vectors of 256 bits: with 512 bits whole runs are slower, as one of three vector ports
// is closed.
namespace hardball {
namespace {

struct Lanes::Mask {
  __mmask8 v;
  friend Mask operator&(const Mask& a, const Mask& b) { return {_kand_mask8(a.v, b.v)}; }
  friend Mask operator|(const Mask& a, const Mask& b) { return {_kor_mask8(a.v, b.v)}; }
};

Lanes::Mask operator<(const Lanes& a, const Lanes& b) {
  return {_mm256_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ)};
}
Lanes::Mask operator>(const Lanes& a, const Lanes& b) {
  return {_mm256_cmp_pd_mask(a.v, b.v, _CMP_GT_OQ)};
}
Lanes::Mask operator<=(const Lanes& a, const Lanes& b) {
  return {_mm256_cmp_pd_mask(a.v, b.v, _CMP_LE_OQ)};
}
Lanes::Mask operator==(const Lanes& a, const Lanes& b) {
  return {_mm256_cmp_pd_mask(a.v, b.v, _CMP_EQ_OQ)};
}
Lanes::Mask not_(const Lanes::Mask& mask) {
  return {_knot_mask8(mask.v)};
}
unsigned bits(const Lanes::Mask& mask) {
  return _cvtmask8_u32(mask.v);
}
Lanes select(const Lanes::Mask& mask, const Lanes& a, const Lanes& b) {
  return _mm256_mask_blend_pd(mask.v, b.v, a.v);
}

// Compress to a register, then store: some processors are very slow at doing both in one instruction.
void Floats::keep(const std::uint32_t* at, unsigned lanes, std::uint32_t* out) {
  const __m256i slots = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(at));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out),
                      _mm256_maskz_compress_epi32(static_cast<__mmask8>(lanes), slots));
}

}  // namespace

const Kernels kAvx512Kernels{earliest_contact<Lanes>, contacts_of_pairs<Lanes>, bound_contacts<Floats>,
                             pick_near<Floats>};

}  // namespace hardball

#endif
