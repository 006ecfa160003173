// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "hardball/describe/names.hpp"
#include "hardball/domains/division.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/kernels/instruction_set.hpp"
#include "hardball/processes/processes.hpp"
#include "hardball/tuning/unit_costs.hpp"
#include "hardball/world/features.hpp"

namespace hardball {

/// How collisions are found. The choice changes the speed and never the motion.
enum class EngineKind {
  automatic,  ///< The fastest for the world.
  cells,      ///< The cell grid.
  neighbors,  ///< A neighbor list for each sphere; in a box too small for that, the cell grid.
  all_pairs,  ///< Every sphere against every other: slow, and obviously correct.
  paper,      ///< The algorithm of the paper to the letter.
};
template <>
inline constexpr std::array<std::string_view, 5> kNames<EngineKind>{"auto", "cells", "neighbors", "all-pairs",
                                                                    "paper"};

struct EngineOptions {
  EngineKind engine = EngineKind::automatic;
  /// Edge of the cells [L], for engines that have them; if absent, chosen by `tuning` and adapted.
  /// Error: not positive, or so small that a sphere would lie in hundreds of cells; for the paper's engine,
  /// less than the largest diameter.
  std::optional<double> cell_edge = {};
  /// Unit costs from which the cell edge is chosen; measure_unit_costs returns those of this machine. Error:
  /// not are_meaningful.
  UnitCosts unit_costs = {};
  /// How many threads work on one system; zero for as many as pay, of which there is one where they cannot
  /// share the work. Error: more than 1,024; several where spheres merge, the response is a function, there
  /// are potentials of steps, or the box is sheared.
  std::size_t threads = 1;
  /// A division into domains that replaces `threads`, for tests and measurements.
  std::optional<Division> division = {};
  /// Instructions that compute contact times; if absent, the widest available. Error: not available.
  std::optional<InstructionSet> instructions = {};
};

/// Error: options that are valid for no world; see EngineOptions.
HARDBALL_EXPORT void check(const EngineOptions& options);
/// Error: more than 1,024 threads are wanted; the options or several processes exclude each other, or some of
/// these features of the world.
void check_features(const EngineOptions& options, const Processes& processes, Features features);

}  // namespace hardball
