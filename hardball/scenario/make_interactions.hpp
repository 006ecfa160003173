// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/interaction/interactions.hpp"
#include "hardball/scenario/scenario.hpp"

namespace hardball {

/// The responses and the potentials that a scenario describes. In the step table the potentials of its bonds
/// follow those of species.
Interactions make_interactions(const Scenario& scenario);

/// Ties the spheres of a world with these interactions together. Error, with the location of the table: no
/// sphere has an id, or two are tied twice.
void add_bonds(const Scenario& scenario, World& world);

}  // namespace hardball
