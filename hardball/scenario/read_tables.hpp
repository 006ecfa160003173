// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "hardball/describe/field.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/scenario/section.hpp"

/// The readers of the tables of a scenario; scenario.cpp reads the smaller ones.
namespace hardball {

/// The value of a field of what a section describes; zero if it is not required and not given. Directions may
/// have any length. Error, with the location of the value: it is missing or out of range.
template <class Get>
typename Field<Get>::Value read_field(const Section& section, const Field<Get>& field,
                                      std::size_t dimensions = kAxes);

// --- read_walls.cpp ---

/// The unit vector along that of a value. Error, with the location of the value: its length is zero.
Vec3 direction_of(const Value& value, std::string_view key, std::size_t dimensions);

/// What the table [box.faces] of [box] describes. Error, with the location of the value: a key contradicts
/// another or is out of range.
std::vector<FaceDescription> read_faces(const Section& box, std::size_t dimensions);

/// What the tables [[walls]] and [[obstacles]] of a scenario describe, one surface for each position; files
/// are named relative to `folder`. Error, with the location of the value: a key is missing, contradicts
/// another or is out of range; a mesh cannot be read.
std::vector<SurfaceDescription> read_surfaces(const Section& root, const std::filesystem::path& folder,
                                              const Scenario& scenario);

// --- read_motions.cpp ---

/// What the tables [[motions]] of a scenario describe; files are named relative to `folder`. Error, with the
/// location of the value or the line of the file: a name is given twice, a key is missing, contradicts
/// another or is out of range, or a file is no table of keyframes.
std::vector<MotionDescription> read_motions(const Section& root, const std::filesystem::path& folder,
                                            std::size_t dimensions);

/// The index of the motion of this name. Error, with the location of the name: there is none.
std::size_t motion_named(const Value& name, const std::vector<MotionDescription>& motions);

/// Error, with its location: a motion drives nothing, a motion of spheres under gravity has no tolerance, or
/// kinematic spheres have no motion there.
void check_motions(const Scenario& scenario);

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

template <class Get>
typename Field<Get>::Value read_field(const Section& section, const Field<Get>& field,
                                      std::size_t dimensions) {
  using Read = typename Field<Get>::Value;
  const std::optional<Value> given = field.is_required ? section.need(field.name) : section.find(field.name);
  if (!given) return {};
  if constexpr (std::is_same_v<Read, Vec3>)
    return direction_of(*given, field.name, dimensions);
  else if constexpr (std::is_integral_v<Read>)
    return given->integer();
  else
    return given->number();
}

}  // namespace hardball
