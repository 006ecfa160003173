// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "hardball/domains/block_distances.hpp"
#include "hardball/domains/halo.hpp"
#include "hardball/domains/messages.hpp"
#include "hardball/domains/ownership_map.hpp"
#include "hardball/domains/partition.hpp"
#include "hardball/domains/wakeups.hpp"
#include "hardball/geometry/motion.hpp"

namespace hardball {

/// The largest component of a vector: the distances here are the largest over the axes.
inline double largest_component(const Vec3& vector) {
  return std::max({std::fabs(vector.x), std::fabs(vector.y), std::fabs(vector.z)});
}

/// A part of a path, from one moment to another.
struct Leg {
  double begin = 0;   ///< [T]
  double end = 0;     ///< [T]
  Vec3 end_position;  ///< Inside the box [L].
  Vec3 end_velocity;  ///< [L/T]
};

/// Watches where the own spheres of a domain fly: how far beyond its block, and how near to blocks of domains
/// that do not hold them.
///
/// A sphere in the interior needs no watching: it cannot come near the boundary before the horizon unless it
/// has a contact. For the others a wakeup is set, for when they may first matter.
class BoundaryWatch {
 public:
  using Wakeup = Wakeups::Wakeup;
  /// How far a point is outside the own block and those of the neighbors [L].
  struct Distances {
    double own;
    BlockDistances::Distances neighbors;
  };

  BoundaryWatch(const Partition& partition, DomainNumber domain, const Halo& halo, const Motion& motion)
      : block_(partition.block(domain)),
        least_half_gap_(block_.least_half_gap() * (1 - 0x1p-30)),
        largest_half_gap_(block_.largest_half_gap() * (1 + 0x1p-30)),
        neighbors_(partition.neighbors(domain, halo.neighborhood())),
        halo_(halo),
        gravity_(motion.gravity()),
        fall_(largest_component(motion.gravity())) {
    std::vector<Block> blocks;
    for (const DomainNumber neighbor : neighbors_) blocks.push_back(partition.block(neighbor));
    blocks_ = BlockDistances(blocks);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (block_.period(axis) > 0) least_period_ = std::min(least_period_, block_.period(axis));
    }
  }

  /// The neighbors of the domain, in the order of numbers: those whose blocks are in Halo::neighborhood.
  const std::vector<DomainNumber>& neighbors() const { return neighbors_; }
  /// The block of the domain.
  const Block& block() const { return block_; }
  const Halo& halo() const { return halo_; }
  /// How far a point inside the box is from the block and those of the neighbors. Cost: O(neighbors).
  Distances distances(const Vec3& point) const {
    Distances distances;
    distances.own = block_.distance(point);
    blocks_.find(point, distances.neighbors);
    return distances;
  }
  /// The neighbors whose halos hold a point, but for those in `held`, whose halos are deeper by the slack.
  NeighborSet holders_at(const Distances& point, NeighborSet held) const {
    NeighborSet holders = 0;
    for (std::size_t neighbor = 0; neighbor < neighbors_.size(); ++neighbor) {
      const bool is_held = (held >> neighbor & 1) != 0;
      if (point.neighbors[neighbor] <= (is_held ? halo_.outer() : halo_.depth))
        holders |= NeighborSet{1} << neighbor;
    }
    return holders;
  }
  /// The neighbors that are to hold a sphere at this point that none of them holds yet.
  NeighborSet holders_at(const Vec3& point) const {
    return block_.distance(point) < -halo_.outer() ? 0 : holders_at(distances(point), 0);
  }

  /// Whether a sphere that these neighbors hold is neither outside the block, nor must others hold it, nor
  /// one of them no longer, but for rounding.
  bool fits(const Distances& place, NeighborSet holders) const {
    const double tolerance = 1e-9 * halo_.depth;
    return place.own <= tolerance && nearest_not_held(place, holders) > halo_.depth - tolerance &&
           farthest_held(place, holders) <= halo_.outer() + tolerance;
  }

  /// The neighbor whose block is nearest. Precondition: there are neighbors.
  std::uint32_t nearest_neighbor(const Distances& point) const {
    const auto* const first = point.neighbors.begin();
    return static_cast<std::uint32_t>(std::min_element(first, first + neighbors_.size()) - first);
  }

  /// Begins to watch anew up to a horizon: a wakeup must be set for every own sphere.
  void restart(double now, double horizon) { wakeups_.restart(now, horizon); }
  /// Begins a window.
  void begin(double now) {
    begin_ = now;
    excursion_ = 0;
    far_since_ = std::numeric_limits<double>::infinity();
  }

  /// Whether a sphere at `point` has been and will be in the interior: it has come with this speed since
  /// `since`, and leaves with another.
  bool is_interior(const Vec3& point, double speed_before, double since, double speed_after,
                   double now) const {
    const double depth = -block_.distance(point) - halo_.outer();
    return depth > way(speed_before, now - std::max(begin_, since)) &&
           depth > way(speed_after, wakeups_.horizon() - now);
  }

  /// When the owner or the holders may change of a sphere that these neighbors hold: at once if they do where
  /// it is now [T].
  double time_of_change(const Distances& place, NeighborSet holders, const Vec3& velocity, double now) const {
    const double nearest = nearest_not_held(place, holders);
    const double farthest = farthest_held(place, holders);
    const bool is_due = place.own > 0 || nearest <= halo_.depth || farthest > halo_.outer();
    const double distance = std::min({-place.own, halo_.outer() - farthest, nearest - halo_.depth});
    // A sphere at rest does not pass even no distance.
    const double wait = is_due ? 0 : time_to_pass(distance, largest_component(velocity), fall_);
    return now + wait * (1 - 0x1p-30);
  }
  /// Sets a wakeup, if it is not beyond the horizon.
  void set_wakeup(const Wakeup& wakeup) {
    if (wakeup.time <= wakeups_.horizon()) wakeups_.set(wakeup);
  }
  void prefetch_wakeup(Slot slot) const { wakeups_.prefetch(slot); }
  /// Takes the wakeups up to a time.
  void take_wakeups(double until, std::vector<Wakeup>& taken) { wakeups_.take(until, taken); }

  /// Records a leg of an own sphere that these neighbors hold, and sends it to others that it may concern.
  /// `end` are the distances where it ends.
  void record(const Leg& leg, const Distances& end, NeighborSet holders, std::vector<Outbox>& outboxes) {
    const double begin = std::max(begin_, leg.begin);
    const double wait = leg.end - begin;
    const double speed = largest_component(leg.end_velocity) + fall_ * wait;
    const double longest = speed * wait;
    if (end.own + longest <= 0 && nearest_not_held(end, holders) - longest > halo_.depth) return;
    const Vec3 start = leg.end_position - wait * (leg.end_velocity - (0.5 * wait) * gravity_);
    // By how much a parabola leaves its chord.
    const double sag = fall_ * wait * wait / 8;
    const Distances from = distances(start);
    const double step = largest_component(leg.end_position - start);
    note_excursion(from.own + sag, end.own + sag, step, begin, wait);
    for (std::size_t neighbor = 0; neighbor < neighbors_.size(); ++neighbor) {
      if ((holders >> neighbor & 1) != 0) continue;
      // From farther away than a box, the nearest image of a block is not known.
      const double first = step > least_period_ ? end.neighbors[neighbor] - step : from.neighbors[neighbor];
      const double least = (first + end.neighbors[neighbor] - step) / 2 - sag;
      if (least <= halo_.depth) outboxes[neighbor].near_passes.push_back({begin, first, speed, least});
    }
  }

  /// How far own spheres have been beyond the block in this window [L].
  double excursion() const { return excursion_; }
  /// The time since when an own sphere has been so far away that it may have touched one that is not held
  /// [T].
  double far_since() const { return far_since_; }
  /// Within this distance of the block, spheres may have met own ones in this window [L].
  double guard() const { return (excursion_ + halo_.contact) * (1 + 0x1p-30); }
  /// When a pass may first have come within the guard [T]; infinity if it did not.
  double time_within_guard(const NearPass& pass) const {
    if (pass.least > guard()) return std::numeric_limits<double>::infinity();
    const double distance = pass.distance - guard();
    return distance > 0 ? pass.begin + distance / pass.speed * (1 - 0x1p-30) : pass.begin;
  }

  std::size_t memory_bytes() const { return wakeups_.memory_bytes(); }

 private:
  double way(double speed, double wait) const { return wait * (speed + 0.5 * wait * fall_); }

  double farthest_held(const Distances& point, NeighborSet holders) const {
    double farthest = -std::numeric_limits<double>::infinity();
    for (std::size_t neighbor = 0; neighbor < neighbors_.size(); ++neighbor) {
      if ((holders >> neighbor & 1) != 0) farthest = std::max(farthest, point.neighbors[neighbor]);
    }
    return farthest;
  }
  double nearest_not_held(const Distances& point, NeighborSet holders) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t neighbor = 0; neighbor < neighbors_.size(); ++neighbor) {
      if ((holders >> neighbor & 1) == 0) nearest = std::min(nearest, point.neighbors[neighbor]);
    }
    return nearest;
  }

  // Nothing is farther from the block than the distances at both ends and the step between them allow. If the
  // chord so stays nearer to the block than to its images, the distance along it is convex.
  void note_excursion(double first, double last, double step, double begin, double wait) {
    const double allowed = (first + last + step) / 2;
    const bool is_convex = allowed < least_half_gap_;
    const double most = is_convex ? std::max(first, last) : std::min(allowed, largest_half_gap_);
    excursion_ = std::max(excursion_, most);
    const double farthest = halo_.farthest();
    if (!(most > farthest)) return;
    const double rise = is_convex ? last - first : step;
    const double share = first < farthest ? (farthest - first) / rise * (1 - 0x1p-30) : 0;
    far_since_ = std::min(far_since_, begin + share * wait);
  }

  Block block_;
  // With room for rounding:
  double least_half_gap_;
  double largest_half_gap_;
  double least_period_ = std::numeric_limits<double>::infinity();
  std::vector<DomainNumber> neighbors_;
  BlockDistances blocks_;  // of the neighbors
  Halo halo_;
  Vec3 gravity_;
  double fall_;  // the largest component of gravity
  double begin_ = 0;
  double excursion_ = 0;
  double far_since_ = 0;
  Wakeups wakeups_;
};

}  // namespace hardball
