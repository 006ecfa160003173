// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "hardball/scenario/scenario.hpp"
#include "hardball/scenario/section.hpp"

/// The readers of the tables of a scenario; scenario.cpp reads the smaller ones.
namespace hardball {

// --- read_walls.cpp ---

/// What the table [box.faces] of [box] describes. Error, with the location of the value: a key contradicts
/// another or is out of range.
std::vector<FaceDescription> read_faces(const Section& box, std::size_t dimensions);

/// What the tables [[walls]] and [[obstacles]] of a scenario describe, one surface for each position. Error,
/// with the location of the value: a key is missing, contradicts another or is out of range.
std::vector<SurfaceDescription> read_surfaces(const Section& root, std::size_t dimensions);

// --- read_spheres.cpp ---

/// The group that a table [[spheres]] describes; files are named relative to `folder`. `scenario` has its box
/// and its species. Error, with the place of the value: a key is missing, contradicts another or is out of
/// range.
SphereGroup read_spheres(const Section& section, const std::filesystem::path& folder,
                         const Scenario& scenario);

// --- read_response.cpp ---

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

// --- read_potentials.cpp ---

/// Reads the tables [[potentials]] and [[bonds]]. Error, with the location of the value: a species is
/// unknown, or has two potentials; a potential is refused (see StepPotential); ids are none, or a file of
/// bonds cannot be read; something in the scenario does not go with potentials of steps.
void read_potentials(const Section& root, Scenario& scenario);

}  // namespace hardball
