// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "hardball/packing/container.hpp"
#include "hardball/placement/radii.hpp"
#include "hardball/trajectory/snapshot.hpp"

namespace hardball {

/// What a packing is to have been when it is finished: three of the number of spheres, their mean diameter,
/// the container and the packing fraction; the fourth follows.
struct PackingRequest {
  /// As dense as spheres jam.
  struct Densest {
    friend bool operator==(const Densest&, const Densest&) = default;
    static void persist(auto& /*archive*/, auto& /*self*/) {}
  };
  /// As dense as it takes for PV/NkT of the median sphere to be this high [1].
  struct Pressure {
    double compressibility = 0;

    friend bool operator==(const Pressure&, const Pressure&) = default;
    static void persist(auto& archive, auto& self) { archive(self.compressibility); }
  };
  using Goal = std::variant<double, Densest, Pressure>;  ///< A double is a packing fraction [1].

  std::size_t dimensions = 3;             ///< 2 for discs.
  std::optional<std::size_t> count = {};  ///< If not given, that of `radii`.
  /// The mean diameter [L]; if not given, that of `radii`, or 1 where nothing else has a length.
  std::optional<double> diameter = {};
  /// How radii are distributed about their mean; equal if not given. A mean of 1 will do.
  std::optional<RadiusDistribution> distribution = {};
  std::vector<double> radii = {};           ///< Listed radii, instead [L].
  std::optional<Container> container = {};  ///< A periodic cube if not given.
  /// Edges of the container are only proportions; but a mesh keeps its size where one of the other three is
  /// not given.
  bool is_container_size_free = false;
  std::optional<Goal> goal = {};
  /// How fast spheres grow, in the unit of GrowthRules::rate; chosen by the goal if not given.
  std::optional<double> rate = {};
  /// The fraction by which radii are reduced in the end, beyond what rounding takes [1]. Count, diameter,
  /// container and packing fraction are those of the reduced spheres.
  double gap = 0;
  std::uint64_t seed = 1;  ///< Seed of sizes, positions and velocities.
  /// Spheres that grow from where they are, in the box of the snapshot; their number, sizes and container are
  /// not given otherwise.
  std::optional<Snapshot> start = {};
};

}  // namespace hardball
