// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/parallel/division.hpp"
#include "hardball/simulation/any_distributed_engine.hpp"
#include "hardball/simulation/any_engine.hpp"

namespace hardball {

/// Makes an engine of one kind. Each is compiled in a file of its own, as that takes long.
using MakeEngine = std::unique_ptr<AnyEngine>(World world, const EngineOptions& options,
                                              const PhaseSettings& settings, const Time& now,
                                              const Progress& progress);
MakeEngine make_cells;               ///< For spheres none of which is much larger than a cell.
MakeEngine make_large_sphere_cells;  ///< For others.
MakeEngine make_sheared_cells;       ///< For sheared boxes.
MakeEngine make_neighbors;
MakeEngine make_all_pairs;
MakeEngine make_paper;

/// Makes the part of this process in a distributed engine of one kind.
using MakeDistributed = std::unique_ptr<AnyDistributedEngine>(DistributedStart start,
                                                              const PhaseSettings& settings);
MakeDistributed make_distributed_cells;
MakeDistributed make_distributed_large_sphere_cells;
MakeDistributed make_distributed_neighbors;

/// How a world is divided among threads.
Division choose_division(const World& world, const EngineOptions& options);

}  // namespace hardball
