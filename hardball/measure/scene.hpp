// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "hardball/measure/neighbor_query.hpp"
#include "hardball/statistics/qualification.hpp"
#include "hardball/theory/fluid_theory.hpp"
#include "hardball/theory/gas_statistics.hpp"
#include "hardball/theory/species_list.hpp"
#include "hardball/theory/thermal_motion.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The mean of the base radii [L]. Cost: O(n).
double mean_radius(const World& world);

/// The world at one time, as measures see it: what several of them need is computed once, when first
/// requested. Several threads may use it at once.
class Scene {
 public:
  /// Refers to the world, which must not change while the scene is in use; a world is driven if a thermostat
  /// has acted on it; `settled` says how far it has come from its start. Precondition: no contact lies
  /// between the stored paths and `now`.
  Scene(const World& world, const Time& now, bool is_driven = false, Settled settled = {})
      : world_(world), now_(now), is_driven_(is_driven), settled_(std::move(settled)) {}
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  const World& world() const { return world_; }
  const Time& now() const { return now_; }
  const Settled& settled() const { return settled_; }

  // Each costs O(n) when first requested.
  const SpeciesList& species() const;
  const FluidTheory& fluid() const;
  const GasStatistics& statistics() const;
  const ThermalMotion& thermal_motion() const;
  /// All centers in the order of ids, folded into a periodic box [L].
  const std::vector<Vec3>& centers() const;
  const NeighborQuery& surroundings() const;
  /// Whether there can be the equilibrium of an isolated system: the energy is that at the start, `begin`,
  /// no axis is open, no face of the box heats or drags, and some spheres deflect each other.
  bool has_equilibrium(const ThermalMotion& begin) const;
  /// The center of a sphere, followed through periodic boundaries [L].
  Vec3 unfolded_center(Slot slot) const;

 private:
  const World& world_;
  Time now_;
  bool is_driven_;
  Settled settled_;
  mutable std::recursive_mutex mutex_;  // of what follows, some of which needs other parts of it
  // Computed so far.
  mutable std::optional<SpeciesList> species_;
  mutable std::optional<FluidTheory> fluid_;
  mutable std::optional<GasStatistics> statistics_;
  mutable std::optional<ThermalMotion> motion_;
  mutable std::optional<std::vector<Vec3>> centers_;
  mutable std::optional<NeighborQuery> surroundings_;
};

}  // namespace hardball
