// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "hardball/kernels/bound_kernel.hpp"
#include "hardball/memory/prefetch.hpp"
#include "hardball/standard/bit_cast.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// A compact copy of every path, from which contact times are bounded four or eight at a time: of thirty
/// pairs considered one meets, and for the others a bound will do.
///
/// A center is an integer, in steps of a grid that divides periodic boxes evenly, so that differences modulo
/// 2^32 lead to the nearest image. Lengths, speeds and times are scaled by powers of two that make the
/// distance of candidates and the greatest speed about one. A copy is made whenever a path changes, and at
/// any other time: bounds are true as long as the sphere has since moved no farther than the greatest
/// distance of candidates. In a sheared box a copy is of the image in the box.
/// Source: docs/bounds.md, with the proof.
class CompactPaths {
 public:
  /// Copies all paths at `now`, where candidates are at most `farthest` [L] apart, and spheres move no
  /// farther before they are copied again. Cost: O(n).
  void reset(const World& world, double farthest, const Time& now);
  /// Copies all paths at `now` in a sheared box. There the broad phase does not keep spheres from moving
  /// farther than `most_moved` [L]; copies expire instead. Precondition: `farthest` is at least
  /// least_farthest(), and at least `most_moved`; half of the shortest period is more than `most_moved` and
  /// the distance of candidates.
  void reset(const World& world, double farthest, double most_moved, const Time& now);
  /// The distance at which the heights of a sheared box fit into the ring of integers [L].
  static double least_farthest(const Box& box);
  /// Makes room for one more sphere, or for one of another radius, and copies its path at `now`. Cost: O(1)
  /// amortized.
  void insert(const World& world, Slot slot, const Time& now);
  /// Moves the copy of a sphere to another slot. The revisions of the slots stay.
  void move(Slot from, Slot to);
  /// Whether speeds have changed, or units were chosen long ago: then `renew` pays.
  bool are_outdated() const { return unbounded_ > most_unbounded_ || copies_ > most_copies_; }
  /// Copies all paths again, as reset() does, with the distance given to reset().
  void renew(const World& world, const Time& now) { reset(world, farthest_, most_moved_, now); }

  /// Copies one path as it is at `now`.
  void copy(const World& world, Slot slot, const Time& now) {
    State state = world.motion().state_at(world.path(slot), now);
    if (!(state.position.y >= lowest_in_box_ && state.position.y <= highest_in_box_)) [[unlikely]]
      fold(state, world.box(), now);
    copy(slot, now, state);
  }

  /// Whether the last copy says anything of the contacts of the sphere.
  bool is_bounded(Slot slot) const { return !std::isnan(paths_[slot].velocity[0]); }

  /// Records that a path has changed; returns its new revision.
  std::uint32_t note_change(Slot slot) {
    paths_[slot].revision += kRevision;
    return revision(slot);
  }
  /// How often a path has changed, modulo 2^29, times kRevision.
  std::uint32_t revision(Slot slot) const { return paths_[slot].revision & ~(kRevision - 1); }
  /// One revision: three bits remain for other purposes.
  static constexpr std::uint32_t kRevision = CompactPath::kRadii;

  /// How long the copy of any moving sphere is good [T]; zero if that depends on the sphere.
  double longest_age() const { return longest_age_of_all_; }
  /// Whether the copy of one sphere is certainly good for this time [T].
  bool is_good_for(Slot slot, double time) const {
    const auto& v = paths_[slot].velocity;
    const auto per_speed = static_cast<float>(time * per_most_moved_);
    return (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) * (per_speed * per_speed) < 1 && !scale_.has_gravity &&
           time < longest_age_;
  }
  /// How long that of one sphere is [T].
  double longest_age(Slot slot) const {
    return scale_.has_gravity || scale_.has_shear ? longest_age_of(slot) : longest_age_;
  }

  /// What radii are at a moment, over the largest of the epoch, rounded up [1].
  float size_at(double moment) const {
    if (!scale_.has_growth) [[likely]]
      return 1;
    constexpr double kRoundedUp = 1 + 0x1p-22;
    return static_cast<float>(growth_.scale_at(Time(moment)) * per_scale_ * kRoundedUp);
  }

  /// By how much the image above is displaced along x at a moment, in steps modulo 2^32; zero without shear.
  std::int32_t slide_at(const Time& moment) const {
    if (!scale_.has_shear) [[likely]]
      return 0;
    constexpr double kFewBoxes = 16;
    const double slid = images_.speed() * duration(epoch_, moment);
    const bool is_near = std::fabs(slid) <= kFewBoxes * box_width_;
    return steps_along_x(is_near ? slid_at_epoch_ + slid : images_.displacement_in_box(moment));
  }
  /// How fast it moves along x [L/T].
  double slide_speed() const { return images_.speed(); }
  /// A speed [L/T] in units of the compact paths.
  float in_units(double speed) const { return static_cast<float>(speed * per_speed_); }
  /// A distance along x in steps, modulo 2^32. Precondition: it is a few boxes at most.
  std::int32_t steps_along_x(double distance) const { return to_integer(distance * steps_per_length_.x); }

  /// The distance given to reset() [L].
  double farthest() const { return farthest_; }

  /// By slot.
  std::span<const CompactPath> paths() const { return paths_; }
  const BoundScale& scale() const { return scale_; }
  /// The grid [1/L], by axis.
  const Vec3& steps_per_length() const { return steps_per_length_; }
  /// The units of the compact paths [L], [T].
  double length_unit() const { return length_unit_; }
  double time_unit() const { return time_unit_; }
  /// The largest radii of the epoch by slot, in units, rounded up; null if all are `radius(0)`.
  const float* radii() const { return radii_.empty() ? nullptr : radii_.data(); }
  /// Radii by slot for bounds, as radii() returns them; null if scale() has all.
  const float* radii_for_bounds() const { return are_radii_few_ ? nullptr : radii(); }
  float radius(Slot slot) const {
    return are_radii_few_ ? scale_.radii[paths_[slot].revision % CompactPath::kRadii] : radii_[slot];
  }
  /// From a point to the position of a copy along an axis: the nearest image [L].
  double apart(const std::array<std::int32_t, 3>& from, Slot slot, std::size_t axis) const {
    const auto steps =
        static_cast<std::uint32_t>(paths_[slot].position[axis]) - static_cast<std::uint32_t>(from[axis]);
    return static_cast<std::int32_t>(steps) * step_[axis];
  }

  void prefetch(Slot slot) const { hardball::prefetch(&paths_[slot]); }
  std::size_t memory_bytes() const {
    return paths_.capacity() * sizeof(CompactPath) + radii_.capacity() * sizeof(float);
  }

 private:
  // Beyond, adding the pusher of to_integer loses digits.
  static constexpr double kMaxTicks = 0x1p50;

  // The nearest integer, modulo 2^32. Precondition: |number| < 2^51.
  static std::int32_t to_integer(double number) {
    constexpr double kPusher = 0x1.8p52;
    return static_cast<std::int32_t>(bit_cast<std::int64_t>(number + kPusher));
  }

  void choose_units(const World& world);
  void copy_radii(const World& world);
  void copy_radius(Slot slot, double radius);
  double longest_age_of(Slot slot) const;
  void fold(State& state, const Box& box, const Time& now) const;
  HARDBALL_ALWAYS_INLINE void copy(Slot slot, const Time& now, const State& state) {
    const auto& [position, v] = state;
    const double ticks = duration(epoch_, now) * ticks_per_time_;
    const double speed_squared = dot(v, v);
    CompactPath& copy = paths_[slot];
    copy.store({to_integer(position.x * steps_per_length_.x), to_integer(position.y * steps_per_length_.y),
                to_integer(position.z * steps_per_length_.z)},
               to_integer(ticks),
               {static_cast<float>(v.x * per_speed_), static_cast<float>(v.y * per_speed_),
                static_cast<float>(v.z * per_speed_)});
    ++copies_;
    squares_ += speed_squared;
    if (std::fabs(position.x) <= farthest_position_.x && std::fabs(position.y) <= farthest_position_.y &&
        std::fabs(position.z) <= farthest_position_.z && std::fabs(ticks) <= kMaxTicks &&
        speed_squared <= greatest_speed_squared_) [[likely]]
      return;
    note_unbounded(copy, position);
  }
  void note_unbounded(CompactPath& copy, const Vec3& position);

  LargeVector<CompactPath> paths_;  // by slot, also of slots that are not in use any more
  LargeVector<float> radii_;        // by slot, in units, rounded up; empty if all are alike
  BoundScale scale_;
  bool are_radii_few_ = true;
  std::size_t kinds_ = 1;  // of radii in the scale
  double per_speed_ = 1;
  double farthest_ = 1;
  double most_moved_ = 1;
  double per_most_moved_ = 1;  // its reciprocal, rounded up, times the unit of speed [1/T]
  double length_unit_ = 1;
  double time_unit_ = 1;
  double ticks_per_time_ = 1;
  double longest_age_ = 0;  // at which ticks overflow
  double longest_age_of_all_ = 0;
  Vec3 step_;  // of the grid [L]
  Vec3 steps_per_length_;
  Vec3 farthest_position_;
  double greatest_speed_squared_ = 0;
  Time epoch_;
  Growth growth_;
  // Copies are of the image with a height between these; infinite unless the box is sheared.
  double lowest_in_box_ = 0;
  double highest_in_box_ = 0;
  // Of a sheared box:
  SlidingImages images_;
  double box_width_ = 0;
  double slid_at_epoch_ = 0;  // by the image above
  double per_scale_ = 1;      // of the growth, at its largest
  // Since units were chosen:
  std::uint64_t copies_ = 0;
  std::uint64_t unbounded_ = 0;  // copies that say nothing, of spheres too fast or too far away
  double squares_ = 0;           // of speeds: the sum over all copies
  std::uint64_t most_copies_ = 0;
  std::uint64_t most_unbounded_ = 0;
};

}  // namespace hardball
