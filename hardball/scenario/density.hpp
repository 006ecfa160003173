// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "hardball/scenario/scenario.hpp"

namespace hardball {

/// The groups of a scenario with the radii of those whose radii are distributed. `random` is the sequence of
/// the scenario's seed at its beginning. Error: see draw_radii.
std::vector<SphereGroup> groups_with_radii(const Scenario& scenario, Random& random);

/// The volume of the spheres of groups whose radii are known [L^3], of discs the area [L^2].
double sphere_volume(std::span<const SphereGroup> groups);

/// How many spheres of the radius of a group fill this fraction of a box whose axes all have sizes, at least
/// one. Error, with `where` as its place: more than there can be; an axis without a size.
std::size_t count_for(double packing_fraction, const SphereGroup& group,
                      const std::array<Scenario::Axis, kAxes>& box, const std::string& where);

}  // namespace hardball
