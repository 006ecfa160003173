// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "hardball/world/box.hpp"

namespace hardball {

/// Finds resting spheres near a place: what placement, the audit and measures of structure need, kept apart
/// from the broad phases so that it can check them.
///
/// Radii are sorted into levels by powers of two, each with its own hashed grid. Insert large spheres before
/// small ones: then a query costs O(1) per level, whatever the spread of radii.
class Neighborhood {
 public:
  /// `capacity` is the number of spheres to come, `largest_radius` [L] bounds their radii.
  Neighborhood(const Box& box, std::size_t capacity, double largest_radius);

  /// Adds a sphere; its index is the number of spheres inserted before. `center` lies inside a periodic box.
  void insert(const Vec3& center, double radius);

  /// Calls visit(index, separation, reach) once for every sphere or periodic copy that may touch the sphere
  /// given, and perhaps for others close by; `separation` [L] points from `center` to it, `reach` [L] is the
  /// sum of radii. The order depends on that of insertion alone.
  template <class Visit>
  void for_each_near(const Vec3& center, double radius, Visit&& visit) const {
    for (const Level& level : levels_) {
      if (level.head.empty()) continue;
      const double margin = (radius + level.largest_radius) * (1 + 1e-9);
      const Cell low = cell_at(level, center - Vec3{margin, margin, margin});
      const Cell high = cell_at(level, center + Vec3{margin, margin, margin});
      for (std::int64_t x = low[0]; x <= high[0]; ++x) {
        const Folded in_x = fold(x, level.count[0]);
        for (std::int64_t y = low[1]; y <= high[1]; ++y) {
          const Folded in_y = fold(y, level.count[1]);
          const std::uint64_t column = mix(mix(0, in_x.index), in_y.index);
          for (std::int64_t z = low[2]; z <= high[2]; ++z) {
            const Folded in_z = fold(z, level.count[2]);
            const std::uint64_t key = mix(column, in_z.index);
            std::uint32_t i = level.head[bucket(level, key)];
            if (i == kNone) continue;
            const Vec3 shift = box_.shift({{in_x.boxes, in_y.boxes, in_z.boxes}});
            for (; i != kNone; i = next_[i]) {
              const Resting& sphere = spheres_[i];
              if (sphere.cell != key) continue;
              visit(i, (sphere.center - center) + shift, radius + sphere.radius);
            }
          }
        }
      }
    }
  }

 private:
  using Cell = std::array<std::int64_t, kAxes>;
  struct Level {
    double largest_radius = 0;
    Vec3 edge;
    std::array<std::int64_t, kAxes> count{};  // cells along a periodic axis, zero along the others
    std::vector<std::uint32_t> head;          // per bucket: the sphere inserted last, or kNone
  };
  struct Resting {
    Vec3 center;
    double radius;
    std::uint64_t cell;  // the key of its cell: cells share buckets, and none may be found twice
  };
  static constexpr std::uint32_t kNone = UINT32_MAX;

  // A cell along one axis, folded into a periodic box from so many boxes away.
  struct Folded {
    std::int64_t index;
    std::int32_t boxes;
  };

  Cell cell_at(const Level& level, const Vec3& place) const;
  static Folded fold(std::int64_t index, std::int64_t count) {
    if (count == 0 || (index >= 0 && index < count)) return {index, 0};
    const std::int64_t boxes = index >= 0 ? index / count : -((count - 1 - index) / count);
    return {index - boxes * count, static_cast<std::int32_t>(boxes)};
  }
  // Three of these in a row make the key of a cell: 64 bits, alike for two cells once in 10^19 times.
  static std::uint64_t mix(std::uint64_t key, std::int64_t index) {
    key = (key ^ static_cast<std::uint64_t>(index)) * 0x9e3779b97f4a7c15;
    return key ^ (key >> 32);
  }
  static std::size_t bucket(const Level& level, std::uint64_t key) { return key & (level.head.size() - 1); }
  Level& level_for(double radius);

  Box box_;
  std::size_t capacity_;
  std::vector<Level> levels_;
  std::vector<Resting> spheres_;
  std::vector<std::uint32_t> next_;  // the next sphere in the same bucket
};

}  // namespace hardball
