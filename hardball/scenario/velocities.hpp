// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "hardball/scenario/scenario.hpp"

namespace hardball {

/// Velocities for all spheres of the groups [L/T], in the order of ids.
///
/// Maxwell velocities are scaled so that each group has the prescribed mean speed or temperature, up to
/// rounding. With `without_drift`, if all groups have Maxwell velocities and there are two spheres or more,
/// the total momentum is removed first; a single group then has none, and several have only what their
/// scaling brings back.
std::vector<Vec3> draw_velocities(std::span<const SphereGroup> groups, bool without_drift, Random& random);

}  // namespace hardball
