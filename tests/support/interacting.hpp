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

/// A world with these interactions.
inline World interacting(World world, const Interactions& interactions) {
  world.set_interactions(interactions);
  return world;
}

}  // namespace hardball::support
