// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "hardball/scenario/scenario.hpp"
#include "hardball/scenario/section.hpp"

namespace hardball {

/// The group that a table [[spheres]] describes; files are named relative to `folder`. `scenario` has its box
/// and its species. Error, with the place of the value: a key is missing, contradicts another or is out of
/// range.
SphereGroup read_spheres(const Section& section, const std::filesystem::path& folder,
                         const Scenario& scenario);

}  // namespace hardball
