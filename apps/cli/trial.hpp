// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "apps/cli/outlook.hpp"
#include "hardball/scenario.hpp"

namespace hardball::cli {

/// The beginning of a run, carried out to see what the whole costs.
struct Trial {
  double time = 0;             ///< The time reached [T].
  double seconds = 0;          ///< Wall time spent.
  std::uint64_t contacts = 0;  ///< Contacts so far.
  bool is_whole = false;       ///< Whether nothing is left: it came to the end, or to rest.
  std::string failure = {};    ///< Why the run failed; empty if it did not.
  double late_seconds = 0;     ///< For each unit of time, in the second half of the trial [1/T].
  double late_contacts = 0;    ///< For each unit of time, in the second half of the trial [1/T].
};

/// Carries out the run of a scenario, with its measures and without files, for half a second.
Trial try_out(const Scenario& scenario, const Outlook& outlook);

/// Estimates what the whole run costs on one core from a trial [s]: as much per unit of time as at the end of
/// the trial; less for a gas that cools or flies apart; for a heap, until it comes to rest. Half a second is
/// a whole run of small systems.
double expected_seconds(const Scenario& scenario, const Outlook& outlook, const Trial& trial);

}  // namespace hardball::cli
