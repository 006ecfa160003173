// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "apps/cli/options.hpp"
#include "apps/cli/summary.hpp"
#include "apps/report/report.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/simulation/simulation.hpp"

namespace hardball::cli {

/// What the report of a run says that has come as far as the simulation now is, its measures apart. `options`
/// are those of the command line, `engine_options` what was made of them.
report::Report run_report(const Options& options, const Scenario& scenario,
                          const EngineOptions& engine_options, const Simulation& simulation,
                          const Summary& summary);

}  // namespace hardball::cli
