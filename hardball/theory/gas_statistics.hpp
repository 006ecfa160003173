// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "hardball/errors/export.hpp"
#include "hardball/numbers/exact_sum.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// From this number of spheres on, what an event needs is far away in memory.
inline constexpr std::size_t kVeryManySpheres = 300000;

/// What kinetic theory needs of a world: averages over its spheres, and its box.
struct HARDBALL_EXPORT GasStatistics {
  std::size_t spheres = 0;
  Box box;
  /// Edge lengths of the box; along open axes, the length of the interval that holds most spheres [L]. Zero
  /// along z in two dimensions, where volumes are areas.
  Vec3 extent;
  /// The mean of the k-th power of the radius, k = 0 to 5 [L^k].
  std::array<double, 6> radius_power{1, 0, 0, 0, 0, 0};
  double largest_radius = 0;  ///< In the epoch [L].
  double mean_speed = 0;      ///< [L/T]
  /// How much farther than its radius the region of a sphere reaches [1]: steps of potentials act there.
  double region_scale = 1;

  bool is_flat() const { return box.is_flat(); }
  double mean_radius() const { return radius_power[1]; }                             ///< [L]
  double mean_speed_along_axis() const;                                              ///< Mean of |v_x| [L/T].
  double volume() const { return box.volume_of(extent); }                            ///< [L^3]
  double number_density() const { return static_cast<double>(spheres) / volume(); }  ///< [L^-3]
  double packing_fraction() const;                                                   ///< [1]
  /// The mean of the k-th power of the radius of a region, k = 0 to 5 [L^k].
  std::array<double, 6> region_power() const;
  /// How many events two spheres have that meet, over collisions of hard spheres [1]: they enter and leave a
  /// region that they do not fill.
  double events_per_collision() const { return region_scale > 1 ? 1 + region_scale * region_scale : 1; }
};

/// Sums over spheres, of which these averages are made: the same to the bit in whichever order spheres are
/// added, and however they are divided among several such sums.
struct HARDBALL_EXPORT GasSums {
  std::size_t spheres = 0;
  std::array<ExactSum, 6> radius_power;  ///< [L^k]
  ExactSum speed;                        ///< [L/T]
  double largest_radius = 0;             ///< [L]

  /// Adds a sphere as it is at `moment`.
  void record(const World& world, Slot slot, const Time& moment);
  void add(const GasSums& other);

  static void persist(auto& archive, auto& self) {
    archive(self.spheres, self.radius_power, self.speed, self.largest_radius);
  }
};

/// Cost: O(n).
HARDBALL_EXPORT GasStatistics gas_statistics(const World& world, const Time& moment);

/// Whether the sums suffice, so that it does not matter where the spheres of a world are.
HARDBALL_EXPORT bool fills_box(const World& world);
/// Statistics from sums over the spheres of a world, of which only the box is used. Precondition:
/// fills_box(world).
HARDBALL_EXPORT GasStatistics gas_statistics(const GasSums& sums, const World& world);

/// Whether choices for one world hold for the other: as many spheres, moving, of about the same size in about
/// the same space.
HARDBALL_EXPORT bool are_alike(const GasStatistics& a, const GasStatistics& b);

}  // namespace hardball
