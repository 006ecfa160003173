// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/geometry/contact_time.hpp"

#include <cfloat>

static_assert(FLT_EVAL_METHOD == 0, "Hardball needs arithmetic that rounds every operation to double");

namespace hardball {

double time_to_reach(const Vec3& separation, const Vec3& velocity, double reach) {
  return time_to_reach<double>(separation, velocity, reach);
}

Time contact_time_of_growing(const Growth& growth, const Path& a, const Path& b, const Vec3& shift,
                             double reach) {
  return contact_time(GrowingMotion<double>(growth), a, b, shift, reach);
}

}  // namespace hardball
