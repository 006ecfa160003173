// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/broadphase/sphere_lines.hpp"

namespace hardball {

/// Every sphere is a candidate of every other: the oracle against which the other broad phases are tested.
///
/// Along periodic axes a sphere's region is an interval of a quarter box to either side of where it was when
/// the region was made; it determines which images of the other spheres it can meet before it leaves the
/// interval, or those of a sheared box have slid by as much. Cost: O(n) per collision.
class AllPairs : public WithSphereLines<Vec3> {  // the middles of the intervals
 public:
  /// There is nothing to set.
  explicit AllPairs(const PhaseSettings& = {}) {}

  static bool supports(const World&, double) { return true; }
  PhaseLengths lengths() const { return {}; }

  void build(const World& world, const Time& now, CompactPaths& copies);
  void refresh(const World& world, Slot slot, const Time& now, const Image& folded);
  bool keeps(const World&, Slot, const Time&, const CompactPaths&) const { return true; }
  bool admits(const World&, Slot) const { return true; }
  void insert(const World& world, Slot slot, const Time& now, const CompactPaths&);
  void erase(Slot) {}
  void move(Slot from, Slot to) {
    lines_[to] = lines_[from];
    slid_[to] = slid_[from];
  }
  void collect_overlapping(const World& world, Slot slot, Candidates& candidates) const {
    collect(world, slot, candidates);
  }
  void collect(const World& world, Slot slot, Candidates& candidates) const;
  double next_crossing(const World& world, Slot slot, const Time& now, const CompactPaths&) const;
  bool are_candidates(Slot, Slot) const { return true; }
  bool uses_minimum_image() const { return false; }
  void cross(const World& world, Slot slot, const Time& now, const CompactPaths&, Candidates& candidates);
  static constexpr std::size_t kCachedSpheres = SIZE_MAX;
  void prefetch_region(Slot) const {}
  void prefetch_lists(Slot, bool) const {}
  void prefetch_candidates(Slot, bool, const CompactPaths&) const {}
  std::uint64_t left_count() const { return 0; }
  std::size_t memory_bytes() const {
    return lines_.capacity() * sizeof(lines_[0]) + slid_.capacity() * sizeof(double);
  }
  void validate(const World& world, const Time& now, const CompactPaths&) const;

 private:
  struct Images {
    Image low;
    Image high;
  };

  Images images_within_reach(const World& world, Slot slot, Slot other) const;
  void shift_along_x(const World& world, Slot slot, Slot other, std::int32_t above, Images& images) const;
  void center_interval(const World& world, Slot slot, const Time& now);

  LargeVector<double> slid_;  // by how much the image above was displaced when the region was made
};

static_assert(BroadPhase<AllPairs>);

}  // namespace hardball
