// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace hardball::bench {

inline constexpr double kRadius = 1.5;   ///< Radius of the spheres [L].
inline constexpr double kBoxEdge = 200;  ///< Edge of the paper's box [L].
/// If the box grows with the number of spheres, they are as dense as this many in the paper's box.
inline constexpr std::size_t kSpheresAtFixedDensity = 10'000;
inline constexpr double kSpread = 10;  ///< Standard deviation of each component of the velocities [L/T].
/// The packing fraction above which hard spheres in equilibrium freeze [1]. Source: Hoover and Ree,
/// J. Chem. Phys. 49 (1968) 3609.
inline constexpr double kFreezing = 0.494;

/// More spheres start from a face-centered cubic lattice, and take longer to equilibrate.
inline constexpr std::size_t kMaxPlacedAtRandom = 50'000;
inline constexpr int kCollisionsToSettle = 10;  ///< Mean collisions per sphere before measuring.
/// Mean collisions per sphere before measuring, from a lattice, which below freezing has melted after nine.
inline constexpr int kCollisionsToMelt = 15;

/// A time step, by how far a sphere of mean speed moves in it.
struct StepSize {
  double radii = 0;  ///< [1]
  const char* name = "";

  double duration() const;  ///< [T]
};

/// The steps for which missed collisions are counted.
inline constexpr std::array<StepSize, 10> kSteps = {{{3, "3"},
                                                     {1, "1"},
                                                     {1. / 2, "1/2"},
                                                     {1. / 3, "1/3"},
                                                     {1. / 5, "1/5"},
                                                     {1. / 10, "1/10"},
                                                     {1. / 20, "1/20"},
                                                     {1. / 30, "1/30"},
                                                     {1. / 50, "1/50"},
                                                     {1. / 100, "1/100"}}};
/// The indices of those used by the time-stepped simulation.
inline constexpr std::array<std::size_t, 4> kStepsTaken = {1, 3, 5, 7};

/// What is measured, and for how long.
struct Plan {
  std::vector<std::size_t> spheres;                   ///< In the paper's box.
  std::vector<std::size_t> spheres_at_fixed_density;  ///< In boxes that grow with n.
  int repetitions = 3;
  double seconds = 0.8;  ///< Aimed at for one measurement of the cell grid.
  /// Aimed at for one measurement of all pairs or time steps, unless a single step takes longer.
  double slow_seconds = 0.8;
  std::size_t most_all_pairs = 0;  ///< The largest number of spheres for all pairs.
  std::size_t most_stepped = 0;    ///< The largest number of spheres for time steps.
  std::size_t trial_spheres = 0;   ///< For counting the collisions that the time-stepped simulation finds.
  double trial_span = 0;           ///< [T]
};

/// Minutes on a slow core.
Plan full_plan();
/// Seconds: fewer spheres, one repetition.
Plan quick_plan();

inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The speed of one method for one number of spheres; NaN where a number does not apply.
struct Row {
  std::string method;  ///< cells, paper, all_pairs or time_stepped
  std::size_t spheres = 0;
  double box_edge = kBoxEdge;  ///< [L]
  double step_radii = kNone;   ///< Step of time_stepped, see StepSize [1].
  double step = kNone;         ///< [T]
  double seconds = kNone;      ///< Per unit of simulated time, the median of the repetitions.
  double seconds_minimum = kNone;
  double seconds_maximum = kNone;
  int repetitions = 0;
  double span = 0;            ///< Simulated in one repetition [T].
  double collisions = kNone;  ///< Per unit of time, like the other kinds of events.
  double walls = kNone;
  double enters = kNone;
  double leaves = kNone;
  double missed_share = kNone;  ///< Share of all collisions that time_stepped misses [1].
  std::string note = {};

  double packing_fraction() const;  ///< Packing fraction of the spheres in the box [1].
  double events() const { return collisions + walls + enters + leaves; }  ///< Per unit of time.
  double seconds_per_event() const { return seconds / events(); }
  double seconds_per_collision() const { return seconds / collisions; }
};

/// The collisions missed by checks at intervals of one step.
struct StepRow {
  StepSize step;
  std::uint64_t contacts = 0;  ///< Collisions of the exact engine examined.
  std::uint64_t missed = 0;    ///< Contacts during which there is no check.
  double expected_share = 0;   ///< Missed, by kinetic theory [1].
  // The time-stepped simulation itself, where it was run:
  std::size_t spheres = 0;
  double span = kNone;      ///< [T]
  double exact = kNone;     ///< Collisions of the exact engine in this span.
  double resolved = kNone;  ///< Collisions that the time-stepped simulation resolved in it.

  double missed_share() const { return static_cast<double>(missed) / static_cast<double>(contacts); }
  double unresolved_share() const { return 1 - resolved / exact; }
  /// One standard error of unresolved_share(), if the two histories are uncorrelated [1].
  double unresolved_error() const { return std::sqrt(exact + resolved) / exact; }
};

/// The results of all measurements.
struct Results {
  std::vector<Row> rows;  ///< In the paper's box.
  std::vector<Row> rows_at_fixed_density;
  std::vector<StepRow> steps;
};

/// Measures everything, in one thread, and reports progress on stderr. Error (RunFailure): the cell grid and
/// the paper's algorithm disagree.
Results measure(const Plan& plan);

}  // namespace hardball::bench
