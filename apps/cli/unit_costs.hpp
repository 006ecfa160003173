// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "hardball/tuning/cell_edge.hpp"

namespace hardball::cli {

/// The unit costs denoted by a text: the costs themselves, "measured" on this machine, or "standard".
/// Error: none of these.
UnitCosts read_unit_costs(const std::string& text);

/// In the format of the command line.
std::string to_option(const UnitCosts& costs);

}  // namespace hardball::cli
