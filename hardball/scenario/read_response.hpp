// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "hardball/scenario/scenario.hpp"
#include "hardball/scenario/section.hpp"

namespace hardball {

/// The species that the tables [[species]] of a scenario describe. Error, with the location of the value: a
/// name is given twice or means walls, or a value is out of range.
std::vector<SpeciesDescription> read_species(const Section& root);

/// The species of this name. Error, with the location of the name: there is none.
SpeciesId species_named(const Value& name, std::span<const SpeciesDescription> species);

/// Reads the table [response]. Error, with the location of the value: a species is unknown, a key does not go
/// with others, or a value is out of range.
void read_response(const Section& root, Scenario& scenario);

/// Decides whether spheres settle, by the table [response] or by what else the scenario has, which has been
/// read before. Error, with the location of the value: they are to settle without gravity.
void read_settling(const Section& root, Scenario& scenario);

}  // namespace hardball
