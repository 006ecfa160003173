// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "apps/cli/options.hpp"
#include "apps/cli/summary.hpp"
#include "apps/report/report.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/statistics/measurement.hpp"

namespace hardball::cli {

/// The contents of a run's report at the current time of the simulation. `chosen` is what the command
/// line says; `is_complete`: whether the run has come to its end.
report::Report run_report(const ScenarioChoice& chosen, const Scenario& scenario,
                          const Simulation& simulation, const Summary& summary,
                          std::span<const Measurement> measurements, bool is_complete);

}  // namespace hardball::cli
