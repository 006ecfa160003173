// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "hardball/scenario/scenario.hpp"
#include "hardball/theory/gas_statistics.hpp"

namespace hardball::cli {

/// What a run would meet that its author may not expect, a sentence each: that nothing can ever touch, or
/// that spheres come to rest by inelastic collapse.
std::vector<std::string> warnings_of(const Scenario& scenario, const GasStatistics& statistics);

}  // namespace hardball::cli
