// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/cli/options.hpp"
#include "hardball/scenario.hpp"
#include "hardball/simulation.hpp"
#include "hardball/theory.hpp"

namespace hardball::cli {

/// The start of a scenario, as far as it can be known in seconds.
struct Outlook {
  EngineOptions options;
  Simulation simulation;                ///< A simulation of the scenario, or of a sample of its spheres.
  GasStatistics statistics;             ///< Statistics of all spheres.
  bool is_sample = false;               ///< Whether the spheres were not placed.
  std::vector<std::string> notes = {};  ///< Warnings of make_world, where all spheres were placed.
};

/// Sets up the simulation of a scenario; if it has more than a million spheres that are not listed one by one
/// or read from a file, only that of some ten thousand of them, in a periodic box of the same packing
/// fraction. Error, RunFailure: as for set_up.
Outlook look_ahead(const EngineChoice& choice, const Scenario& scenario, bool is_quiet);

}  // namespace hardball::cli
