// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hardball/scenario.hpp"
#include "hardball/simulation.hpp"
#include "hardball/world.hpp"

namespace hardball::cli {

/// How long a run took, in wall-clock time.
struct Seconds {
  double setup = 0;
  double run = 0;

  static void persist(auto& archive, auto& self) { archive(self.setup, self.run); }
};

/// What spheres did at one wall or group of its triangles, and it to them, over a run; NaN where it does not
/// apply.
struct WallSummary {
  std::string name;   ///< As wall_name says, or group_names.
  std::string shape;  ///< "face", "plane", "cylinder", "sphere", "obstacle" or "mesh".
  WallTally tally;
  double area = 0;      ///< [L^2]
  double force = 0;     ///< Mean along the normal [M L T^-2].
  double pressure = 0;  ///< [M L^-1 T^-2]
  /// Mean about the point that the scenario gives [M L^2 T^-2]; none of a face.
  std::optional<Vec3> torque = {};
  std::vector<WallSummary> groups = {};  ///< The groups of a mesh that has several.
};

/// What a prescribed motion has done.
struct MotionSummary {
  std::string name;
  std::string kind;
  std::size_t spheres = 0;  ///< How many it drives.
  std::size_t walls = 0;
  double work = 0;                        ///< On spheres [M L^2 T^-2].
  std::optional<double> stopped_at = {};  ///< When the pressure stopped it [T].
};

/// What a simulation has come to.
struct FinalState {
  std::size_t spheres = 0;
  Box box;
  Time now;
  std::optional<double> at_rest_since = {};  ///< When all spheres came to rest, which is how they stay [T].
  std::optional<double> errors_reached_at = {};  ///< When errors were as small as wanted [T].
  Counters counters;
  std::size_t domains = 1;  ///< How many worked on the system.
  WindowCounters windows;
  ContactSums sums;
  Totals totals;
  bool has_steps = false;  ///< Whether spheres have potentials of steps.
  double step_energy = 0;  ///< [M L^2 T^-2]
  double max_overlap = 0;  ///< In diameters [1].
  // The following are NaN where they do not apply.
  double rotational_energy = 0;  ///< [M L^2 T^-2]
  double packing_fraction = 0;   ///< [1]
  double compressibility = 0;    ///< [1]
  double wall_pressure = 0;      ///< [M L^-1 T^-2]
  double cell_edge = 0;          ///< [L]
  std::vector<WallSummary> walls = {};
  std::vector<MotionSummary> motions = {};
  std::vector<std::size_t> species_counts;  ///< As many as the scenario names.
  std::optional<Thermostat> thermostat;
  std::optional<GrowthSchedule> growth;
  EngineKind engine = EngineKind::automatic;
  double bytes_per_sphere = 0;
  std::uint64_t peak_rss_bytes = 0;
};

/// Cost: that of an audit.
FinalState final_state(const Scenario& scenario, const Simulation& simulation);

/// The summary of a run.
struct Summary {
  const Scenario& scenario;
  const std::vector<std::string>& overrides;  ///< How the command line changed it.
  FinalState state;
  Seconds seconds;
  const std::vector<std::string>& notes;  ///< Notes of its start, a sentence each.

  /// One JSON object, with null for what does not apply to this run, and a line break.
  std::string json() const;
  /// A table for people.
  std::string table() const;

 private:
  double end_time() const { return state.at_rest_since ? *scenario.run.until : state.now.value(); }
  double collisions_per_second() const { return static_cast<double>(state.counters.collision) / seconds.run; }
};

}  // namespace hardball::cli
