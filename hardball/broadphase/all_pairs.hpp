// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/broadphase/sphere_lines.hpp"

namespace hardball {

/// Every sphere is a candidate of every other: the oracle against which the other broad phases are tested.
///
/// Along periodic axes a sphere's region is an interval of a quarter box to either side of where it was when
/// the region was made; it determines which images of the other spheres it can meet before it leaves the
/// interval, or those of a sheared box have slid by as much. Cost: O(n) per collision.
class AllPairs final : public BroadPhase {
 public:
  /// The settings do not matter: there is nothing to set.
  explicit AllPairs(const PhaseSettings& = {}) : BroadPhase({.kind = PhaseKind::all_pairs}) {}

  static bool supports(const World&, double) { return true; }
  std::unique_ptr<BroadPhase> clone() const override { return std::make_unique<AllPairs>(*this); }
  PhaseLengths lengths() const override { return {}; }

  void build(const World& world, const Time& now, CompactPaths& copies) override;
  void update(const World& world, Slot slot, const Time& now, const Image& folded) override;
  bool keeps(const World&, Slot, const Time&, const CompactPaths&) const override { return true; }
  bool admits(const World&, Slot) const override { return true; }
  void insert(const World& world, Slot slot, const Time& now, const CompactPaths&) override;
  void erase(Slot) override {}
  void move(Slot from, Slot to) override {
    lines_[to] = lines_[from];
    middles_[to] = middles_[from];
    slid_[to] = slid_[from];
  }
  void collect_overlapping(const World& world, Slot slot, Candidates& candidates) const override {
    collect(world, slot, candidates);
  }
  void collect(const World& world, Slot slot, Candidates& candidates) const override;
  double next_crossing(const World& world, Slot slot, const Time& now, const CompactPaths&) override;
  bool are_candidates(Slot, Slot) const override { return true; }
  bool uses_minimum_image() const override { return false; }
  void cross(const World& world, Slot slot, const Time& now, const CompactPaths&,
             Candidates& candidates) override;
  std::size_t cached_spheres() const override { return SIZE_MAX; }
  void prefetch_lists(Slot, bool) const override {}
  void prefetch_candidates(Slot, bool, const CompactPaths&) const override {}
  std::uint64_t left_count() const override { return 0; }
  std::size_t memory_bytes() const override {
    return lines_.capacity() * sizeof(lines_[0]) + middles_.capacity() * sizeof(Vec3) +
           slid_.capacity() * sizeof(double);
  }
  void validate(const World& world, const Time& now, const CompactPaths&) const override;

 private:
  struct Images {
    Image low;
    Image high;
  };

  Images images_within_reach(const World& world, Slot slot, Slot other) const;
  void shift_along_x(const World& world, Slot slot, Slot other, std::int32_t above, Images& images) const;
  void center_interval(const World& world, Slot slot, const Time& now);

  LargeVector<Vec3> middles_;  // of the intervals
  LargeVector<double> slid_;   // by how much the image above was displaced when the region was made
};

}  // namespace hardball
