// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/events/event.hpp"
#include "hardball/geometry/path.hpp"
#include "hardball/interaction/species.hpp"
#include "hardball/memory/huge_pages.hpp"
#include "hardball/memory/prefetch.hpp"
#include "hardball/world/id_order.hpp"
#include "hardball/world/per_sphere.hpp"
#include "hardball/world/sphere_state.hpp"

namespace hardball {

/// The spheres of a world, each in a slot: an array of each quantity. An id belongs to one sphere forever;
/// its slot changes when others are removed or reordered.
class HARDBALL_EXPORT Spheres {
 public:
  std::size_t size() const { return paths_.size(); }

  SphereId id(Slot slot) const { return ids_[slot]; }
  const Path& path(Slot slot) const { return paths_[slot]; }
  std::span<const Path> paths() const { return paths_; }
  /// By how many boxes the center of a sphere has been folded back into the box.
  const Image& folded(Slot slot) const { return folded_[slot]; }
  /// The radius at a scale of one; where sizes do not change, the radius of the sphere [L]. See Growth.
  double base_radius(Slot slot) const { return radii_[slot]; }
  const PerSphere& base_radii() const { return radii_; }
  /// Mass [M]; infinite for a kinematic sphere.
  double mass(Slot slot) const { return masses_[slot]; }
  bool is_kinematic(Slot slot) const { return std::isinf(masses_[slot]); }
  /// Moment of inertia over mass and squared radius [1].
  double inertia_factor(Slot slot) const { return inertia_factors_[slot]; }
  /// Angular velocity [1/T].
  Vec3 spin(Slot slot) const { return spins_.empty() ? Vec3{} : spins_[slot]; }
  SpeciesId species(Slot slot) const { return species_.empty() ? SpeciesId{0} : species_[slot]; }
  /// The whole state of one sphere.
  SphereState state_of(Slot slot) const;

  /// Whether any sphere has had a spin.
  bool has_spins() const { return !spins_.empty(); }
  std::size_t kinematic_count() const { return kinematic_count_; }
  /// Whether all spheres have one radius and one mass.
  bool are_alike() const { return radii_.is_common() && masses_.is_common(); }

  /// Prefetches the path of a sphere. The slot need not be in use.
  void prefetch(Slot slot) const { hardball::prefetch(paths_.data() + slot); }
  /// Prefetches radius and mass of a sphere where each sphere has its own. The slot need not be in use.
  void prefetch_size(Slot slot) const {
    if (!radii_.is_common()) radii_.prefetch(slot);
    if (!masses_.is_common()) masses_.prefetch(slot);
  }

  /// Whether a sphere has this id. Cost: O(log n).
  bool contains(SphereId id) const { return find(id).has_value(); }
  /// The slot of the sphere with this id; nothing if there is none. Cost: O(log n), O(1) if it is `hint`.
  std::optional<Slot> find(SphereId id, Slot hint) const;
  std::optional<Slot> find(SphereId id) const { return find(id, id); }
  /// The slot of the sphere with this id. Cost: O(log n). Error: no sphere has this id.
  Slot slot_of(SphereId id) const;
  /// The slot of the sphere that has `rank` lower ids before it. Precondition: `rank` is less than size().
  Slot slot_of_rank(std::size_t rank) const { return order_[rank]; }
  /// Calls visit(slot) for every sphere, in the order of ids. Cost: O(n).
  template <class Visit>
  void for_each_by_id(Visit&& visit) const {
    order_.for_each(visit);
  }

 protected:
  // The id of the next sphere that is added.
  SphereId next_id() const { return next_id_; }
  void release_last_id() { --next_id_; }
  // A sphere or an id of its own has an inertia factor, spin, species or infinite mass.
  bool has_traits_of_their_own() const;

  void reserve(std::size_t count);
  // Stores a sphere in the next slot, and its id as the last in order.
  void append_with_highest_id(const SphereState& state);
  // Stores a sphere in the next slot.
  void insert(const SphereState& state);
  // Stores a sphere in the next slot; order_ids() must follow.
  void append(const SphereState& state);
  // Sorts ids, when many spheres have been appended.
  void order_ids();
  // Removes a sphere; the one in the last slot takes its place.
  void erase(Slot slot);
  // Undoes the removal of a sphere that was in `slot`.
  void unerase(Slot slot, const SphereState& state);
  // Stores the sphere of slot order[k] in slot k.
  void reorder(std::span<const Slot> order);

  void set_state(Slot slot, const SphereState& state);
  void set_path(Slot slot, const Path& path) { paths_[slot] = path; }
  void set_folded(Slot slot, const Image& folded) { folded_[slot] = folded; }
  void set_spin(Slot slot, const Vec3& spin);
  void set_size(Slot slot, double radius, double mass, double inertia_factor);
  void multiply_radii(double factor) { radii_.multiply(factor); }

  std::size_t memory_bytes() const;

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    archive(self.next_id_, self.ids_, self.paths_, self.radii_, self.masses_, self.inertia_factors_,
            self.folded_, self.spins_, self.species_);
  }
  bool restored();

  std::size_t rank_of(SphereId id) const { return order_.rank_of(id, ids_); }

  SphereId next_id_ = 0;
  LargeVector<SphereId> ids_;
  IdOrder order_;
  LargeVector<Path> paths_;
  PerSphere radii_;
  PerSphere masses_;
  PerSphere inertia_factors_;
  LargeVector<Image> folded_;
  LargeVector<Vec3> spins_;         // none if no sphere spins
  LargeVector<SpeciesId> species_;  // none if all are zero
  std::size_t kinematic_count_ = 0;
};

}  // namespace hardball
