// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "hardball/processes/bytes.hpp"
#include "hardball/processes/processes.hpp"
#include "hardball/world/journal.hpp"

namespace hardball {

/// A sphere on its way from one process to another.
struct Traveler {
  SphereState state;
  std::uint32_t idle_contacts = 0;  ///< See CollapseGuard.
};

/// Sends spheres to other processes, and returns those that arrive here, in the order of ranks. For each one
/// route(traveler, send_to) calls send_to(rank) for every process that it is to reach.
template <class Route>
std::vector<Traveler> sent(const std::vector<Traveler>& travelers, Processes& processes, Route&& route) {
  std::vector<std::string> outgoing(processes.size());
  for (const Traveler& traveler : travelers) {
    route(traveler, [&](std::size_t rank) { append_value(traveler, outgoing[rank]); });
  }
  std::vector<Traveler> arrived;
  for (std::string& part : processes.exchange_with_all(std::move(outgoing))) {
    append_bytes(part, arrived);
    std::string().swap(part);
  }
  return arrived;
}

}  // namespace hardball
