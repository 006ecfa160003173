// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "hardball/interaction/species.hpp"

namespace hardball {

/// Which bodies a query of a simulation looks for; all by default.
struct BodyMask {
  /// Spheres of these species; of all species if it is empty.
  std::vector<SpeciesId> species = {};
  /// Spheres whose user data (Simulation::user_data), seen as a set of groups, a bit for each, has a bit in
  /// common with this one; all spheres if all bits are set, also those without user data.
  std::uint64_t groups = std::numeric_limits<std::uint64_t>::max();
  bool walls = true;  ///< Whether walls are looked for.
};

}  // namespace hardball
