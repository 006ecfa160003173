// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/placement/placement.hpp"
#include "hardball/placement/region.hpp"
#include "hardball/world/progress.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Centers for spheres of these radii [L] in a region of a world without spheres, denser than random
/// placement reaches: smaller spheres are placed at random and grow while they move and collide, up to .97 of
/// the packing fraction at which spheres of these sizes jam. They keep clear of the walls of the world as
/// they are at time zero, and of spheres that are `placed` already.
///
/// The centers depend on the arguments alone. Error, with `where` as its place: the spheres are to be denser
/// than that, or lock before they have their sizes; the box is sheared and displaced at time zero. Cost: some
/// fifty collisions of each sphere, some hundreds near the greatest density.
HARDBALL_EXPORT std::vector<Vec3> place_by_growth(const World& empty, const Region& region,
                                                  std::span<const double> radii,
                                                  std::span<const PlacedSphere> placed, Random& random,
                                                  const std::string& where, const Progress& progress = {});

}  // namespace hardball
