// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// Which kind of sphere one is, where contacts depend on it: a number that programs and scenarios choose.
using SpeciesId = std::uint8_t;

/// The moments of inertia of a uniform sphere and of a uniform disc, over mass and squared radius [1].
inline constexpr double kUniformSphereMoment = 0.4;
inline constexpr double kUniformDiscMoment = 0.5;

/// A sphere as a caller describes it, at one moment.
struct Sphere {
  Vec3 position;       ///< Center [L].
  Vec3 velocity = {};  ///< [L/T]
  double radius = 1;   ///< [L]
  /// [M]; infinite for a kinematic sphere, which no collision deflects.
  double mass = 1;
  Vec3 spin = {};  ///< Angular velocity [1/T].
  SpeciesId species = 0;
  /// Moment of inertia over mass and squared radius [1]; of discs, kUniformDiscMoment is usual.
  double moment = kUniformSphereMoment;
};

}  // namespace hardball
