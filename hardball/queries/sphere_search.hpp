// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/geometry/extent.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/queries/moving_spheres.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The spheres of a world, as queries look for them: one after the other, or in the cells of broad phases,
/// which know where spheres are at this moment; of first contacts among MovingSpheres.
class HARDBALL_EXPORT SphereSearch {
 public:
  /// Some of the spheres.
  struct Part {
    const World* world;
    const BroadPhase* phase;         ///< With cells; null if all spheres of `world` are to be looked at.
    Function<bool(Slot)> owns = {};  ///< Whether a sphere belongs to the part; empty if all do.
    /// How many spheres can be looked at while a cell is visited, which decides what is looked at [1].
    double cell_cost = 3;
  };

  /// Looks at all spheres of a world.
  SphereSearch(const World& world)  // NOLINT(google-explicit-constructor)
      : world_(&world), parts_{{&world, nullptr, {}}} {}
  /// Looks at `parts`, whose spheres have the same paths as in `world`, which has them all; at all spheres if
  /// there are none. `moving` are those of `world`. All must outlive this.
  SphereSearch(const World& world, std::vector<Part> parts, const LazyMovingSpheres& moving)
      : world_(&world), parts_(std::move(parts)), moving_(&moving) {
    if (parts_.empty()) parts_.push_back({&world, nullptr, {}});
  }

  const World& world() const { return *world_; }
  const std::vector<Part>& parts() const { return parts_; }
  /// The spheres of the world as they move; null if all are to be looked at.
  const MovingSpheres* moving(const Time& now) const { return moving_ ? moving_->at(*world_, now) : nullptr; }

 private:
  const World* world_;
  std::vector<Part> parts_;
  const LazyMovingSpheres* moving_ = nullptr;
};

/// Whether looking at all spheres of a part costs less than looking in the cells that an extent meets, which
/// it does where it has no cells.
HARDBALL_EXPORT bool is_scan_cheaper(const SphereSearch::Part& part, const Extent& extent);

/// Calls visit(slot) for each sphere of a part.
template <class Visit>
void for_each_sphere(const SphereSearch::Part& part, Visit&& visit) {
  for (Slot slot = 0; slot < part.world->size(); ++slot) visit(slot);
}

/// The cells that an extent meets. Precondition: not is_scan_cheaper(part, extent).
HARDBALL_EXPORT CellRange cells_of(const Subdivision& cells, const Extent& extent);

}  // namespace hardball
