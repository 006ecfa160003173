// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace hardball {

/// The species of a sphere, on which contacts may depend: a number that programs and scenarios choose.
using SpeciesId = std::uint8_t;

/// The moments of inertia of a uniform sphere and of a uniform disc, over mass and squared radius [1].
inline constexpr double kSphereInertiaFactor = 0.4;
inline constexpr double kDiscInertiaFactor = 0.5;

}  // namespace hardball
