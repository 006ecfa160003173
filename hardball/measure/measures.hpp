// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "hardball/interaction/contact.hpp"
#include "hardball/measure/bond_order.hpp"
#include "hardball/measure/collision_rate.hpp"
#include "hardball/measure/coordination.hpp"
#include "hardball/measure/density_profiles.hpp"
#include "hardball/measure/flow_profiles.hpp"
#include "hardball/measure/impact_speeds.hpp"
#include "hardball/measure/mean_square_displacement.hpp"
#include "hardball/measure/measure_settings.hpp"
#include "hardball/measure/measurement.hpp"
#include "hardball/measure/nearest_neighbor.hpp"
#include "hardball/measure/pressure.hpp"
#include "hardball/measure/radial_distribution.hpp"
#include "hardball/measure/sampling_schedule.hpp"
#include "hardball/measure/scene.hpp"
#include "hardball/measure/structure_factor.hpp"
#include "hardball/measure/temperature.hpp"
#include "hardball/measure/velocity_autocorrelation.hpp"
#include "hardball/measure/velocity_distribution.hpp"
#include "hardball/measure/wall_forces.hpp"
#include "hardball/world/velocity_change.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The measures that are switched on for a run.
///
/// They receive every contact, and the world at times of their choice; Simulation provides both. They see the
/// world as const and compute where spheres are without storing it, so that no contact changes. The spheres
/// must stay those of the start, and only contacts, thermostats and Simulation::change_velocities with these
/// measures may change velocities: they do not notice other changes, and would be wrong. Results
/// depend only on the scenario: they are the same bits for every engine.
class Measures {
 public:
  /// Error: no measure has this name; `every` is not positive, or `from` not finite.
  explicit Measures(const MeasureSettings& settings = {});

  /// Whether any measure is switched on.
  bool is_any_wanted() const { return is_any_wanted_; }

  /// Whether they have started to measure.
  bool has_begun() const { return has_begun_; }

  /// Error: the spheres of `world` are not those with which the measures started. Cost: O(spheres followed).
  void check_spheres(const World& world) const;

  void note(const Contact& contact);
  /// Of the thermostat or of an edit: from then on the system counts as driven, and the theory of isolated
  /// ones is left out.
  void note(const VelocityChange& change);
  /// When the next sample is due; kNever if none is.
  Time next_sample() const;
  /// Samples the world; the first call starts the measures. Precondition: `now` is not before next_sample()
  /// and no contact lies between the stored paths and it.
  void sample(const World& world, const Time& now);
  /// Takes a sample for each measure that needs samples and has none yet: for the end of a run that was too
  /// short for them. Precondition: as for sample().
  void sample_the_rest(const World& world, const Time& now);
  /// The result of each measure that is switched on, up to `now`, in the order of measure_names(); none
  /// before the start. Precondition: as for sample().
  std::vector<Measurement> results(const World& world, const Time& now) const;

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    archive(self.settings_, self.is_any_wanted_, self.has_begun_, self.is_driven_, self.spheres_,
            self.last_id_, self.begin_, self.contacts_);
    std::apply([&](auto&... entries) { (persist_entry(archive, entries), ...); }, self.entries_);
  }
  // A measure that the archive is too old to have is not wanted.
  static void persist_entry(auto& archive, auto& entry) {
    using Measure = typename std::remove_cvref_t<decltype(entry)>::Type;
    if constexpr (requires { Measure::kSinceVersion; }) {
      if (archive.version() < Measure::kSinceVersion) return;
    }
    archive(entry);
  }
  bool restored() const;

  template <class Measure>
  struct Entry {
    using Type = Measure;
    bool is_wanted = false;
    std::optional<Measure> measure;  // once it has started
    bool has_sample = false;
    SamplingSchedule schedule;
    static void persist(auto& archive, auto& self) {
      archive(self.is_wanted, self.measure, self.has_sample, self.schedule);
    }
    bool restored() const { return measure || schedule.next() == kNever; }
  };
  using Entries = std::tuple<Entry<Pressure>, Entry<WallForces>, Entry<Temperature>, Entry<CollisionRate>,
                             Entry<ImpactSpeeds>, Entry<VelocityDistribution>, Entry<MeanSquareDisplacement>,
                             Entry<VelocityAutocorrelation>, Entry<RadialDistribution>,
                             Entry<StructureFactor>, Entry<DensityProfiles>, Entry<FlowProfiles>,
                             Entry<Coordination>, Entry<NearestNeighbor>, Entry<BondOrder>>;
  friend std::span<const std::string_view> measure_names();

  // Calls visit(entry) for every entry.
  template <class Visit>
  void for_each(Visit&& visit) {
    std::apply([&](auto&... entries) { (visit(entries), ...); }, entries_);
  }
  template <class Visit>
  void for_each(Visit&& visit) const {
    std::apply([&](const auto&... entries) { (visit(entries), ...); }, entries_);
  }
  template <class Measure>
  void begin(Entry<Measure>& entry, const Scene& scene, const Pace& pace) const;

  template <class Measure>
  void take_sample(Entry<Measure>& entry, const Scene& scene) const;

  MeasureSettings settings_;
  bool is_any_wanted_ = false;
  bool has_begun_ = false;
  bool is_driven_ = false;   // a thermostat has acted
  std::size_t spheres_ = 0;  // at the start
  SphereId last_id_ = 0;     // at the start; of spheres added later all ids are higher
  Time begin_;
  std::uint64_t contacts_ = 0;
  Entries entries_;
};

}  // namespace hardball
