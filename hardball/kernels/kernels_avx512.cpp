// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)

#include "hardball/kernels/four_lanes.hpp"
#include "hardball/kernels/kernels.hpp"
#include "hardball/kernels/sixteen_lanes.hpp"

// Mask registers, and for exact times vectors of 256 bits: with 512 bits whole runs are slower on processors
// that close one of three vector ports for them.
namespace hardball {
namespace {

struct Lanes::Mask {
  __mmask8 v;
  friend Mask operator&&(const Mask& a, const Mask& b) { return {_kand_mask8(a.v, b.v)}; }
  friend Mask operator||(const Mask& a, const Mask& b) { return {_kor_mask8(a.v, b.v)}; }
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
Lanes::Mask operator!(const Lanes::Mask& mask) {
  return {_knot_mask8(mask.v)};
}
unsigned bits(const Lanes::Mask& mask) {
  return _cvtmask8_u32(mask.v);
}
Lanes select(const Lanes::Mask& mask, const Lanes& a, const Lanes& b) {
  return _mm256_mask_blend_pd(mask.v, b.v, a.v);
}

}  // namespace

const Kernels kAvx512Kernels{.earliest_contact = earliest_contact<Lanes>,
                             .contacts_of_pairs = contacts_of_pairs<Lanes>,
                             .earliest_step = earliest_step<Lanes>,
                             .bound_contacts = bound_contacts<Floats>,
                             .bound_contacts_of_two = bound_contacts_of_two<Floats>,
                             .bound_each_contact = bound_each_contact<Floats>,
                             .keep_between = keep_between<Floats>,
                             .bound_steps = bound_steps<Floats>,
                             .pick_near = pick_near<Floats>,
                             .find_differences = find_differences<Floats>,
                             .exclude = exclude<Floats>};

}  // namespace hardball

#endif
