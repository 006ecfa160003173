// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/geometry/extent.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The speeds of the spheres of a world at one moment: few spheres are fast.
struct HARDBALL_EXPORT SpeedLimits {
  /// The speed below which most spheres are, over the root mean square of all.
  static constexpr double kUsualSpeed = 2.5;

  double usual = 0;        ///< No sphere is faster, but for the fast ones [L/T].
  double fastest = 0;      ///< No sphere is faster [L/T].
  std::vector<Slot> fast;  ///< The spheres that are faster than usual.

  SpeedLimits() = default;
  /// The speeds at `now`. Cost: O(n).
  SpeedLimits(const World& world, const Time& now);
};

/// SpeedLimits that are computed when they are first asked for. Copies compute their own. Const members may
/// be called by several threads at once.
class HARDBALL_EXPORT LazySpeedLimits {
 public:
  LazySpeedLimits() = default;
  LazySpeedLimits(const LazySpeedLimits&) noexcept {}
  LazySpeedLimits& operator=(const LazySpeedLimits&) noexcept {
    reset();
    return *this;
  }

  /// The limits of the world, which has not changed since `reset`, at this moment.
  const SpeedLimits& at(const World& world, const Time& now) const;
  /// To be called when velocities have changed, or spheres are other ones.
  void reset() { limits_.reset(); }

 private:
  mutable std::mutex mutex_;
  mutable std::optional<SpeedLimits> limits_;
  mutable Time moment_;
};

/// The spheres of a world, as queries look for them: one after the other, or in the cells of broad phases,
/// which know where spheres are at this moment.
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
  /// Looks at `parts`, whose spheres have the same paths as in `world`, which has them all. `speeds` are
  /// those of `world`. All must outlive this. Without parts, all spheres are looked at.
  SphereSearch(const World& world, std::vector<Part> parts, const LazySpeedLimits& speeds)
      : world_(&world), parts_(std::move(parts)), speeds_(&speeds) {
    if (parts_.empty()) *this = SphereSearch(world);
  }

  const World& world() const { return *world_; }
  const std::vector<Part>& parts() const { return parts_; }
  /// The speeds of the spheres; null if all spheres are looked at.
  const SpeedLimits* speeds(const Time& now) const { return speeds_ ? &speeds_->at(*world_, now) : nullptr; }

 private:
  const World* world_;
  std::vector<Part> parts_;
  const LazySpeedLimits* speeds_ = nullptr;
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
