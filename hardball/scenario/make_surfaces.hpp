// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "hardball/scenario/scenario.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/box.hpp"

namespace hardball {

/// The walls of a scenario, then its obstacles, in the order of the file. Error, with its location: one that
/// cannot be in this box, see World.
std::vector<Surface> make_surfaces(const Scenario& scenario, const Box& box);

/// The room along each axis to which surfaces at time zero confine spheres [L]; infinite where they do not.
Extent room_between(std::span<const Surface> surfaces);

}  // namespace hardball
