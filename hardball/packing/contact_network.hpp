// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <unordered_map>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/packing/packed_spheres.hpp"

namespace hardball {

/// Two bodies of a packing that touch.
struct PackingContact {
  ContactKey bodies;
  double gap = 0;   ///< Between their surfaces [L].
  Vec3 separation;  ///< From the center of the first to that of the second, or to the wall [L].
  /// Over the mean of all forces of the network [1]; NaN where none are known.
  double force = std::numeric_limits<double>::quiet_NaN();
};

/// The network of contacts that holds a packing, and its rattlers.
struct ContactNetwork {
  /// Gaps up to this count as contacts, over the sum of the radii [1]; zero where spheres are too far apart
  /// for contacts to mean anything.
  double tolerance = 0;
  std::vector<PackingContact> contacts;  ///< By the first body, then the second; those of rattlers, too.
  std::vector<bool> rattles;  ///< By sphere: whether it is not held by at least d + 1 others, or walls.
  std::size_t rattlers = 0;
  std::size_t backbone_contacts = 0;  ///< Without those of rattlers.
  /// Contacts of the backbone over the number that holds it with one state of stress: d for each sphere, less
  /// the motions that the container leaves free, and one [1]; NaN without a backbone.
  double isostaticity = std::numeric_limits<double>::quiet_NaN();
};

/// The contacts of spheres, with the impulses that they exchanged, if any are known. Cost: O(n).
HARDBALL_EXPORT ContactNetwork contact_network(const PackedSpheres& spheres, double tolerance,
                                               const std::unordered_map<ContactKey, double>& impulses = {});

}  // namespace hardball
