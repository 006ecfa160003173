// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/interaction/contact.hpp"
#include "hardball/interaction/interactions.hpp"
#include "hardball/numbers/exact_sum.hpp"
#include "hardball/world/totals.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Sums over the contacts with a wall, or with a group of the triangles of a mesh.
struct WallTally {
  std::uint64_t contacts = 0;
  Vec3 impulse;  ///< Momentum given to the wall [M L/T].
  /// Angular momentum given to it about the point of the surface, which moves with it; zero of a face, and
  /// NaN if a release saved the sums that did not have it [M L^2/T].
  Vec3 angular_impulse;
  double normal_impulse = 0;  ///< The part along its normal, counted positive [M L/T].
  double work = 0;            ///< Done by the wall on spheres through its motion [M L^2 T^-2].
  double heat = 0;            ///< Energy given to spheres otherwise; negative if lost [M L^2 T^-2].
};

/// Sums over the contacts of a run from which pressures and the certificate follow: the same to the bit in
/// whichever order contacts are added, and however they are divided among several tallies.
class HARDBALL_EXPORT Tally {
 public:
  /// Starts counting at `now` with the energy of the world. Cost: O(n).
  void begin(const World& world, const Time& now);
  /// Starts counting at `now` with the sums over the spheres of the world, which may be without them.
  void begin(const World& world, const Totals& totals, const Time& now);
  /// Sets how the spheres interact from now on; `begin` uses the interactions of the world. Where all
  /// collisions are elastic, those of spheres of finite mass change no energy: any change in the velocities
  /// is rounding noise, and not added.
  void set_interactions(const Interactions& interactions) { is_elastic_ = interactions.are_elastic(); }
  /// Records that an edit of the world changed the kinetic energy, without that of spins, at `now`.
  void note_edit(double energy_change, const Time& now);
  void record(const Contact& contact);
  /// An empty tally that began when this one did, for contacts that are added elsewhere.
  Tally part() const;
  /// Adds another tally that began with the same world at the same moment. Cost:
  /// O(walls).
  void add(const Tally& other);

  /// The latest time of a contact or edit, or the start.
  const Time& last_change() const { return last_; }
  std::uint64_t collisions() const { return collisions_; }
  /// Collisions after which the two spheres were one.
  std::uint64_t mergers() const { return mergers_; }
  /// Collisions in which the two spheres passed through each other.
  std::uint64_t passes() const { return passes_; }
  /// Collisions in which the two spheres passed a step of their potential, or bounced off it.
  std::uint64_t steps_passed() const { return steps_passed_; }
  std::uint64_t steps_refused() const { return steps_refused_; }
  std::uint64_t wall_contacts() const { return wall_contacts_; }
  /// Energy at the start, see World::energy [M L^2 T^-2].
  double initial_energy() const { return initial_energy_; }
  /// The deepest overlap of two spheres, or of a sphere and a wall, at their contact, as a fraction of the
  /// sum of the radii, or of the radius [1]; caused by rounding alone.
  double max_overlap() const { return max_overlap_; }
  /// Spheres that pass through each other or merge count among collisions, and in none of these sums.
  /// Sum over collisions of impulse times separation of centers [M L^2/T].
  double virial() const { return virial_.value(); }
  /// The energy that spheres have gained by growing: the sum over contacts of the impulse times the rate of
  /// the sum of the radii [M L^2 T^-2].
  double growth_work() const { return growth_work_.value(); }
  /// The kinetic energy, without that of spins, which the shear of the box has given to the spheres relative
  /// to the flow, if it is now `kinetic_energy` [M L^2 T^-2]: what contacts and edits do not account for.
  double shear_work(double kinetic_energy) const;
  /// Sums over collisions, but those at steps, of the impact speed [L/T] and of its square [L^2 T^-2].
  double impact_speed_sum() const { return impact_speed_sum_.value(); }
  double impact_speed_square_sum() const { return impact_speed_square_sum_.value(); }
  /// Momentum transferred to a face of the box [M L/T].
  double wall_impulse(Face face) const { return walls_[face].normal_impulse.value(); }
  /// The sums for a wall: a face of the box, or a surface from kFaces on.
  WallTally wall(std::size_t number) const;
  /// The sums for a group of a wall, which has one unless it is a mesh: those of all together are the sums
  /// for the wall, to the bit, if they are added without rounding.
  WallTally wall(std::size_t number, std::size_t group) const;
  std::size_t wall_count() const { return first_groups_.size() - 1; }
  /// How many groups a wall has.
  std::size_t group_count(std::size_t number) const {
    return first_groups_[number + 1] - first_groups_[number];
  }
  /// Whether it is of a world with these walls; false only if its state is damaged.
  bool matches(const World& world) const;
  /// The work that a kinematic sphere has done on others through its motion [M L^2 T^-2].
  double kinematic_work(SphereId sphere) const;
  /// The work that several kinematic spheres have done on others [M L^2 T^-2].
  double kinematic_work(std::span<const SphereId> spheres) const;
  /// The time counted up to `now` [T].
  double elapsed(const Time& now) const { return duration(begin_, now); }

  /// Kinetic energy, without that of spins, integrated over time, up to `now` [M L^2/T]. Precondition: there
  /// is no gravity, nor shear.
  double energy_integral(const Time& now) const;
  /// P V / N k T over the time counted [1], from the virial and the mean kinetic energy in the rest frame of
  /// the boundaries. One if nothing collided; NaN if no time has passed, nothing moves, or there is gravity
  /// or shear. Source: Alder and Wainwright, J. Chem. Phys. 33 (1960) 1439.
  double compressibility(const Time& now) const;
  /// Mean pressure on the walls over the time counted [M L^-1 T^-2]; NaN without walls, or if no time has
  /// passed.
  double wall_pressure(const Box& box, const Time& now) const;

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    archive(self.begin_, self.last_, self.begin_energy_, self.initial_energy_, self.delayed_gains_,
            self.gains_, self.collisions_, self.mergers_, self.passes_, self.wall_contacts_,
            self.max_overlap_, self.virial_, self.impact_speed_sum_, self.impact_speed_square_sum_,
            self.keeps_energy_, self.walls_, self.growth_work_, self.steps_passed_, self.steps_refused_);
    if (archive.version() >= kSinceVersion) archive(self.kinematic_work_, self.first_groups_);
  }
  bool restored();

  // Of archives that have kinematic_work_, groups of walls and angular impulses.
  static constexpr std::uint32_t kSinceVersion = 15;

  // The sums of WallTally.
  struct WallSums {
    std::uint64_t contacts = 0;
    std::array<ExactSum, kAxes> impulse;
    std::array<ExactSum, kAxes> angular_impulse;
    ExactSum normal_impulse;
    ExactSum work;
    ExactSum heat;
    static void persist(auto& archive, auto& self) {
      archive(self.contacts, self.impulse, self.normal_impulse, self.work, self.heat);
      if (archive.version() >= kSinceVersion) archive(self.angular_impulse);
    }
    void add(const WallSums& other);
    WallTally tally() const;
  };

  // Where groups begin if every wall has one.
  static std::vector<std::size_t> one_group_each(std::size_t walls);

  // Two spheres have met that did not bounce.
  void note_outcome(const Contact& contact);
  void note_wall_contact(const Contact& contact);
  // One of two spheres is kinematic.
  void note_kinematic(const Contact& contact);
  void note_gain(double energy, const Time& now);

  Time begin_;
  Time last_;
  double begin_energy_ = 0;  // kinetic, without spins
  double initial_energy_ = 0;
  // The gains of kinetic energy, and of each the product with the time since the start: the integral of the
  // energy is that of begin_energy_ and, for each gain, of the gain over the time that is left.
  ExactSum gains_;
  ExactSum delayed_gains_;
  std::uint64_t collisions_ = 0;
  std::uint64_t mergers_ = 0;
  std::uint64_t passes_ = 0;
  std::uint64_t steps_passed_ = 0;
  std::uint64_t steps_refused_ = 0;
  std::uint64_t wall_contacts_ = 0;
  double max_overlap_ = 0;
  ExactSum virial_;
  ExactSum growth_work_;
  ExactSum impact_speed_sum_;
  ExactSum impact_speed_square_sum_;
  bool keeps_energy_ = true;  // between contacts: without gravity and shear
  bool is_elastic_ = false;   // of the world, see set_interactions
  // Of each group of each wall, and where those of a wall begin, and the last of all end.
  std::vector<WallSums> walls_ = std::vector<WallSums>(kFaces);
  std::vector<std::size_t> first_groups_ = one_group_each(kFaces);
  std::unordered_map<SphereId, ExactSum> kinematic_work_;  // of those that have done some
};

}  // namespace hardball
