// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "apps/cli/outlook.hpp"
#include "hardball/scenario.hpp"

namespace hardball::cli {

/// What a run is expected to take.
struct Forecast {
  double seconds = 0;        ///< On one core, within a factor of two or so.
  std::string failure = {};  ///< Why a trial of the run failed; empty if it did not.
};

/// The edge of the cells, or the skin of lists [L]; zero if the engine has neither.
double length_of(const Outlook& outlook);

/// The memory of all spheres in bytes, estimated from the sample where there is one.
double memory_bytes(const Outlook& outlook);

/// The cost of a gas like the one at the start, by kinetic theory. Cost: O(1).
Forecast forecast_by_theory(const Scenario& scenario, const Outlook& outlook);

/// The cost by a trial of half a second, which also knows gases that cool and heaps; by theory where the
/// spheres were not placed. Error (RunFailure): interrupted by a signal.
Forecast forecast_by_trial(const Scenario& scenario, const Outlook& outlook);

}  // namespace hardball::cli
