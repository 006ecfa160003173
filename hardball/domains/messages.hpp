// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "hardball/domains/partition.hpp"
#include "hardball/geometry/path.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// What a contact did to a sphere that several domains hold.
struct PathRecord {
  static constexpr SphereId kWall = std::numeric_limits<SphereId>::max();

  Path path;  ///< After the contact.
  Vec3 spin;  ///< Spin after the contact [1/T].
  Time time;  ///< Time of the contact.
  SphereId sphere = 0;
  SphereId partner = kWall;  ///< The sphere that it touched, or kWall.
  /// Whether the partner is an own sphere of the receiving domain, or of the domain that records a contact of
  /// a ghost.
  bool is_partner_own = false;

  friend bool operator==(const PathRecord&, const PathRecord&) = default;
};

/// A part of a path that leads near a block, of a sphere that the block's domain does not hold.
struct NearPass {
  double begin = 0;     ///< When that part begins [T].
  double distance = 0;  ///< From the block then [L].
  double speed = 0;     ///< The largest component of the velocity then [L/T].
  double least = 0;     ///< No point of the part is nearer to the block [L].
};

/// A cube that contains a sphere whose path differs in two domains, from the last change on which they agree
/// to the end of the window.
struct Conflict {
  double since = 0;   ///< When the paths began to differ [T].
  Vec3 center;        ///< [L]
  double extent = 0;  ///< Half the edge of the cube [L].
};

/// A sphere that a domain is to hold, and its owner.
struct Arrival {
  SphereState sphere;
  DomainNumber owner = 0;
};

/// The new owner of a sphere.
struct NewOwner {
  SphereId sphere = 0;
  DomainNumber owner = 0;
};

/// A sphere that the receiving domain owns from here on, and the other domains that hold it.
struct Handover {
  SphereState sphere;
  std::vector<DomainNumber> holders;
  std::uint32_t idle_contacts = 0;  ///< See CollapseGuard.
};

/// The messages of one domain to another in a window.
struct Outbox {
  std::vector<PathRecord> records;  ///< Own spheres that the other domain holds, in the order of time.
  std::vector<NearPass> near_passes;
  std::vector<Conflict> conflicts;  ///< About spheres that the other owns.
  std::vector<SphereId> departures;
  std::vector<Arrival> arrivals;
  std::vector<NewOwner> new_owners;
  std::vector<Handover> handovers;

  void clear() {
    records.clear();
    near_passes.clear();
    conflicts.clear();
    departures.clear();
    arrivals.clear();
    new_owners.clear();
    handovers.clear();
  }
};

}  // namespace hardball
