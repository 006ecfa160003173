// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hardball/bounds/compact_paths.hpp"
#include "hardball/broadphase/candidates.hpp"
#include "hardball/broadphase/slot_set.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Lists the spheres, among the thousands of candidates at the surface of a large sphere, that can reach it
/// before the list expires, while its center stays within a skin of a point.
///
/// Spheres come at their own speeds or at a usual one that is rarely exceeded. Whoever becomes faster than
/// that near the large sphere must be added. How long a list lasts is adapted, so that the search for it
/// costs as much as its use. Source: docs/decisions/0012-large-spheres-as-shells-of-cells.md.
class ApproachList {
 public:
  /// Fewer candidates are not worth a list.
  static constexpr std::size_t kMinToList = 256;
  /// A list reaches no farther than this fraction of the skin of the large sphere's cells, nor does its own.
  static constexpr double kGreatestDepth = 0.25;

  /// What a list is made from.
  struct Sources {
    const World& world;
    const CompactPaths& copies;
    const SlotSet& large;  ///< Large spheres are always listed.
    double usual_speed;    ///< [L/T]
    double skin;           ///< Skin of the large sphere's cells [L].
  };

  /// Whether there is a list; otherwise all candidates must be searched.
  bool exists() const { return exists_; }
  /// The spheres listed, whole vectors of slots in memory. Precondition: exists().
  std::span<const Slot> slots() const { return {slots_.data(), count_}; }
  /// When it expires [T]. Precondition: exists().
  double expiry() const { return expiry_; }
  /// The point near which the center must stay, relative to the anchor. Precondition: exists().
  const Vec3& middle() const { return middle_; }
  /// How near [L]. Precondition: exists().
  double skin() const { return skin_; }

  /// Lists those of all candidates that can reach the sphere in `owner`, each once, if that pays; otherwise
  /// there is no list. `position` is the sphere's center, relative to its anchor. Precondition: the sphere
  /// has been copied at `now`. Cost: O(n log n) for n candidates.
  void make(const Sources& sources, Slot owner, const Vec3& position, const Time& now, const Candidates& all);
  /// The sphere has had a contact.
  void note_contact() { ++contacts_; }
  /// Adds a sphere, if there is a list.
  void add(Slot other);
  /// Puts another slot in place of one; that of the owner means none.
  void replace(Slot slot, Slot by);

 private:
  void choose_depth(double skin, std::size_t searched);
  void pad();

  bool exists_ = false;
  Slot owner_ = 0;
  std::vector<Slot> slots_;  // padded with the owner
  std::size_t count_ = 0;
  Vec3 middle_;
  double skin_ = 0;
  double expiry_ = 0;
  double depth_ = 0;            // how far from its surface spheres are listed [L]
  std::uint32_t contacts_ = 0;  // since the list was made
};

}  // namespace hardball
