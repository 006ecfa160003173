// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"

namespace hardball {

/// Every sphere is a candidate of every other: the oracle against which the others are tested.
///
/// Along periodic axes a sphere's region is a stretch of a quarter box to either side of where it was when
/// the region was made; it tells which copies of the other spheres it can meet before it leaves the stretch.
/// Cost: O(n) per collision.
class AllPairs {
 public:
  void build(const World& world, const Time& now);
  void refresh(const World& world, Slot slot, const Time& now, const Image& folded);
  Time next_crossing(Slot slot) const { return stretches_[slot].crossing; }
  std::uint64_t left_count() const { return 0; }
  std::size_t memory_bytes() const { return stretches_.capacity() * sizeof(Stretch); }
  void validate(const World& world, const Time& now) const;

  template <class Visit>
  void for_each_candidate(const World& world, Slot slot, Visit&& visit) const {
    for (Slot other = 0; other < world.size(); ++other) {
      if (other == slot) continue;
      const Images images = images_within_reach(world, slot, other);
      Image image;
      for (image[0] = images.low[0]; image[0] <= images.high[0]; ++image[0]) {
        for (image[1] = images.low[1]; image[1] <= images.high[1]; ++image[1]) {
          for (image[2] = images.low[2]; image[2] <= images.high[2]; ++image[2]) visit(other, image);
        }
      }
    }
  }

  template <class Visit>
  void cross(const World& world, Slot slot, const Time& now, Visit&& visit) {
    center_stretch(world, slot, now);
    for_each_candidate(world, slot, visit);
  }

 private:
  struct Stretch {
    Vec3 middle;
    Time crossing = kNever;
  };
  struct Images {
    Image low;
    Image high;
  };

  Images images_within_reach(const World& world, Slot slot, Slot other) const;
  void center_stretch(const World& world, Slot slot, const Time& now);

  std::vector<Stretch> stretches_;
};

static_assert(BroadPhase<AllPairs>);

}  // namespace hardball
