// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/errors/export.hpp"
#include "hardball/processes/processes.hpp"
#include "hardball/scenario/make_world.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/world/progress.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Compares the scenario that each process has read, and the files that it names. Error, in all processes:
/// one of them has another scenario or file than the first, or cannot read a file.
HARDBALL_EXPORT void require_same_scenario(const Scenario& scenario, Processes& processes);

/// Makes the start of a scenario for make_simulation: the whole world for one process, and every P-th sphere
/// for each of P. Error: as for make_part.
HARDBALL_EXPORT World make_share(const Scenario& scenario, const Processes& processes,
                                 const OnProgress& on_progress = {}, const OnNote& on_note = {});

}  // namespace hardball
