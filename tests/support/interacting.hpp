// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <utility>

#include "hardball/world/world.hpp"

namespace hardball::support {

/// Spheres of these species pass through each other; all others are smooth and elastic.
inline ResponseTable passing(std::initializer_list<std::pair<SpeciesId, SpeciesId>> pairs) {
  ResponseTable table;
  for (const auto& [a, b] : pairs) table.set(a, b, Passing());
  return table;
}

/// All spheres have this potential of steps.
inline Interactions stepping(const StepRules& rules) {
  StepTable table;
  table.set_for_all(StepPotential(rules));
  Interactions interactions;
  interactions.set_steps(table);
  return interactions;
}

/// A world with these interactions.
inline World interacting(World world, const Interactions& interactions) {
  world.set_interactions(interactions);
  return world;
}

}  // namespace hardball::support
