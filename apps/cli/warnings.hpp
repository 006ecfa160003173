// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "hardball/scenario.hpp"
#include "hardball/theory.hpp"

namespace hardball::cli {

/// Warnings of what the author of a run may not expect, a sentence each: no spheres can ever touch, or
/// spheres come to rest by inelastic collapse.
std::vector<std::string> warnings_of(const Scenario& scenario, const GasStatistics& statistics);

}  // namespace hardball::cli
