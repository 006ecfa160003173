// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "hardball/engine/engine_base.hpp"
#include "hardball/processes/processes.hpp"
#include "hardball/run/engine_options.hpp"
#include "hardball/theory/gas_statistics.hpp"
#include "hardball/world/progress.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The settings of the broad phase of an engine, with the length [L] that choose_length has chosen.
/// Precondition: `engine` is one that choose_engine has chosen, as for all that follow.
PhaseSettings phase_settings(EngineKind engine, const EngineOptions& options, double length);

/// Makes an engine for a world as it is at `now`, which all processes have whole. Error: the box is too small
/// for this many processes.
std::unique_ptr<EngineBase> make_engine(World world, EngineKind engine, const EngineOptions& options,
                                        double length, const Time& now, Processes& processes = one_process(),
                                        const Progress& progress = {});

/// Whether an engine would be made in another way for its world as it is: several domains may not share it.
bool must_be_replaced(const EngineBase& engine);

/// The engine for a world as it is at `moment`, with these statistics: the one that the options fix, if it
/// suits the world, or the one that kinetic theory predicts to be the fastest; never `automatic`. `current`
/// is the one in use; another must be cheaper by a tenth to replace it. The world may be a sample of that
/// which the statistics describe. Precondition: check_features accepts the options for the features of the
/// world.
EngineKind choose_engine(const World& world, const GasStatistics& statistics, const EngineOptions& options,
                         const Time& moment, EngineKind current = EngineKind::automatic);

/// The length [L] for such an engine: the cell edge that the options fix, or the best one; for neighbor
/// lists, the skin; for all pairs, any.
double choose_length(const World& world, const GasStatistics& statistics, EngineKind engine,
                     const EngineOptions& options, const Time& moment);

/// How a world is divided among threads.
Division choose_division(const World& world, const EngineOptions& options);

/// A proposed edge [L], for the paper's engine raised to the largest diameter if it is smaller.
double allowed_cell_edge(const World& world, EngineKind engine, double edge);

}  // namespace hardball
