// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/motions/check_motion.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"

namespace hardball {

void check_motion_vector(const Vec3& vector, std::string_view name) {
  for (std::size_t axis = 0; axis < kAxes; ++axis)
    check_finite(vector[axis], std::string(name) + " along " + kAxisNames[axis], "motion");
}

void check_motion_frequency(double frequency) {
  check_finite(frequency, "frequency", "motion");
  check_positive(std::fabs(frequency), "the magnitude of frequency", "motion");
}

Vec3 direction_of_motion(const Vec3& vector, std::string_view name) {
  check_motion_vector(vector, name);
  const double largest = std::max({std::fabs(vector.x), std::fabs(vector.y), std::fabs(vector.z)});
  check_positive(largest, "the length of " + std::string(name), "motion");
  // Components along an axis of space stay exact, and no square overflows.
  const Vec3 scaled{vector.x / largest, vector.y / largest, vector.z / largest};
  const double norm = length(scaled);
  return {scaled.x / norm, scaled.y / norm, scaled.z / norm};
}

bool is_direction_of_motion(const Vec3& vector) {
  constexpr double kRounding = 1e-12;
  return std::fabs(dot(vector, vector) - 1) <= kRounding;
}

}  // namespace hardball
