// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "hardball/events/event.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Spheres that have just merged: larger than the two that they were, they may overlap others, and merge with
/// those that the response merges them with, at once.
class MergedSpheres {
 public:
  bool empty() const { return ids_.empty(); }
  /// A sphere has absorbed another.
  void record(SphereId id) {
    if (ranges::find(ids_, id) == ids_.end()) ids_.push_back(id);
  }

  /// A sphere is no more.
  void forget(SphereId id) { std::erase(ids_, id); }

  /// Calls overlaps_of(slot) for these spheres, the lowest id first, and merge(event) for what it returns,
  /// until that returns true: then so does this. Otherwise nothing overlaps any more that would merge, and
  /// the list is empty.
  template <class OverlapsOf, class Merge>
  bool coalesce(const World& world, OverlapsOf&& overlaps_of, Merge&& merge) {
    while (!ids_.empty()) {
      const SphereId id = *ranges::min_element(ids_);
      for (const Event& overlap : overlaps_of(world.slot_of(id))) {
        if (merge(overlap)) return true;
      }
      forget(id);
    }
    return false;
  }

  const std::vector<SphereId>& ids() const { return ids_; }

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) { archive(self.ids_); }

  std::vector<SphereId> ids_;
};

}  // namespace hardball
