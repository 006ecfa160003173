// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "hardball/tuning/cell_edge.hpp"

namespace hardball::cli {

/// The unit costs that a text means: the costs themselves, "measured" on this machine, or "standard".
/// Error: none of these.
UnitCosts read_unit_costs(const std::string& text);

/// As the command line takes them.
std::string to_option(const UnitCosts& costs);

}  // namespace hardball::cli
