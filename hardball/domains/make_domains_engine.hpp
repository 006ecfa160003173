// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "hardball/domains/division.hpp"
#include "hardball/domains/sphere_transfer.hpp"
#include "hardball/engine/engine_base.hpp"
#include "hardball/processes/processes.hpp"

namespace hardball {

/// Whether this library can share a system among threads and processes: HARDBALL_DOMAINS when it was
/// configured.
bool has_domains();

/// Makes a DomainsEngine for a world that all processes have whole. Precondition and error: see there; and
/// has_domains().
std::unique_ptr<EngineBase> make_domains_engine(World world, const PhaseSettings& phase,
                                                const Division& division, const Time& now,
                                                Processes& processes);
/// Makes one for a system of which each process brings some of the spheres. Precondition and error: see
/// DomainsEngine; and has_domains().
std::unique_ptr<EngineBase> make_domains_engine(World empty, SphereTransfers brought,
                                                const PhaseSettings& phase, const Division& division,
                                                const Time& now, Processes& processes);

}  // namespace hardball
