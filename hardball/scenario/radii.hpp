// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "hardball/numbers/random.hpp"
#include "hardball/scenario/scenario.hpp"

namespace hardball {

/// Radii of `count` spheres [L]; the same on every platform. Error, with the distribution's or the file's
/// place: a file cannot be read, or does not hold exactly `count` radii; hardly any radii lie between min and
/// max.
std::vector<double> draw_radii(const RadiusDistribution& distribution, std::size_t count, Random& random);

}  // namespace hardball
