// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "apps/cli/options.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/tuning/moments.hpp"

namespace hardball::cli {

/// How many spheres the groups of a scenario have; zero if it starts from a file.
std::size_t sphere_count(const Scenario& scenario);

/// The start of a scenario, as far as it can be known in seconds.
struct Outlook {
  EngineOptions options;
  Simulation simulation;   ///< Of the scenario, or of a sample.
  Moments moments;         ///< Of all spheres.
  bool is_sample = false;  ///< Whether the spheres were not placed.
};

/// Sets up the simulation of a scenario; if it has more than a million spheres that are not listed one by one
/// or read from a file, only that of some ten thousand of them, in a periodic box of the same packing
/// fraction. Error, RunFailure: as for set_up.
Outlook look_ahead(const Options& options, const Scenario& scenario);

/// What a run would meet that its author may not expect, a sentence each: that nothing can ever touch, or
/// that spheres come to rest by inelastic collapse.
std::vector<std::string> warnings_of(const Scenario& scenario, const Moments& moments);

}  // namespace hardball::cli
