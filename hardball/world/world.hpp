// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "hardball/errors/compilation.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/events/event.hpp"
#include "hardball/world/journal.hpp"
#include "hardball/world/pair_levels.hpp"
#include "hardball/world/setting.hpp"
#include "hardball/world/sphere.hpp"
#include "hardball/world/spheres.hpp"

namespace hardball {

/// A setting and the spheres in it: the state of the motion, and nothing else.
class HARDBALL_EXPORT World : CompilationCheck, public Setting, public Spheres {
 public:
  explicit World(const Box& box = Box::open()) : Setting(box) {}
  /// `gravity` is the acceleration of all spheres [L/T^2]; `surfaces` are walls and obstacles. Error: see
  /// Setting.
  World(const Box& box, const Vec3& gravity, std::vector<Surface> surfaces = {});

  /// Reserves memory for `count` spheres.
  void reserve(std::size_t count) { Spheres::reserve(count); }

  /// Adds a sphere in its state at `moment`, and returns its id: ids count up from zero.
  /// Positions outside a periodic box are folded into it. Overlaps are not checked here (see audit.hpp).
  /// Error: spheres grow; a number that is NaN, infinite or out of range; a radius, mass or inertia factor
  /// that is not positive; a center closer to a wall than the radius, or more than 2^30 boxes away; a box too
  /// small to hold the sphere; in two dimensions, a position or velocity out of the plane, or a spin within
  /// it.
  SphereId add(const Sphere& sphere, const Time& moment = Time(0));
  /// Error: `add` would refuse this sphere.
  void check(const Sphere& sphere) const;
  /// Error: `change_velocity` would refuse this velocity.
  void check_velocity(SphereId id, const Vec3& velocity) const;

  /// What the setting and the spheres have. Cost: O(1).
  Features features() const;
  /// A world with the same setting and no spheres.
  World without_spheres() const;
  /// Stores a sphere with the id and the path that it has in another world with the same box, and returns its
  /// slot, the last. Precondition: no sphere has this id; there is no journal. Cost: O(log n), and as of
  /// IdOrder::insert.
  Slot insert(const SphereState& state);
  /// Stores `count` spheres, of which state_of(k) returns the k-th, as `insert` does. Leaves some room for
  /// others. Cost: O(n log n), or O(ids ever given).
  template <class MakeState>
  void insert_all(std::size_t count, MakeState&& state_of) {
    constexpr std::size_t kRoom = 16;
    HARDBALL_CHECK(!has_journal_);
    reserve(size() + count + count / kRoom);
    for (std::size_t k = 0; k < count; ++k) append(state_of(k));
    order_ids();
    note_traits();
  }

  /// Removes a sphere; the one in the last slot takes its place. `moment` is for the journal. Cost: O(log n)
  /// amortized. Error: no sphere has this id.
  void remove(SphereId id, const Time& moment = Time(0)) { remove_at(slot_of(id), moment); }
  /// Removes the sphere in a slot, as `remove` does.
  void remove_at(Slot slot, const Time& moment);
  /// Undoes the last addition, and releases its id. Precondition: nothing else has changed since.
  void undo_add();
  /// Stores the sphere of slot order[k] in slot k; ids stay. `order` holds every slot once. Precondition:
  /// there is no journal. Cost: O(ids ever given).
  void reorder(std::span<const Slot> order);

  /// Starts to record all changes, so that they can be undone; discards those recorded before.
  void begin_journal();
  /// Discards the changes and stops recording.
  void end_journal();
  bool has_journal() const { return has_journal_; }
  const Journal& journal() const { return journal_; }
  /// Undoes the last change of the journal, to the last bit. Cost: as of the change.
  void undo();

  /// Gives a sphere a new velocity [L/T] from `moment` on; returns what rewrite_path does.
  /// Error: a number, or moment, that is NaN, infinite or out of range; a velocity out of the plane in two
  /// dimensions.
  Image change_velocity(Slot slot, const Time& moment, const Vec3& velocity);
  /// Rewrites a path at `moment`, see SphereEdit: the center where the old path puts it then, folded into the
  /// box, and the new velocity. Returns by how many boxes the center was folded back.
  Image rewrite_path(Slot slot, const Time& moment, const Vec3& velocity);

  /// Gives a sphere a new path at `moment`, as from a center [L], perhaps outside a periodic box, and with a
  /// velocity [L/T]; returns by how many boxes the center was folded back from where the old path led. Error:
  /// a number that is NaN, infinite or out of range; in two dimensions, what leaves the plane.
  Image put(Slot slot, const Time& moment, const Vec3& position, const Vec3& velocity);
  /// Lets a surface go on as another one of the same shape. Structures that were made for the spheres must be
  /// rebuilt. Error: a feature of the world excludes walls that move. Precondition: there is no journal.
  void set_surface(std::uint32_t number, const Surface& surface);

  /// Error, and nothing changes: the interactions exclude each other, or a feature of the world.
  void set_interactions(const Interactions& interactions);
  /// Begins an epoch of growth, in which all radii are the base radii times a scale (geometry/growth.hpp).
  /// Structures that were made for the spheres must be rebuilt. Error: a number that is not finite, or a
  /// scale that is not positive throughout; spheres that do not fit the box or a surface at its largest
  /// scale; a feature of the world excludes growth.
  void set_growth(const Growth& growth);
  /// Ends growth: the radii at `moment` are the base radii from now on, and all paths begin anew. Structures
  /// that were made for the spheres must be rebuilt. Precondition: there is no journal.
  void end_growth(const Time& moment);
  /// How much larger spheres may be expected to become by merging [1]: if some have grown, others may, too,
  /// and structures that are made for the largest leave room.
  double room_to_grow() const {
    constexpr double kRoom = 1.25;
    return has_grown_ ? kRoom : 1;
  }

  /// The radius at `moment` [L]. Precondition: the moment is in the present epoch.
  double radius(Slot slot, const Time& moment) const { return base_radius(slot) * motion().scale_at(moment); }
  /// How far from a sphere's center its region must reach [L], so that two spheres have no event before their
  /// regions meet: the largest radius of the present epoch, or more where steps of a potential act farther.
  double bounding_radius(Slot slot) const { return base_radius(slot) * bounding_scale(); }
  /// The largest radius that any sphere has in the present epoch [L]; zero in an empty world. Cost: O(n).
  double largest_radius() const { return base_radii().largest() * motion().largest_scale(); }
  /// The greatest bounding radius of all spheres [L]; zero in an empty world. Cost: O(n).
  double largest_bounding_radius() const { return base_radii().largest() * bounding_scale(); }
  /// Whether a sphere has had a spin, a species or an inertia factor of its own, or an infinite mass, or some
  /// pass through each other: in one flag, as every contact asks.
  bool has_traits() const { return has_traits_; }

  /// Where the path leads at `moment`, perhaps out of a periodic box [L]. Precondition: `moment` is finite.
  Vec3 unfolded_position(Slot slot, const Time& moment) const {
    return motion().position_at(path(slot), moment);
  }
  /// The velocity at `moment` along the path [L/T]; in a sheared box, that of the image which began it.
  /// Precondition: `moment` is finite.
  Vec3 unfolded_velocity(Slot slot, const Time& moment) const {
    return motion().velocity_at(path(slot), moment);
  }
  /// The center at `moment` [L], folded into a periodic box. Error: `moment` is NaN or infinite.
  Vec3 position(Slot slot, const Time& moment) const;
  /// The velocity at `moment` of the image that is in the box [L/T]. Precondition: `moment` is finite.
  Vec3 velocity(Slot slot, const Time& moment) const {
    if (box().is_sheared()) [[unlikely]]
      return velocity_in_box(slot, moment);
    return unfolded_velocity(slot, moment);
  }

  /// The pairs of spheres that are inside of a step.
  const PairLevels& pair_levels() const { return levels_; }
  /// Stores the level of a pair with this potential, see PairLevels. `moment` is for the journal.
  void set_level(Slot a, Slot b, StepTable::Number potential, StepPotential::Level level, const Time& moment);

  /// The last contact of spheres that passed through each other; before the first, earlier than any.
  const Event& last_passage() const { return last_passage_; }
  /// Records that two spheres have begun to pass through each other.
  void note_passage(const Event& contact) {
    if (has_journal_) journal_.note_passage(contact.time, last_passage_);
    last_passage_ = contact;
  }

  std::size_t memory_bytes() const;

 private:
  friend class SphereEdit;
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    if constexpr (std::remove_cvref_t<decltype(archive)>::kIsReading) {
      archive(static_cast<Setting&>(self), static_cast<Spheres&>(self), self.last_passage_);
    } else {
      archive(static_cast<const Setting&>(self), static_cast<const Spheres&>(self), self.last_passage_);
    }
    persist_levels(archive, self);
  }
  // By slots, each pair once, in the order of slots.
  static void persist_levels(auto& archive, auto& self) {
    std::vector<std::pair<Slot, PairLevel>> pairs;
    if constexpr (!std::remove_cvref_t<decltype(archive)>::kIsReading) pairs = self.levels_.in_order();
    archive(pairs);
    if constexpr (std::remove_cvref_t<decltype(archive)>::kIsReading) {
      for (const auto& [slot, pair] : pairs) {
        archive.require(slot < self.size() && pair.partner < self.size() && slot < pair.partner);
        self.levels_.set(slot, pair.partner, pair.potential, pair.level);
      }
    }
  }
  bool restored();

  Vec3 velocity_in_box(Slot slot, const Time& moment) const;
  void set_spin(Slot slot, const Vec3& spin);
  void set_state(Slot slot, const SphereState& state);
  void reshape(Slot slot, double radius, double mass, double inertia_factor);
  void check_spin(const Vec3& spin, const std::string& where) const;
  void check_in_plane(const Vec3& vector, const char* what, const std::string& where) const;
  void check_mass(double mass, const std::string& where) const;
  void check_fits(double radius, std::size_t axis, const std::string& where) const;
  void check_resolved(double radius, const std::string& where) const;
  void note_traits();

  PairLevels levels_;
  bool has_traits_ = false;
  bool has_grown_ = false;
  bool has_journal_ = false;
  Journal journal_;
  Event last_passage_{Time(-std::numeric_limits<double>::infinity()), EventKind::collision, 0, 0, {}};
};

}  // namespace hardball
