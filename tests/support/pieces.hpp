// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/history.hpp"

namespace hardball::support {

/// Runs on in random pieces, as a copy now and then, or as what has been saved and loaded, with looks ahead
/// in between: to the history of an undivided run.
inline History run_in_pieces(Simulation& simulation, const RunLimits& limits, Random& random) {
  RunLimits left = limits;
  History history;
  bool is_whole = false;
  while (!is_whole) {
    RunLimits piece = left;
    if (random.uniform() < 0.5) piece.contacts = std::min<std::uint64_t>(left.contacts, random.bits() % 9);
    if (random.uniform() < 0.3) piece.steps = 1 + random.bits() % 20;
    is_whole = piece.contacts == left.contacts && piece.steps == left.steps;
    const std::uint64_t before = simulation.counters().contacts();
    history = run_on(simulation, piece);
    if (!history.failure.empty()) return history;
    left.contacts -= simulation.counters().contacts() - before;
    if (random.uniform() < 0.2) simulation = Simulation(simulation);
    if (random.uniform() < 0.2) simulation = Simulation::load(simulation.save());
    if (random.uniform() < 0.2) static_cast<void>(simulation.next_contact(left.until.high));
    if (random.uniform() < 0.2) static_cast<void>(simulation.contacts_within(left.until.high / 20, 8));
  }
  simulation.validate();
  return history;
}

}  // namespace hardball::support
