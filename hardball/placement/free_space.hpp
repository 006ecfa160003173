// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "hardball/memory/huge_pages.hpp"
#include "hardball/memory/prefetch.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/placement/region.hpp"
#include "hardball/world/box.hpp"

namespace hardball {

/// Where among resting spheres the center of one more may lie, for placement: a region divided into voxels,
/// some of which are known to have no room.
///
/// A voxel is excluded if a single sphere leaves no room in it. The others may have room or not, so that a
/// center drawn from them must still be tested; drawn uniformly from them and accepted if there is room, it
/// is uniform among all centers with room. Voxels in which centers are refused are divided until most of
/// their volume has room. Source: Brosilow, Ziff and Vigil, Phys. Rev. A 43 (1991) 631; Zhang and Torquato,
/// Phys. Rev. E 88 (2013) 053312.
class FreeSpace {
 public:
  /// For the centers of spheres of at least this radius [L] in `centers`, which spans the box along periodic
  /// axes. At first the edges of voxels are no shorter than `finest_edge` [L], and there are no more than
  /// `most_voxels`.
  FreeSpace(const Box& box, const Region& centers, double least_radius, double finest_edge,
            std::size_t most_voxels);

  double least_radius() const { return least_radius_; }

  /// Excludes the voxels in which a resting sphere leaves no room. Precondition: the voxels are not listed.
  void exclude(const Vec3& center, double radius);

  /// Whether the voxel of a center in the region is excluded. Precondition: the voxels are not listed.
  bool is_excluded(const Vec3& center) const {
    const auto [x, y, z] = voxel_of(center);
    return is_excluded(x, y, z);
  }
  /// Prefetches what is_excluded(center) reads.
  void prefetch(const Vec3& center) const {
    const auto [x, y, z] = voxel_of(center);
    hardball::prefetch(&excluded_[byte_at(x >> 3, y, z)]);
  }

  /// Lists the voxels that are not excluded.
  void list();
  bool is_listed() const { return is_listed_; }
  bool is_empty() const;

  /// A center drawn from the listed voxels, and the one that it lies in.
  struct Draw {
    Vec3 center;
    std::size_t level;
    std::size_t index;
  };
  /// Precondition: the list is not empty.
  Draw draw(Random& random) const;

  /// A resting sphere that overlaps one at the center drawn.
  struct Overlap {
    Vec3 separation;  ///< From the center drawn to its own [L].
    double radius;    ///< [L]
  };
  /// Whether the sphere leaves no room in the voxel of a refused center.
  bool covers(const Draw& draw, const Overlap& overlap) const;
  /// Takes the voxel of a refused center from the list, or the parts of it in which this sphere leaves no
  /// room.
  void refine(const Draw& draw, const Overlap& overlap);

 private:
  // Counted from the low end of the region, in edges of its level.
  using Voxel = std::array<std::uint32_t, kAxes>;

  // The smallest distance at which a sphere excludes a center for certain, whatever is rounded.
  double certain_reach(double radius) const {
    return (radius + least_radius_) * (1 - kRelativeMargin) - margin_;
  }
  bool covers(const Voxel& voxel, std::size_t level, const Vec3& center, const Overlap& overlap) const;
  // The number of a voxel along an axis, folded into a periodic box.
  std::int64_t folded(std::int64_t index, std::size_t axis) const {
    while (index < 0) index += count_[axis];
    while (index >= count_[axis]) index -= count_[axis];
    return index;
  }
  std::array<std::int64_t, kAxes> voxel_of(const Vec3& center) const {
    std::array<std::int64_t, kAxes> voxel;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const auto at = static_cast<std::int64_t>((center[axis] - low_[axis]) * inverse_edge_[axis]);
      voxel[axis] = std::clamp(at, std::int64_t{0}, count_[axis] - 1);
    }
    return voxel;
  }
  // The voxels are in blocks of 8 x 8 x 8, one cache line each, since those near each other are needed
  // together. A byte holds eight in a row; this is the one of the row that is `x` blocks from the low end.
  std::size_t byte_at(std::int64_t x, std::int64_t y, std::int64_t z) const {
    const std::int64_t block = ((z >> 3) * blocks_[1] + (y >> 3)) * blocks_[0] + x;
    return static_cast<std::size_t>(64 * block + 8 * (z & 7) + (y & 7));
  }
  // Excludes the voxels of a row from `begin` to before `end`.
  void exclude_row(std::int64_t y, std::int64_t z, std::int64_t begin, std::int64_t end);
  void exclude_part(std::int64_t y, std::int64_t z, std::int64_t begin, std::int64_t end);
  bool is_excluded(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return (excluded_[byte_at(x >> 3, y, z)] >> (x & 7) & 1) != 0;
  }
  double part_of_volume(std::size_t level) const;
  Vec3 edge_at(std::size_t level) const;

  // Halved so often, the edge of a voxel no longer matters, and its number fits in 32 bits.
  static constexpr std::size_t kLevels = 12;
  static constexpr std::int64_t kMaxAlongAxis = std::int64_t{1} << 20;
  static constexpr double kRelativeMargin = 1e-9;

  std::uint32_t parts_;  // into which a voxel is divided: eight, or four in two dimensions
  double least_radius_;
  double margin_ = 0;  // [L]
  Vec3 low_;
  std::array<std::int64_t, kAxes> count_{};
  std::array<bool, kAxes> is_periodic_{};
  Vec3 edge_;
  Vec3 inverse_edge_;                         // zero where the region has no width
  std::array<std::int64_t, kAxes> blocks_{};  // along each axis
  LargeVector<std::uint8_t> excluded_;        // a bit for each voxel
  bool is_listed_ = false;
  std::array<std::vector<Voxel>, kLevels> listed_;  // by level: each has half the edge of the one before
};

}  // namespace hardball
