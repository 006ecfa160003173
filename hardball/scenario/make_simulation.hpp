// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/errors/export.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/simulation/simulation.hpp"

namespace hardball {

/// The simulation of a scenario from its start, which make_world has made, with its thermostat and growth. In
/// several processes, each brings some of the spheres; see Simulation::from_parts. Error: see Simulation; its
/// place is in the scenario, but that of options stays.
HARDBALL_EXPORT Simulation make_simulation(const Scenario& scenario, World start,
                                           const EngineOptions& options = {},
                                           const OnProgress& on_progress = {},
                                           Processes& processes = one_process());

}  // namespace hardball
