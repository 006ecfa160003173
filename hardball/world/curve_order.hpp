// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "hardball/world/world.hpp"

namespace hardball {

/// The slots of a world in the order in which a space-filling curve visits the centers at `moment`, so that
/// spheres close in space are close in memory. For World::reorder. Cost: O(n log n). Source:
/// Morton, A computer oriented geodetic data base, IBM (1966).
std::vector<Slot> order_along_curve(const World& world, const Time& moment);

/// Puts the spheres of a world that has no journal into this order, if there are enough of them for that to
/// pay.
void put_in_order(World& world, const Time& moment);

}  // namespace hardball
