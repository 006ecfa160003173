// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/packing/packed_spheres.hpp"
#include "hardball/packing/packing_request.hpp"

namespace hardball {

/// How a request is carried out: nothing is left open.
struct HARDBALL_EXPORT PackingPlan {
  /// What is given in the end by the other three.
  enum class Follows : std::uint8_t { count, diameter, size, packing_fraction };

  PackingRequest::Goal goal;
  Follows follows = Follows::diameter;
  Container container;  ///< Container in which spheres grow; its size may be changed at the end.
  /// Radii at the goal, before gaps are left; approximate if the goal is not a fraction [L].
  std::vector<double> radii;
  std::vector<Vec3> start;    ///< Where the centers are; random if empty [L].
  double start_fraction = 0;  ///< The packing fraction at which growth starts [1].
  double diameter = 0;        ///< The mean before gaps are left, unless it follows [L].
  std::optional<RadiusDistribution> distribution = {};  ///< From which radii were drawn.
  double plausible = 0;        ///< The packing fraction at which such spheres can be expected to jam [1].
  double rate = 0;             ///< As in GrowthRules.
  bool is_rate_given = false;  ///< Then it is not lowered if spheres lock.
  double gap = 0;  ///< As in PackingRequest: spheres grow until they have no gaps, and are reduced then.
  std::uint64_t seed = 1;
  std::vector<std::string> warnings = {};  ///< Doubtful points of the request, a sentence each.
  SphereLabels labels = {};                ///< Labels of the spheres of a start.

  /// The packing fraction of the goal, or the plausible one, before gaps are left [1].
  double expected_fraction() const;
  /// The packing fraction of the packing when gaps are left [1].
  double final_fraction() const;
  /// Whether the container is so narrow, in diameters of the largest sphere, that its width decides how dense
  /// spheres become: then `plausible` means little.
  bool is_narrow() const;
  /// How many collisions for each sphere the run can be expected to take; some 30% off.
  double expected_collisions() const;

  static void persist(auto& archive, auto& self) {
    archive(self.goal, self.follows, self.container, self.radii, self.start, self.start_fraction,
            self.diameter, self.distribution, self.plausible, self.rate, self.is_rate_given, self.gap,
            self.seed, self.warnings, self.labels);
    archive.require(self.follows <= Follows::packing_fraction);
  }
};

/// Works out what a request leaves open. Cost: O(n log n). Error: fewer or more is given than determines the
/// packing; a number is out of range; no such packing exists.
HARDBALL_EXPORT PackingPlan plan(const PackingRequest& request);

/// A plan for another number of spheres, where that number follows from the rest. Precondition: radii are not
/// listed.
PackingPlan with_count(const PackingPlan& plan, std::size_t count);

}  // namespace hardball
