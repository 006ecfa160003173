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

inline constexpr double kRadius = 1.5;   ///< Of the spheres [L].
inline constexpr double kBoxEdge = 200;  ///< Of the paper's box [L].
/// Where the box grows with the number of spheres, they are as dense as so many in the paper's box.
inline constexpr std::size_t kSpheresAtFixedDensity = 10'000;
inline constexpr double kSpread = 10;  ///< Standard deviation of each component of the velocities [L/T].
/// From this packing fraction on, hard spheres in equilibrium are not all fluid [1]. Source: Hoover and Ree,
/// J. Chem. Phys. 49 (1968) 3609.
inline constexpr double kFreezing = 0.494;

/// More spheres start from a face-centred cubic lattice, and need longer to forget it.
inline constexpr std::size_t kMostPlacedAtRandom = 50'000;
inline constexpr int kCollisionsToSettle = 10;  ///< Collisions of each sphere before measuring, in the mean.
/// The same from a lattice, which below freezing has melted by the ninth.
inline constexpr int kCollisionsToMelt = 15;

/// A step of time, by how far a sphere of mean speed goes in it.
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
/// Those of them, by index, that the time-stepped simulation takes.
inline constexpr std::array<std::size_t, 4> kStepsTaken = {1, 3, 5, 7};

/// What is measured, and for how long.
struct Plan {
  std::vector<std::size_t> spheres;                   ///< In the paper's box.
  std::vector<std::size_t> spheres_at_fixed_density;  ///< In boxes that grow with their number.
  int repetitions = 3;
  double seconds = 0.8;       ///< Aimed at for one measurement of the cell grid.
  double slow_seconds = 0.8;  ///< The same for all pairs and time steps, unless a single step takes longer.
  std::size_t most_all_pairs = 0;  ///< The largest number of spheres for all pairs.
  std::size_t most_stepped = 0;    ///< The same for time steps.
  std::size_t trial_spheres = 0;   ///< For counting what the time-stepped simulation finds.
  double trial_span = 0;           ///< [T]
};

/// Minutes on a slow core.
Plan full_plan();
/// Seconds: fewer spheres, one repetition.
Plan quick_plan();

inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// How fast one method is for one number of spheres; NaN where a number has no meaning.
struct Row {
  std::string method;  ///< cells, paper, all_pairs or time_stepped
  std::size_t spheres = 0;
  double box_edge = kBoxEdge;  ///< [L]
  double step_radii = kNone;   ///< Of time_stepped: see StepSize [1].
  double step = kNone;         ///< [T]
  double seconds = kNone;      ///< Per unit of simulated time, the median of the repetitions.
  double seconds_minimum = kNone;
  double seconds_maximum = kNone;
  int repetitions = 0;
  double span = 0;            ///< Simulated in one repetition [T].
  double collisions = kNone;  ///< Per unit of time, as the other kinds of events.
  double walls = kNone;
  double enters = kNone;
  double leaves = kNone;
  double missed_share = kNone;  ///< Of time_stepped: of all collisions [1].
  std::string note = {};

  double packing_fraction() const;                                        ///< Of the spheres in the box [1].
  double events() const { return collisions + walls + enters + leaves; }  ///< Per unit of time.
  double seconds_per_event() const { return seconds / events(); }
  double seconds_per_collision() const { return seconds / collisions; }
};

/// What checks at intervals of one step miss.
struct StepRow {
  StepSize step;
  std::uint64_t contacts = 0;  ///< Collisions of the exact engine that were looked at.
  std::uint64_t missed = 0;    ///< Those of them during which there is no check.
  double expected_share = 0;   ///< Missed, by kinetic theory [1].
  // The time-stepped simulation itself, where it was run:
  std::size_t spheres = 0;
  double span = kNone;      ///< [T]
  double exact = kNone;     ///< Collisions of the exact engine in this span.
  double resolved = kNone;  ///< Collisions that the time-stepped simulation carried out in it.

  double missed_share() const { return static_cast<double>(missed) / static_cast<double>(contacts); }
  double unresolved_share() const { return 1 - resolved / exact; }
  /// One standard error of unresolved_share(), if the two histories have forgotten each other [1].
  double unresolved_error() const { return std::sqrt(exact + resolved) / exact; }
};

/// The results of all measurements.
struct Results {
  std::vector<Row> rows;  ///< In the paper's box.
  std::vector<Row> rows_at_fixed_density;
  std::vector<StepRow> steps;
};

/// Measures everything, in one thread, and says on stderr how far it is. Error (RunFailure): the cell grid
/// and the paper's algorithm disagree.
Results measure(const Plan& plan);

}  // namespace hardball::bench
