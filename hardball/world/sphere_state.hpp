// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/events/event.hpp"
#include "hardball/geometry/path.hpp"
#include "hardball/interaction/species.hpp"

namespace hardball {

/// The whole state of one sphere in a world.
struct SphereState {
  Path path;                  // first, as it fills a cache line
  double radius = 0;          ///< The base radius [L].
  double mass = 0;            ///< [M]
  double inertia_factor = 0;  ///< [1]
  Vec3 spin;                  ///< [1/T]
  Image folded;               ///< By how many boxes its center has been folded back.
  SphereId id = 0;
  SpeciesId species = 0;

  friend bool operator==(const SphereState&, const SphereState&) = default;
};

}  // namespace hardball
