// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/cli/wall_summary.hpp"
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

/// What a summary is made of: a simulation at its current time.
struct FinalState {
  const World& world;  ///< Perhaps without spheres, or with earlier ones.
  std::size_t spheres = 0;
  Time now;
  Counters counters;
  std::size_t domains = 1;
  WindowCounters windows;
  std::optional<double> at_rest_since;  ///< When all spheres came to rest, which is how they stay [T].
  ContactSums sums;
  Totals totals;
  double step_energy = 0;  ///< [M L^2 T^-2]
  bool has_spins = false;
  Audit audit;
  std::vector<std::size_t> species_counts;  ///< As many as the scenario names.
  std::optional<Thermostat> thermostat;
  std::optional<GrowthSchedule> growth;
  EngineKind engine = EngineKind::automatic;
  double cell_edge = 0;  ///< [L]
  std::size_t memory_bytes = 0;
};

/// Cost: that of an audit. Precondition: the simulation outlives it.
FinalState final_state(const Scenario& scenario, const Simulation& simulation);

/// The summary of a run.
class Summary {
 public:
  /// Summarizes the run of a scenario. `overrides`: those of the scenario. `notes`: of its start, a sentence
  /// each.
  Summary(const Scenario& scenario, const std::vector<std::string>& overrides, const FinalState& state,
          const Seconds& seconds, const std::vector<std::string>& notes);

  /// One JSON object, with null for what does not apply to this run, and a line break.
  std::string json() const;
  /// A table for people.
  std::string table() const;

  /// In diameters [1].
  double max_overlap() const { return max_overlap_; }
  // NaN where it does not apply.
  double rotational_energy() const { return rotational_energy_; }  ///< [M L^2 T^-2]
  double packing_fraction() const { return packing_fraction_; }
  double compressibility() const { return compressibility_; }
  double wall_pressure() const { return wall_pressure_; }  ///< [M L^-1 T^-2]
  double cell_edge() const { return cell_edge_; }          ///< [L]

  /// How many worked on the system.
  std::size_t domains() const { return domains_; }

  const std::vector<WallSummary>& walls() const { return walls_; }

  const Seconds& seconds() const { return seconds_; }
  double bytes_per_sphere() const { return bytes_per_sphere_; }
  long peak_rss_bytes() const { return peak_rss_bytes_; }

 private:
  struct SpeciesCount {
    std::string name;
    std::size_t spheres = 0;
  };

  std::string scenario_name_;
  std::string scenario_text_;
  std::vector<std::string> overrides_;
  std::uint64_t seed_;
  std::size_t spheres_;
  bool is_flat_;
  double time_;
  std::optional<double> at_rest_since_;
  bool is_unsettled_;  // though the spheres of the scenario come to rest
  Counters counters_;
  std::size_t domains_;
  WindowCounters windows_;  // in the table alone: files do not depend on the number of threads
  std::uint64_t mergers_;
  std::uint64_t passes_;
  bool has_steps_;
  std::uint64_t steps_passed_;
  std::uint64_t steps_refused_;
  double step_energy_;
  std::vector<SpeciesCount> species_;
  std::uint64_t hash_;
  double initial_energy_;
  double final_energy_;
  Vec3 momentum_;
  double max_overlap_;
  // The following are NaN where they do not apply.
  double rotational_energy_;
  double packing_fraction_;
  double compressibility_;
  double wall_pressure_;
  std::vector<WallSummary> walls_;
  std::optional<Thermostat> thermostat_;
  std::optional<GrowthSchedule> growth_;
  double growth_work_ = 0;
  Shear shear_;
  double shear_work_ = 0;
  double shear_displacement_ = 0;
  std::string engine_;
  double cell_edge_;
  Seconds seconds_;
  std::vector<std::string> notes_;
  double bytes_per_sphere_;
  long peak_rss_bytes_;
};

}  // namespace hardball::cli
