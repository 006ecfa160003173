// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "apps/cli/options.hpp"
#include "apps/cli/summary.hpp"
#include "apps/report/report.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/simulation/simulation.hpp"

namespace hardball::cli {

/// The contents of a run's report at the current time of the simulation, except its measures. `options` are
/// those of the command line, `engine_options` what they resolved to.
report::Report run_report(const Options& options, const Scenario& scenario,
                          const EngineOptions& engine_options, const Simulation& simulation,
                          const Summary& summary);

}  // namespace hardball::cli
