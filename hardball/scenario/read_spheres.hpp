// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>

#include "hardball/scenario/scenario.hpp"
#include "hardball/scenario/section.hpp"

namespace hardball {

/// The group that a table [[spheres]] describes; files are named relative to `folder`, and
/// `species` are those of the scenario. Error, with the place
/// of the value: a key is missing, contradicts another or is out of range.
SphereGroup read_spheres(const Section& section, const std::filesystem::path& folder,
                         std::span<const SpeciesDescription> species, std::size_t dimensions);

}  // namespace hardball
