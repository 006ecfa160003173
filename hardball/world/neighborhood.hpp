// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "hardball/world/box.hpp"

namespace hardball {

/// Finds resting spheres near a place: what placement and the audit need, kept apart from the broad phases so
/// that it can check them.
///
/// Radii are sorted into levels by powers of two, each with its own hashed grid. Insert large spheres before
/// small ones: then a query costs O(1) per level, whatever the spread of radii.
class Neighborhood {
 public:
  /// `capacity` is the number of spheres to come, `largest_radius` [L] bounds their radii.
  Neighborhood(const Box& box, std::size_t capacity, double largest_radius);

  /// Adds a sphere; its index is the number of spheres inserted before. `center` lies inside a periodic box.
  void insert(const Vec3& center, double radius);

  /// Calls visit(index, separation, reach) for every sphere or periodic copy that may touch the sphere given,
  /// and perhaps for others close by; `separation` [L] points from `center` to it, `reach` [L] is the sum of
  /// radii.
  template <class Visit>
  void for_each_near(const Vec3& center, double radius, Visit&& visit) const {
    for (const Level& level : levels_) {
      if (level.head.empty()) continue;
      const double margin = (radius + level.largest_radius) * (1 + 1e-9);
      const Cell low = cell_at(level, center - Vec3{margin, margin, margin});
      const Cell high = cell_at(level, center + Vec3{margin, margin, margin});
      for (std::int64_t x = low[0]; x <= high[0]; ++x) {
        for (std::int64_t y = low[1]; y <= high[1]; ++y) {
          for (std::int64_t z = low[2]; z <= high[2]; ++z) {
            Cell cell{x, y, z};
            const Vec3 shift = box_.shift(fold(level, cell));
            for (std::uint32_t i = level.head[bucket(level, cell)]; i != kNone; i = next_[i]) {
              visit(i, (spheres_[i].center - center) + shift, radius + spheres_[i].radius);
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
  };
  static constexpr std::uint32_t kNone = UINT32_MAX;

  Cell cell_at(const Level& level, const Vec3& place) const;
  static Image fold(const Level& level, Cell& cell);
  static std::size_t bucket(const Level& level, const Cell& cell);
  Level& level_for(double radius);

  Box box_;
  std::size_t capacity_;
  std::vector<Level> levels_;
  std::vector<Resting> spheres_;
  std::vector<std::uint32_t> next_;  // the next sphere in the same bucket
};

}  // namespace hardball
