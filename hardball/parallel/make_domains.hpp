// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/engine/engine.hpp"
#include "hardball/execution/aftermath.hpp"
#include "hardball/memory/for_each.hpp"
#include "hardball/parallel/domain.hpp"
#include "hardball/parallel/layout.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Makes so many of the domains of a layout, from the one with number `first` on. `world` has the spheres as
/// they are at `now`, at least all that these domains own or hold; `aftermath` is theirs.
template <class DomainEngine, class Sums, BroadPhase Phase>
std::vector<std::unique_ptr<Domain<DomainEngine, Sums>>> make_domains(
    const Layout& layout, DomainNumber first, std::size_t count, const World& world, const Time& now,
    const Aftermath& aftermath, const PhaseSettings& settings, const ForEach& for_each) {
  std::vector<DomainNumber> owners;
  owners.reserve(world.size());
  for (Slot slot = 0; slot < world.size(); ++slot)
    owners.push_back(layout.partition().domain_at(world.position(slot, now)));
  const auto make_engine = [&](World part, const PhaseSettings& phase) {
    return DomainEngine(std::move(part), Phase(phase), now, phase.instructions);
  };
  std::vector<std::unique_ptr<Domain<DomainEngine, Sums>>> domains(count);
  for_each_or_throw(for_each, count, [&](std::size_t k) {
    domains[k] = std::make_unique<Domain<DomainEngine, Sums>>(world, owners, now, layout.partition(),
                                                              static_cast<DomainNumber>(first + k),
                                                              layout.halo(), settings, make_engine);
    domains[k]->take_over(aftermath);
  });
  return domains;
}

}  // namespace hardball
