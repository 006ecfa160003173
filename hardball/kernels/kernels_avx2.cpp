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
  friend Mask operator&&(const Mask& a, const Mask& b) { return {_mm256_and_pd(a.v, b.v)}; }
  friend Mask operator||(const Mask& a, const Mask& b) { return {_mm256_or_pd(a.v, b.v)}; }
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
Lanes::Mask operator!(const Lanes::Mask& mask) {
  return {_mm256_xor_pd(mask.v, _mm256_castsi256_pd(_mm256_set1_epi64x(-1)))};
}
unsigned bits(const Lanes::Mask& mask) {
  return static_cast<unsigned>(_mm256_movemask_pd(mask.v));
}
Lanes select(const Lanes::Mask& mask, const Lanes& a, const Lanes& b) {
  return _mm256_blendv_pd(b.v, a.v, mask.v);
}

}  // namespace

const Kernels kAvx2Kernels{.earliest_contact = earliest_contact<Lanes>,
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
