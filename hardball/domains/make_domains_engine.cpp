// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/make_domains_engine.hpp"

#include <utility>

#include "hardball/domains/domains_engine.hpp"

namespace hardball {

bool has_domains() {
  return true;
}

std::unique_ptr<EngineBase> make_domains_engine(World world, const PhaseSettings& phase,
                                                const Division& division, const Time& now,
                                                Processes& processes) {
  return std::make_unique<DomainsEngine>(std::move(world), phase, division, now, processes);
}

std::unique_ptr<EngineBase> make_domains_engine(World empty, SphereTransfers brought,
                                                const PhaseSettings& phase, const Division& division,
                                                const Time& now, Processes& processes) {
  return std::make_unique<DomainsEngine>(std::move(empty), std::move(brought), phase, division, now,
                                         processes);
}

}  // namespace hardball
