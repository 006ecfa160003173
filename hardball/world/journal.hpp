// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "hardball/events/event.hpp"
#include "hardball/geometry/path.hpp"
#include "hardball/geometry/time.hpp"
#include "hardball/world/sphere.hpp"

namespace hardball {

/// All that a world knows of one sphere.
struct SphereState {
  SphereId id = 0;
  Path path;
  double radius = 0;          ///< [L]
  double mass = 0;            ///< [M]
  double inertia_factor = 0;  ///< [1]
  Image folded;               ///< By how many boxes its center has been folded back.
  Vec3 spin;                  ///< [1/T]
  SpeciesId species = 0;
};

/// A change of a world that can be undone.
struct WorldChange {
  enum class Kind : std::uint8_t {
    sphere,   ///< A sphere's path, and perhaps its spin and size.
    birth,    ///< A sphere was added.
    death,    ///< A sphere was removed.
    passage,  ///< Two spheres began to pass through each other.
  };

  Kind kind = Kind::sphere;
  Time time;           ///< Of the change [T].
  Slot slot = 0;       ///< Where the sphere is stored, or was.
  SphereState before;  ///< The sphere; of a birth, only its id.
  Event passage;       ///< The last passage before.
};

/// The changes of a world, in their order.
using Journal = std::vector<WorldChange>;

}  // namespace hardball
