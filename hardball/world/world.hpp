// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hardball/errors/compilation.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/events/event.hpp"
#include "hardball/geometry/contact_time.hpp"
#include "hardball/interaction/interactions.hpp"
#include "hardball/memory/huge_pages.hpp"
#include "hardball/memory/prefetch.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/box.hpp"
#include "hardball/world/id_order.hpp"
#include "hardball/world/journal.hpp"
#include "hardball/world/pair_levels.hpp"
#include "hardball/world/per_sphere.hpp"
#include "hardball/world/sphere.hpp"

namespace hardball {

/// Two spheres that are tied together by a potential of the step table, the one with the lower id first.
struct Bond {
  SphereId first = 0;
  SphereId second = 0;
  StepTable::Number potential = StepTable::kNone;

  friend auto operator<=>(const Bond&, const Bond&) = default;
};

/// The box, the surfaces and the spheres in it: their stored paths, radii and masses. The state of the motion
/// and nothing else.
class HARDBALL_EXPORT World : CompilationCheck {
 public:
  explicit World(const Box& box = Box::open()) : box_(box) {}
  /// With an acceleration that acts on all spheres [L/T^2], and walls and obstacles, which are numbered from
  /// kFaces on. Error: gravity is not finite or out of range; a surface that is not the same in every
  /// periodic image of the box, and is no obstacle; a plane that no sphere can reach, as faces of the box are
  /// in front of it; in two dimensions, gravity or a surface out of the plane.
  World(const Box& box, const Vec3& gravity, std::vector<Surface> surfaces = {});

  const Box& box() const { return box_; }
  const Motion& motion() const { return motion_; }
  std::span<const Surface> surfaces() const { return surfaces_; }
  /// The surface of a wall event. Precondition: `number` is not that of a face of the box.
  const Surface& surface(std::uint32_t number) const { return surfaces_[number - kFaces]; }
  std::size_t size() const { return paths_.size(); }

  /// Reserves memory for `count` spheres.
  void reserve(std::size_t count);

  /// Adds a sphere in its state at `moment`, and returns its id: ids count up from zero.
  /// Positions outside a periodic box are folded into it. Overlaps are not checked here (see audit.hpp).
  /// Error: spheres grow; a number that is NaN, infinite or out of range; a radius, mass or inertia factor
  /// that is not positive; a center closer to a wall than the radius, or more than 2^30 boxes away; a box too
  /// small to hold the sphere; a kinematic sphere where there is gravity; in two dimensions, a position or
  /// velocity out of the plane, or a spin within it.
  SphereId add(const Sphere& sphere, const Time& moment = Time(0));

  /// Error: `add` would refuse this sphere.
  void check(const Sphere& sphere) const;

  /// Error: `change_velocity` would refuse this velocity.
  void check_velocity(SphereId id, const Vec3& velocity) const;

  /// A world with this box, gravity, surfaces and interactions, and without spheres.
  World without_spheres() const;
  /// All that is known of one sphere.
  SphereState state_of(Slot slot) const;
  /// Stores a sphere with the id and the path that it has in another world with the same box, and returns its
  /// slot, the last. Precondition: no sphere has this id; there is no journal. Cost: O(log n), and as of
  /// IdOrder::insert.
  Slot insert(const SphereState& state);
  /// Stores many spheres with the ids and paths that they have in another world: state_of(k) returns the
  /// k-th. Leaves some room for others. Cost: O(n log n), or O(ids ever given).
  template <class MakeState>
  void insert_all(std::size_t count, MakeState&& state_of) {
    constexpr std::size_t kRoom = 16;
    reserve(size() + count + count / kRoom);
    for (std::size_t k = 0; k < count; ++k) append(state_of(k));
    order_ids();
  }

  /// Removes a sphere; the one in the last slot takes its place. `moment` is for the journal. Cost: O(log n)
  /// amortized. Error: no sphere has this id.
  void remove(SphereId id, const Time& moment = Time(0)) { remove_at(slot_of(id), moment); }
  /// Removes the sphere in a slot; the one in the last slot takes its place. `moment` is for the journal.
  /// Cost: O(log n) amortized.
  void remove_at(Slot slot, const Time& moment);
  /// Undoes the last addition, and releases its id. Precondition: nothing else has changed since.
  void undo_add();

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

  /// Begins an epoch of growth, in which all radii are the base radii times a scale (geometry/growth.hpp).
  /// Structures that were made for the spheres must be rebuilt. Error: a number that is not finite, or a
  /// scale that is not positive throughout; spheres that do not fit the box or a surface at its largest
  /// scale; anything that growth excludes: gravity, kinematic spheres, spins, rough spheres, species that
  /// merge or pass through each other, walls that move or have a temperature.
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

  /// What happens when spheres touch each other or a wall; by default they are smooth and elastic.
  const Interactions& interactions() const { return interactions_; }
  /// Error, and nothing changes: they exclude each other, or gravity, growth or shear excludes them.
  void set_interactions(const Interactions& interactions);

  SphereId id(Slot slot) const { return ids_[slot]; }
  /// The radius at a scale of one; where sizes do not change, that of the sphere [L]. See Growth.
  double base_radius(Slot slot) const { return radii_[slot]; }
  /// The radius at `moment` [L]. Precondition: the moment is in the present epoch.
  double radius(Slot slot, const Time& moment) const { return radii_[slot] * motion_.scale_at(moment); }
  /// How far from a sphere's center its region must reach [L], so that two spheres have no event before their
  /// regions meet: the largest radius of the present epoch, or more where steps of a potential act farther.
  double bounding_radius(Slot slot) const { return radii_[slot] * bounding_scale_; }
  double mass(Slot slot) const { return masses_[slot]; }
  bool is_kinematic(Slot slot) const { return std::isinf(masses_[slot]); }
  /// Angular velocity [1/T].
  Vec3 spin(Slot slot) const { return spins_.empty() ? Vec3{} : spins_[slot]; }
  SpeciesId species(Slot slot) const { return species_.empty() ? SpeciesId{0} : species_[slot]; }
  /// Moment of inertia over mass and squared radius [1].
  double inertia_factor(Slot slot) const { return inertia_factors_[slot]; }
  /// Whether a sphere has had a spin, a species or an inertia factor of its own, or an infinite mass, or some
  /// pass through each other: in one flag, as every contact asks.
  bool has_traits() const { return has_traits_; }
  bool has_spins() const { return !spins_.empty(); }
  /// Whether any sphere is kinematic.
  bool has_kinematic() const { return kinematic_count_ > 0; }
  /// Whether contacts of some pairs do not deflect them: species that pass, and kinematic spheres.
  bool has_passing_pairs() const { return interactions_.has_passing() || kinematic_count_ > 1; }
  /// Whether the contacts of two spheres do not deflect them.
  bool pass(Slot a, Slot b) const {
    return interactions_.pass(species(a), species(b)) || (is_kinematic(a) && is_kinematic(b));
  }
  const PerSphere& base_radii() const { return radii_; }
  const Path& path(Slot slot) const { return paths_[slot]; }
  /// The position on the path at `moment`, perhaps outside of a periodic box [L]. Precondition: `moment` is
  /// finite.
  Vec3 unfolded_position(Slot slot, const Time& moment) const {
    return motion_.position_at(paths_[slot], moment);
  }
  /// The velocity at `moment` along the path [L/T]; in a sheared box, that of the image which began it.
  /// Precondition: `moment` is finite.
  Vec3 unfolded_velocity(Slot slot, const Time& moment) const {
    return motion_.velocity_at(paths_[slot], moment);
  }
  /// The velocity at `moment` of the image that is in the box [L/T]. Precondition: `moment` is finite.
  Vec3 velocity(Slot slot, const Time& moment) const {
    if (box_.is_sheared()) [[unlikely]]
      return velocity_in_box(slot, moment);
    return unfolded_velocity(slot, moment);
  }
  /// The velocity relative to the flow of a sheared box where the sphere is [L/T], the same for all its
  /// images; the velocity where there is no shear. Precondition: `moment` is finite.
  Vec3 peculiar_velocity(Slot slot, const Time& moment) const {
    if (box_.is_sheared()) [[unlikely]]
      return velocity(slot, moment) - flow_velocity(slot, moment);
    return unfolded_velocity(slot, moment);
  }
  /// The velocity of the flow of a sheared box where the sphere is in the box [L/T]; zero where there is no
  /// shear. Precondition: `moment` is finite.
  Vec3 flow_velocity(Slot slot, const Time& moment) const {
    return {box_.is_sheared() ? box_.flow_speed(position(slot, moment).y) : 0, 0, 0};
  }
  std::span<const Path> paths() const { return paths_; }

  /// Prefetches a sphere's path. The slot need not be in use.
  void prefetch(Slot slot) const { hardball::prefetch(paths_.data() + slot); }
  /// Prefetches a sphere's radius and mass, where each sphere has its own. The slot need not be in use.
  void prefetch_size(Slot slot) const {
    if (!radii_.is_common()) radii_.prefetch(slot);
    if (!masses_.is_common()) masses_.prefetch(slot);
  }
  /// Whether all spheres have the same radius and mass.
  bool are_alike() const { return radii_.is_common() && masses_.is_common(); }

  /// Whether a sphere has this id. Cost: O(log n).
  bool contains(SphereId id) const { return find(id).has_value(); }

  /// The slot of the sphere with this id; nothing if there is none. Cost: O(log n), O(1) if it is `hint`.
  std::optional<Slot> find(SphereId id, Slot hint) const;
  std::optional<Slot> find(SphereId id) const { return find(id, id); }

  /// The slot of the sphere with this id. Cost: O(log n). Error: no sphere has this id.
  Slot slot_of(SphereId id) const;

  /// The slot of the sphere that has `rank` lower ids before it. Precondition: `rank` is less than
  /// size().
  Slot slot_of_rank(std::size_t rank) const { return order_[rank]; }

  /// Calls visit(slot) for every sphere, in the order of ids. Cost: O(n).
  template <class Visit>
  void for_each_by_id(Visit&& visit) const {
    order_.for_each(visit);
  }

  /// Stores the sphere of slot order[k] in slot k; ids stay. `order` holds every slot once. Cost: O(ids ever
  /// given).
  void reorder(std::span<const Slot> order);

  /// The center at `moment` [L], folded into a periodic box. Error: `moment` is NaN or infinite.
  Vec3 position(Slot slot, const Time& moment) const;
  /// The center at `moment` as if it had never been folded into the box [L]; in a sheared box it moves on
  /// with the flow at the height that it has reached. Precondition: as for unfolded_position.
  Vec3 unwrapped_position(Slot slot, const Time& moment) const {
    return unfolded_position(slot, moment) + box_.shift(folded_[slot], moment);
  }
  /// By how many boxes the center at `moment` would lie outside the box if it had never been folded. Error:
  /// as for position().
  Image image(Slot slot, const Time& moment) const;

  /// Sum of m v^2 / 2 at `moment` [M L^2 T^-2]. These sums exclude kinematic spheres, and are exact until
  /// they are rounded, so that the order of spheres does not matter; in a sheared box they are relative to
  /// the flow. Cost: O(n).
  double kinetic_energy(const Time& moment) const;
  /// Sum of I w^2 / 2, with the spin w [M L^2 T^-2]. Cost: O(n).
  double rotational_energy() const;
  /// Kinetic and rotational energy and, with gravity, potential energy, which is zero at the origin and uses
  /// unwrapped positions in a periodic box [M L^2 T^-2]. Cost: O(n).
  double energy(const Time& moment) const;
  /// Sum of m v at `moment` [M L/T]. Cost: O(n).
  Vec3 momentum(const Time& moment) const;
  /// Volume of the spheres at `moment` [L^3], in two dimensions the area of the discs [L^2]. Cost: O(n).
  double sphere_volume(const Time& moment) const;
  /// The largest radius that any sphere has in the present epoch [L]; zero in an empty world.
  double largest_radius() const;
  /// The greatest bounding radius of all spheres [L]; zero in an empty world.
  double largest_bounding_radius() const;

  /// Whether there are potentials of steps.
  bool has_steps() const { return has_steps_; }
  /// The pairs of spheres that are inside of a step.
  const PairLevels& pair_levels() const { return levels_; }
  /// The potential of two spheres that are inside of no step, by its number; StepTable::kNone if none.
  StepTable::Number potential_of(Slot a, Slot b) const {
    return is_kinematic(a) && is_kinematic(b) ? StepTable::kNone
                                              : interactions_.steps().of(species(a), species(b));
  }
  /// At which distance two spheres bounce off each other, over the sum of their radii [1]; zero if they may
  /// take the same place.
  double core_ratio(Slot a, Slot b) const;
  /// The energy of all steps that a sphere is inside of, half of each pair's [M L^2 T^-2]. Cost: O(pairs of
  /// the sphere).
  double step_energy(Slot slot) const;
  /// The energy of all steps that spheres are inside of [M L^2 T^-2]. Cost: O(n).
  double step_energy() const;
  /// Ties two spheres together by a potential of the step table. Error: no sphere has an id; they are one, or
  /// tied already; the potential is not a tether. Precondition: assign_levels follows.
  void add_bond(SphereId a, SphereId b, StepTable::Number potential);
  /// The bonds by the ids of their spheres, in order. Cost: O(pairs log pairs), O(1) if there are none.
  std::vector<Bond> bonds() const;
  /// Finds the levels of all pairs from their distances at `moment`; at the distance of a step those that
  /// approach each other are inside. To be called once, before the first event: from then on levels are a
  /// state. Cost: O(n). Error: spheres that are tied are too far apart or too close; a step reaches to half
  /// of a periodic box.
  void assign_levels(const Time& moment);
  /// Finds the levels of the pairs of one sphere that has been added with others that may be near it. Cost:
  /// O(others).
  void assign_levels(Slot added, std::span<const Slot> others, const Time& moment);

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
    archive(self.box_, self.motion_, self.surfaces_, self.next_id_, self.ids_, self.paths_, self.radii_,
            self.masses_, self.inertia_factors_, self.folded_, self.spins_, self.species_, self.interactions_,
            self.last_passage_);
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
  void refuse_shear_with_others() const;
  void set_level(Slot a, Slot b, StepTable::Number potential, StepPotential::Level level, const Time& moment);
  void assign_level(Slot a, Slot b, const Time& moment);
  void check_steps() const;
  void check_ranges() const;
  void note_reaches();
  void set_spin(Slot slot, const Vec3& spin);
  void reshape(Slot slot, double radius, double mass, double inertia_factor);
  void set_state(Slot slot, const SphereState& state);
  void append(const SphereState& state);
  void order_ids();
  void check_spin(const Vec3& spin, const std::string& where) const;
  void check_in_plane(const Vec3& vector, const char* what, const std::string& where) const;
  void note_traits();
  void check_mass(double mass, const std::string& where) const;
  void check_fits(double radius, std::size_t axis, const std::string& where) const;
  void refuse_growth_with_others() const;
  std::size_t rank_of(SphereId id) const { return order_.rank_of(id, ids_); }

  Box box_;
  Motion motion_;
  std::vector<Surface> surfaces_;
  SphereId next_id_ = 0;
  LargeVector<SphereId> ids_;
  IdOrder order_;
  LargeVector<Path> paths_;
  PerSphere radii_;
  PerSphere masses_;
  PerSphere inertia_factors_;
  std::vector<Image> folded_;       // by how many boxes the center has been folded back
  std::vector<Vec3> spins_;         // none if no sphere spins
  std::vector<SpeciesId> species_;  // none if all are zero
  Interactions interactions_;
  PairLevels levels_;
  double bounding_scale_ = 1;
  std::size_t kinematic_count_ = 0;
  bool has_traits_ = false;
  bool has_steps_ = false;
  bool has_grown_ = false;
  bool has_journal_ = false;
  Journal journal_;
  Event last_passage_{Time(-std::numeric_limits<double>::infinity()), EventKind::collision, 0, 0, {}};
};

/// m v^2 / 2 of one sphere at `moment` [M L^2 T^-2]; zero of a kinematic one. In a sheared box, relative to
/// the flow.
inline double kinetic_energy(const World& world, Slot slot, const Time& moment) {
  if (world.is_kinematic(slot)) return 0;
  const Vec3 velocity = world.peculiar_velocity(slot, moment);
  return world.mass(slot) * dot(velocity, velocity) / 2;
}

/// m v of one sphere at `moment` [M L/T]; zero of a kinematic one. In a sheared box, relative to the flow.
inline Vec3 momentum(const World& world, Slot slot, const Time& moment) {
  return world.is_kinematic(slot) ? Vec3{} : world.mass(slot) * world.peculiar_velocity(slot, moment);
}

/// I w^2 / 2 of one sphere [M L^2 T^-2]; zero of a kinematic one.
HARDBALL_EXPORT double rotational_energy(const World& world, Slot slot);

/// The sum of both, with potential energy; see World::energy.
HARDBALL_EXPORT double energy(const World& world, Slot slot, const Time& moment);

/// More than the rounding error of the coordinates of a center [L], which shows in spheres very far away.
inline double coordinate_error(const World& world, Slot slot, const Time& now) {
  return 0x1p-50 * length(world.unfolded_position(slot, now));
}

/// The image of `b` nearest to `a` at `moment`.
inline Image nearest_image(const World& world, Slot a, Slot b, const Time& moment) {
  return world.box().nearest_image(world.unfolded_position(a, moment) - world.unfolded_position(b, moment),
                                   moment);
}

/// The relative position and velocity of `image` of `b` as seen from `a` at `moment`. Exchanging the spheres
/// and negating the image negates the result exactly.
inline State relative_state(const World& world, Slot a, Slot b, const Image& image, const Time& moment) {
  State relative = relative_state_at(world.motion(), world.path(a), world.path(b),
                                     world.box().shift(image, moment), moment);
  if (world.box().is_sheared() && image[1] != 0) relative.velocity += world.box().image_velocity(image);
  return relative;
}

/// The next event of two spheres that meet each other alone.
struct PairEvent {
  Time time = kNever;
  bool is_outward = false;  ///< Whether they come to a step from inside.
};

/// The next event of two spheres with a potential of steps, `image` being that of `b` which `a` meets: a
/// function of their paths and their level.
HARDBALL_EXPORT PairEvent next_pair_event(const World& world, Slot a, Slot b, const Image& image);

/// The next event of a sphere and one of its pairs with a potential of steps.
HARDBALL_EXPORT PairEvent next_pair_event(const World& world, Slot slot, const PairLevel& pair,
                                          const Image& image);

/// The moment at which two spheres of a sheared box touch; see contact_time.
HARDBALL_EXPORT Time sheared_contact_time(const World& world, Slot a, Slot b, const Image& image);

/// The moment at which two spheres touch, or come to a step, `image` being that of `b` which `a` meets;
/// kNever if never.
inline Time contact_time(const World& world, Slot a, Slot b, const Image& image) {
  if (world.has_steps()) [[unlikely]]
    return next_pair_event(world, a, b, image).time;
  if (world.box().is_sheared()) [[unlikely]]
    return sheared_contact_time(world, a, b, image);
  return contact_time(world.motion(), world.path(a), world.path(b), world.box().shift(image),
                      world.base_radius(a) + world.base_radius(b));
}

/// Whether two spheres are passing through each other, and so will not touch on their present paths: they are
/// inside each other when the later path starts, or their contact has been recorded. Precondition: pass(a,
/// b).
HARDBALL_EXPORT bool are_passing(const World& world, Slot a, Slot b, const Image& image);

}  // namespace hardball
