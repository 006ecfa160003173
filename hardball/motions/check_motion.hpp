// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// 2 pi, rounded up: of bounds.
inline constexpr double kTurnOfMotion = 0x1.921fb54442d19p+2;

/// Error: a component is not finite or beyond the operating range.
void check_motion_vector(const Vec3& vector, std::string_view name);
/// Error: the frequency is zero or out of the operating range [1/T].
void check_motion_frequency(double frequency);
/// The unit vector along a vector. Error: it has no length, or as for check_motion_vector.
Vec3 direction_of_motion(const Vec3& vector, std::string_view name);

/// Whether a vector is a unit vector, up to rounding.
bool is_direction_of_motion(const Vec3& vector);

}  // namespace hardball
