// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/trajectory/sphere_types.hpp"

namespace hardball::gsd {

/// The names of all types in a GSD file: A, B and so on for species; where types are finer, A.1, A.2, B.1.
std::vector<std::string> type_names(const SphereTypes& types);

/// The species of each type, from such names as types that are finer than species have; nothing if one is
/// another name.
std::optional<std::vector<SpeciesId>> species_of_type_names(const std::vector<std::string>& names);

}  // namespace hardball::gsd
