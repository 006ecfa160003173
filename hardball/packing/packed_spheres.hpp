// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/packing/container.hpp"
#include "hardball/world/sphere.hpp"

namespace hardball {

/// Two bodies that touch: spheres by id, `image` being that of the second which the first meets, or a sphere
/// and a wall, numbered from kFaces on where it is no face of the box: a mesh has as many walls as MeshWalls
/// says.
struct ContactKey {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  bool is_wall = false;
  Image image = {};

  friend auto operator<=>(const ContactKey&, const ContactKey&) = default;
  static void persist(auto& archive, auto& self) {
    archive(self.first, self.second, self.is_wall, self.image);
  }
};

/// Two bodies close to each other.
struct NearPair {
  ContactKey bodies;
  Vec3 separation;   ///< From the center of the first to that of the second, or to the wall [L].
  double reach = 0;  ///< How long that is when they touch [L].
  double gap = 0;    ///< Between their surfaces, to 2^-100 of the reach; negative if they overlap [L].
};

/// What files hold of spheres besides their positions and sizes, as read from the start file.
struct SphereLabels {
  std::vector<std::int64_t> ids;   ///< None if they are 0, 1, 2 and so on.
  std::vector<SpeciesId> species;  ///< None if all are of species 0.
  std::vector<double> masses;      ///< None if all are 1 [M].
  Vec3 low = {};                   ///< The corner of the box with the least coordinates [L].

  friend bool operator==(const SphereLabels&, const SphereLabels&) = default;
  static void persist(auto& archive, auto& self) { archive(self.ids, self.species, self.masses, self.low); }
};

/// Spheres at rest in a container.
struct HARDBALL_EXPORT PackedSpheres {
  Container container;
  std::vector<Vec3> positions;  ///< Centers, within the box around the container [L].
  std::vector<double> radii;    ///< [L]
  SphereLabels labels = {};

  std::size_t size() const { return radii.size(); }
  double mean_diameter() const;
  /// The volume of the spheres over that of the container [1].
  double packing_fraction() const;
  /// Calls visit(pair) for each two bodies whose gap is no more than `gap` times the sum of their radii, or
  /// the radius at a wall; by the first, then the second, walls last. Cost: O(n).
  void for_each_near(double gap, const Function<void(const NearPair&)>& visit) const;
  /// The deepest overlap, over the sum of the radii, or the radius at a wall [1]; zero if nothing overlaps.
  double largest_overlap() const;
  /// The smallest gap between two bodies, over the sum of the radii, or the radius at a wall [1]; negative if
  /// they overlap. Precondition: the container has walls or periods. Cost: O(n).
  double smallest_gap() const;
};

}  // namespace hardball

template <>
struct std::hash<hardball::ContactKey> {
  std::size_t operator()(const hardball::ContactKey& key) const {
    std::uint64_t bits = (std::uint64_t{key.first} << 32 | key.second) ^ (key.is_wall ? 1 : 0);
    for (const std::int32_t boxes : key.image.boxes)
      bits = bits * 0x9E3779B97F4A7C15 + static_cast<std::uint32_t>(boxes);
    return static_cast<std::size_t>(bits ^ bits >> 32);
  }
};
