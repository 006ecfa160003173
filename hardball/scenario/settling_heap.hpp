// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/scenario/scenario.hpp"

namespace hardball {

/// Whether contacts by these rules lose energy.
bool loses_energy(const BounceRules& rules);

/// Whether some contacts lose energy.
HARDBALL_EXPORT bool loses_energy(const Scenario& scenario);

/// Whether walls exchange energy with spheres, or a thermostat does.
HARDBALL_EXPORT bool are_kept_moving(const Scenario& scenario);

/// Whether spheres that fall come to lie on something.
HARDBALL_EXPORT bool has_floor(const Scenario& scenario);

/// Whether its spheres form a heap that comes to rest: they fall on something and lose energy, and nothing
/// keeps them moving.
inline bool comes_to_rest(const Scenario& scenario) {
  return has_floor(scenario) && loses_energy(scenario) && !are_kept_moving(scenario) && !scenario.growth;
}

/// Whether a wall curves around spheres.
inline bool is_round(const SurfaceDescription& wall) {
  return !wall.surface.normal() && !wall.is_obstacle();
}

}  // namespace hardball
