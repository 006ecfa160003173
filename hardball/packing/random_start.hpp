// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "hardball/placement/region.hpp"
#include "hardball/world/progress.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Centers for spheres of these radii [L] in a region of a world without spheres, between its surfaces at
/// time zero; or for spheres that are smaller in proportion, if these do not fit at random: `radii` are
/// reduced accordingly. Error, with `where` as its place: as for place_randomly.
std::vector<Vec3> place_shrunken(const World& empty, const Region& region, std::vector<double>& radii,
                                 Random& random, const std::string& where, const Progress& progress);

/// Velocities of a thermal speed of one [L/T], shape (count, 3); without walls, their mean is zero.
std::vector<Vec3> thermal_velocities(std::size_t count, std::size_t dimensions, bool has_walls,
                                     Random& random);

}  // namespace hardball
