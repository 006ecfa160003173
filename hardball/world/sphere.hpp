// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/geometry/vec3.hpp"
#include "hardball/interaction/species.hpp"

namespace hardball {

/// A sphere as a caller describes it, at one moment.
struct Sphere {
  Vec3 position;       ///< Center [L].
  Vec3 velocity = {};  ///< [L/T]
  double radius = 1;   ///< [L]
  /// [M]; infinite for a kinematic sphere, which no collision deflects.
  double mass = 1;
  Vec3 spin = {};  ///< Angular velocity [1/T].
  SpeciesId species = 0;
  /// Moment of inertia over mass and squared radius [1]; of discs, kDiscInertiaFactor is usual.
  double inertia_factor = kSphereInertiaFactor;
};

}  // namespace hardball
