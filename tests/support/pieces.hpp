// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>

#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/history.hpp"

namespace hardball::support {

/// Runs on in random pieces, as a copy now and then, or as what has been saved and loaded, with looks ahead
/// in between: to the history of an undivided run. Some pieces end when an actor acts; `next_action` returns
/// that time.
inline History run_in_pieces(Simulation& simulation, const RunLimits& limits, Random& random,
                             const std::function<double(const Simulation&)>& next_action = {}) {
  RunLimits left = limits;
  History history;
  bool is_whole = false;
  while (!is_whole) {
    RunLimits piece = left;
    if (random.uniform() < 0.5) piece.contacts = std::min<std::uint64_t>(left.contacts, random.bits() % 9);
    if (random.uniform() < 0.3) piece.steps = 1 + random.bits() % 20;
    const double action = next_action ? next_action(simulation) : left.until.high;
    const bool acts = action >= simulation.time() && action < left.until.high;
    const double now = simulation.time();
    const double kind = random.uniform();
    if (kind < 0.2 && acts) piece.until = Time(action);
    if (kind > 0.8) piece.until = Time(now + random.uniform() * random.uniform() * (left.until.high - now));
    is_whole = piece.until == left.until && piece.contacts == left.contacts && piece.steps == left.steps;
    const std::uint64_t before = simulation.counters().contacts();
    history = run_on(simulation, piece);
    if (!history.failure.empty()) return history;
    left.contacts -= simulation.counters().contacts() - before;
    if (random.uniform() < 0.2) simulation = Simulation(simulation);
    if (random.uniform() < 0.2) simulation = Simulation::load(simulation.save());
    if (random.uniform() < 0.2) static_cast<void>(simulation.next_contact(left.until.high));
    if (random.uniform() < 0.2) static_cast<void>(simulation.contacts_within(left.until.high / 20, 8));
    if (random.uniform() < 0.3 && acts && action >= simulation.time() && !simulation.next_contact(action))
      static_cast<void>(simulation.positions_at(action));
  }
  simulation.validate();
  return history;
}

}  // namespace hardball::support
