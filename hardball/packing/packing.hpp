// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "hardball/describe/names.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/packing/contact_network.hpp"
#include "hardball/packing/container.hpp"
#include "hardball/packing/packer.hpp"
#include "hardball/trajectory/snapshot.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Spheres that have been packed, at rest, and what is known about them.
struct HARDBALL_EXPORT Packing {
  enum class Status : std::uint8_t {
    reached,      ///< Spheres are as dense as wanted.
    jammed,       ///< Spheres are as dense as they get, which was wanted.
    not_reached,  ///< Less dense than wanted; see `reason`.
  };

  Status status = Status::not_reached;
  std::string reason;         ///< Why packing ended where it did, in a sentence.
  double suggested_rate = 0;  ///< A rate that may reach more, as in GrowthRules; zero if none is known.
  PackedSpheres spheres;
  /// The factor by which radii were reduced so that nothing overlaps in the numbers as they are written, with
  /// the gap or diameter wanted [1].
  double shrink = 1;
  double largest_overlap = 0;  ///< In the numbers as they are written, over the sum of the radii [1].
  double smallest_gap = 0;     ///< Between two bodies as written, over the sum of the radii [1].
  double pressure =
      std::numeric_limits<double>::quiet_NaN();  ///< PV/NkT of the median sphere before `shrink` [1].
  double rate = 0;                               ///< The last one, as in GrowthRules.
  std::uint64_t collisions = 0;
  ContactNetwork network;    ///< Contacts counted in the numbers as they are written.
  bool is_polished = false;  ///< Whether its last gaps were removed, see polish().
  double crystalline = 0;    ///< The share of spheres in crystals, see crystalline_share [1].
  std::vector<PackingMoment> history;
  std::vector<std::string> warnings;

  /// The volume of the spheres over that of the container [1].
  double packing_fraction() const { return spheres.packing_fraction(); }
};

/// How the numbers of a packing are stored: its gaps are made for that.
enum class Precision : std::uint8_t {
  doubles,
  singles,  ///< As in GSD files: positions from the center of the box, diameters and edges in 32 bits.
};

/// The packing that a packer has reached, or how far it has come, in the numbers of the run. Cost: O(n).
HARDBALL_EXPORT Packing packing_of(const Packer& packer);

/// Rounds what a file stores to this precision, multiplies radii by `factor`, and reduces them until nothing
/// overlaps in these numbers. Cost: O(n).
HARDBALL_EXPORT void fit_numbers(PackedSpheres& spheres, Precision precision, double factor = 1);

/// Gives a packing the size that the plan wants, and reduces radii until nothing overlaps in numbers of this
/// precision, and the gap of the plan is there. Contacts become those of the result: where what touched
/// before has wider gaps than count as contacts, these do. Cost: O(n).
HARDBALL_EXPORT void finish(Packing& packing, const PackingPlan& plan,
                            Precision precision = Precision::doubles);

/// The spheres as a frame: at rest, in the box around the container, with their labels. Cost: O(n).
HARDBALL_EXPORT Snapshot snapshot_of(const PackedSpheres& spheres);

/// A world in which they go on as a gas of this temperature, kT of spheres of mass 1 [M L^2 T^-2]. Cost:
/// O(n).
HARDBALL_EXPORT World world_of(const PackedSpheres& spheres, double temperature, std::uint64_t seed);

template <>
inline constexpr std::array<std::string_view, 3> kNames<Packing::Status>{"reached", "jammed", "not reached"};

}  // namespace hardball
