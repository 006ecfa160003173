// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "hardball/describe/field.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/interaction/contact.hpp"
#include "hardball/measure/face_forces.hpp"
#include "hardball/memory/for_each.hpp"
#include "hardball/memory/value_pointer.hpp"
#include "hardball/statistics/measurement.hpp"
#include "hardball/world/velocity_change.hpp"

namespace hardball {

class ArchiveReader;
class ArchiveWriter;
class World;

/// The names of all measures, in the order of their results.
HARDBALL_EXPORT std::span<const std::string_view> measure_names();

/// What to measure in a run, and when.
struct MeasureSettings {
  /// Some of measure_names(); "all" means all but those of transport: "diffusion", "viscosity",
  /// "bulk_viscosity", "thermal_conductivity" and "mutual_diffusion".
  std::vector<std::string> names = {"all"};
  /// The time between samples [T]; if absent, each measure has its own, see SamplingSchedule.
  std::optional<double> every = {};
  /// When measuring starts [T].
  double from = 0;
  /// Whether the forces on each triangle of a mesh are measured, with "wall_forces".
  bool face_forces = false;
  /// By the index of a surface: about which point torque on it is measured, as a vector from the point of the
  /// surface [L]; of others, about their points.
  std::vector<std::pair<std::uint32_t, Vec3>> torque_about = {};
  /// Whether spheres are placed for the start, on a lattice or at random, rather than taken from an
  /// equilibrium. Of a fluid, means then begin when the spheres have left their places.
  bool is_start_placed = false;
  /// Whether the energy of the start is drawn at random: that of random places in potentials of steps or
  /// under gravity, or of random spins. Errors then say how far runs with other random numbers are.
  bool is_energy_random = false;

  /// The times; names are chosen from a list.
  static constexpr auto fields() {
    return std::tuple{option("every", &MeasureSettings::every, NumberRange::positive, "T",
                             "the time between samples; if not given, each measure has its own", "0.5"),
                      option("from", &MeasureSettings::from, NumberRange::not_negative, "T",
                             "when measuring starts", "2.0", "0.0"),
                      option("face_forces", &MeasureSettings::face_forces,
                             "whether to write the forces on each triangle of the walls that are meshes, as "
                             "`measures/mesh_0_face_forces.vtp`, if `wall_forces` are measured",
                             "true", "false")};
  }
  static void persist(auto& archive, auto& self) {
    archive(self.names, self.every, self.from, self.is_start_placed, self.is_energy_random);
    if (archive.version() >= kSinceVersion) archive(self.face_forces, self.torque_about);
  }

 private:
  static constexpr std::uint32_t kSinceVersion = 15;  // of archives that have face_forces and torque_about
};

/// The measures that are switched on for a run.
///
/// They receive every contact, and the world at times of their choice; Simulation provides both. They see the
/// world as const and compute where spheres are without storing it, so that no contact changes. The spheres
/// must stay those of the start, and only contacts, thermostats and Simulation::change_velocities with these
/// measures may change velocities: they do not notice other changes, and would be wrong. Results
/// depend only on the scenario: they are the same bits for every engine.
class HARDBALL_EXPORT Measures {
 public:
  /// Error: no measure has this name; `every` is not positive, or `from` not finite.
  explicit Measures(const MeasureSettings& settings = {});
  Measures(const Measures& other);
  Measures(Measures&& other) noexcept;
  Measures& operator=(const Measures& other);
  Measures& operator=(Measures&& other) noexcept;
  ~Measures();

  /// Whether any measure is switched on.
  bool is_any_wanted() const { return is_any_wanted_; }

  /// Whether they have started to measure.
  bool has_begun() const { return has_begun_; }

  /// Error: the spheres of `world` are not those with which the measures started; torque is to be measured on
  /// a surface that there is not. Cost: O(spheres followed).
  void check_spheres(const World& world) const;

  void record(const Contact& contact);
  /// Records a change of velocity by the thermostat or by an edit. From then on the system counts as driven,
  /// and the theory of isolated systems is left out.
  void record(const VelocityChange& change);
  /// When the next sample is due; kNever if none is.
  Time next_sample() const;
  /// Samples the world; the first call starts the measures. Several measures may sample at once, as
  /// `for_each` decides. Precondition: `now` is not before next_sample() and no contact lies between the
  /// stored paths and it.
  void sample(const World& world, const Time& now, const ForEach& for_each = one_by_one);
  /// Takes a sample for each measure that needs samples and has none yet: for the end of a run that was too
  /// short for them. Precondition: as for sample().
  void sample_the_rest(const World& world, const Time& now);
  /// The result of each measure that is switched on, up to `now`, in the order of measure_names(); none
  /// before the start. Precondition: as for sample().
  std::vector<Measurement> results(const World& world, const Time& now) const;
  /// The forces on the triangles of each mesh, up to `now`; none unless MeasureSettings::face_forces is set
  /// and "wall_forces" has started. Precondition: as for sample().
  std::vector<FaceForces> face_forces(const World& world, const Time& now) const;

  /// The whole state as bytes, from which `load` makes measures that continue to the same results.
  std::string save() const;
  /// Measures from what `save` returned, of this version of the library or an earlier one; `where` names the
  /// bytes in errors. Error: they are damaged, or not from `save`, or of a later version.
  static Measures load(std::string_view bytes, const std::string& where = "the saved measures");

 private:
  friend class Persistence;
  static void persist(ArchiveWriter& archive, const Measures& self);
  static void persist(ArchiveReader& archive, Measures& self);
  static void persist_parts(auto& archive, auto& self);
  bool restored() const;

  struct Entries;  // a measure of each kind, and what decides whether they have settled

  MeasureSettings settings_;
  bool is_any_wanted_ = false;
  bool has_begun_ = false;
  bool is_driven_ = false;   // a thermostat has acted
  std::size_t spheres_ = 0;  // at the start
  SphereId last_id_ = 0;     // at the start; of spheres added later all ids are higher
  Time begin_;
  std::uint64_t contacts_ = 0;
  ValuePointer<Entries> entries_;
};

}  // namespace hardball
