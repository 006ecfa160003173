// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "hardball/scenario.hpp"

namespace hardball::cli {

/// What becomes of spheres that touch, or come to a step of a potential, in words.
struct ResponseText {
  std::string who;   ///< "all contacts", "drop and mist", "mist at walls", "potential of all spheres".
  std::string what;  ///< "bounce, restitution 0.9", "merge", "energy -1 within 1.5".
};

/// The responses of a scenario: first that of all, then those of pairs, potentials and bonds.
std::vector<ResponseText> response_texts(const Scenario& scenario);

/// How many spheres of each species of a scenario there are. Cost: O(n).
std::vector<std::size_t> species_counts(const Scenario& scenario, const World& world);

/// The species of a scenario and their counts in words: "drop 120, mist 700"; empty if the scenario names
/// none.
std::string species_text(const Scenario& scenario, const std::vector<std::size_t>& counts);

}  // namespace hardball::cli
