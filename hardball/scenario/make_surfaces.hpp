// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "hardball/scenario/scenario.hpp"
#include "hardball/surfaces/surface.hpp"

namespace hardball {

/// The walls of a scenario, then its obstacles, in the order of the file.
std::vector<Surface> make_surfaces(const Scenario& scenario);

}  // namespace hardball
