// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hardball/domains/boundary_watch.hpp"
#include "hardball/domains/messages.hpp"
#include "hardball/domains/ownership_map.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// What a contact did to a ghost.
struct GhostRecord {
  PathRecord record;
  Path path_before;
  Vec3 spin_before;
  std::uint32_t ghost = 0;
};

/// A ghost that is not what its owner says, and what it is.
struct Correction {
  std::uint32_t ghost = 0;
  Path path;
  Vec3 spin;
};

/// Compares what happened to the ghosts of a domain with what happened to them at their owners.
class Comparison {
 public:
  /// Returns when an own sphere first had a contact with a ghost that differs, here or at its owner [T];
  /// infinity if none had in the whole window, from `begin` to `end`. Appends a Conflict about each ghost
  /// that differs to the outbox of its owner, which must compare the two; see time_of_conflict.
  ///
  /// Of a sphere that differs, only a contact with an own sphere matters, here or at its owner; and where an
  /// own sphere may be wrong, too, whether the two have touched. Source: docs/parallel.md, with the proof.
  double compare(const World& world, const OwnershipMap& ownership, const BoundaryWatch& boundary,
                 std::span<const GhostRecord> own, std::span<const Outbox* const> inboxes, double begin,
                 double end, std::vector<Outbox>& outboxes);

  /// The ghosts that differ.
  std::span<const Correction> corrections() const { return corrections_; }

 private:
  // A record of a ghost that differs; those of its owner come first.
  struct Reference {
    std::uint32_t number;
    const PathRecord* record;
    const GhostRecord* own;  // none in a record of the owner
  };

  void find_differing(const OwnershipMap& ownership, std::span<const GhostRecord> own,
                      std::span<const Outbox* const> inboxes);
  void collect_references(std::span<const GhostRecord> own, std::span<const Outbox* const> inboxes);

  std::vector<std::size_t> next_;  // by neighbor, the first of its records that remains to be compared
  std::vector<SphereId> differing_;
  std::vector<Reference> references_;
  std::vector<Correction> corrections_;
};

/// A time before which two spheres that may be wrong in two domains cannot have touched [T]; infinity if they
/// have not.
double time_of_conflict(const Box& box, const Halo& halo, std::span<const Conflict> own,
                        std::span<const Conflict> other);

}  // namespace hardball
