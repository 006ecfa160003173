// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/scenario/scenario.hpp"
#include "hardball/scenario/section.hpp"

namespace hardball {

/// Reads the tables [[potentials]] and [[bonds]]. Error, with the location of the value: a species is
/// unknown, or has two potentials; a potential is refused (see StepPotential); ids are none, or a file of
/// bonds cannot be read; something in the scenario does not go with potentials of steps.
void read_potentials(const Section& root, Scenario& scenario);

}  // namespace hardball
