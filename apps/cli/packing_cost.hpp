// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/packing.hpp"

namespace hardball::cli {

/// The seconds that a collision of this packing takes on this machine [T], to a factor of two: measured on at
/// most a few thousand of its spheres, which are packed for half a second. Error: they cannot be placed.
double measured_seconds_per_collision(const PackingPlan& plan);

}  // namespace hardball::cli
