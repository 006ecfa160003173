// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/memory/huge_pages.hpp"
#include "hardball/memory/prefetch.hpp"
#include "hardball/world/box.hpp"

namespace hardball {

/// Finds resting spheres near a point, for placement, the audit and measures of structure. It shares nothing
/// with the broad phases, so that it can check them.
///
/// Radii are sorted into levels by powers of two, each with its own hashed grid. Insert large spheres before
/// small ones: then a query costs O(1) per level, whatever the spread of radii.
class StaticHashGrid {
 public:
  /// `capacity` is the number of spheres that will be inserted, `largest_radius` [L] bounds their radii. The
  /// images of a sheared box are those of `moment`.
  StaticHashGrid(const Box& box, std::size_t capacity, double largest_radius, const Time& moment = Time(0));

  /// Adds a sphere; its index is the number of spheres inserted before. `center` lies inside a periodic box.
  void insert(const Vec3& center, double radius);

  /// How many spheres have been inserted.
  std::size_t size() const { return spheres_.size(); }

  /// Calls visit(center, radius) for every sphere, in the order of insertion.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (const Resting& sphere : spheres_) visit(sphere.center, sphere.radius);
  }

  /// Calls visit(index, separation, reach) once for every sphere or periodic image that may touch the given
  /// sphere, and perhaps for others nearby; `separation` [L] points from `center` to it, `reach` [L] is the
  /// sum of the radii. The order of visits depends only on the order of insertion. Precondition: no more than
  /// a million images of the box are within reach. Cost: that of visiting each sphere in each image, at most.
  template <class Visit>
  void for_each_near(const Vec3& center, double radius, Visit&& visit) const {
    for (const Level& level : levels_) {
      if (level.buckets.empty()) continue;
      const auto go_on = [&visit](std::uint32_t index, const Vec3& separation, double reach) {
        visit(index, separation, reach);
        return false;
      };
      is_any_layer(level, center, radius, [&](const Cells& cells, const Vec3& seen_from) {
        return are_too_many(cells) ? search_all(level, cells, seen_from, radius, go_on)
                                   : search(level, cells, seen_from, radius, go_on);
      });
    }
  }

  /// Whether predicate(index, separation, reach) holds for any of them. Cost: if it does, less than that of
  /// visiting all.
  template <class Predicate>
  bool is_any_near(const Vec3& center, double radius, Predicate&& predicate) const {
    for (const Level& level : levels_) {
      if (level.buckets.empty()) continue;
      const Cell own = cell_at(level, center);  // the likeliest
      if (search(level, {own, own}, center, radius, predicate)) return true;
      const bool is_near = is_any_layer(level, center, radius, [&](const Cells& near, const Vec3& seen_from) {
        fetch(level, near);
        return search(level, near, seen_from, radius, predicate);
      });
      if (is_near) return true;
    }
    return false;
  }

 private:
  using Cell = std::array<std::int64_t, kAxes>;
  static constexpr std::uint32_t kNone = UINT32_MAX;
  static constexpr std::size_t kFetched = 27;  // cells
  // Cells share buckets. The tags usually show that a cell is empty without a visit to the spheres of others.
  struct Bucket {
    std::uint32_t last = kNone;  // the sphere inserted last
    std::uint32_t tags = 0;      // a bit for the tag of each cell in it
  };
  struct Level {
    double largest_radius = 0;
    Vec3 edge;
    std::array<std::int64_t, kAxes> count{};  // cells along a periodic axis, zero along the others
    LargeVector<Bucket> buckets;              // a power of two, or none while the level is empty
  };
  struct Resting {
    Vec3 center;
    double radius;
    std::uint64_t cell;  // the key of its cell, since cells share buckets
    std::uint32_t next;  // the sphere inserted before it into the same bucket, or kNone
  };
  struct Cells {
    Cell low;
    Cell high;
  };

  // The index of a cell along one axis, folded into a periodic box by `boxes` boxes.
  struct Folded {
    std::int64_t index;
    std::int32_t boxes;
  };

  // Whether search(cells, seen_from) holds for the cells near a point, or in a sheared box for any layer of
  // images of the box, as seen from a point that is displaced as they are.
  template <class Search>
  bool is_any_layer(const Level& level, const Vec3& center, double radius, Search&& search) const {
    const Cells near = cells_near(level, center, radius);
    if (!box_.is_sheared()) return search(near, center);
    const std::int64_t rows = level.count[1];
    for (std::int32_t above = fold(near.low[1], rows).boxes; above <= fold(near.high[1], rows).boxes;
         ++above) {
      const Vec3 seen_from = center - Vec3{above * slid_, 0, 0};
      Cells cells = cells_near(level, seen_from, radius);
      cells.low[1] = std::max(cells.low[1], above * rows);
      cells.high[1] = std::min(cells.high[1], above * rows + rows - 1);
      if (search(cells, seen_from)) return true;
    }
    return false;
  }

  // Whether predicate(index, separation, reach) holds for any sphere in these cells of a level.
  template <class Predicate>
  bool search(const Level& level, const Cells& cells, const Vec3& center, double radius,
              Predicate&& predicate) const {
    const Bucket* const buckets = level.buckets.data();
    const std::uint64_t mask = level.buckets.size() - 1;
    const std::array<std::int64_t, kAxes> count = level.count;
    for (std::int64_t x = cells.low[0]; x <= cells.high[0]; ++x) {
      const Folded in_x = fold(x, count[0]);
      for (std::int64_t y = cells.low[1]; y <= cells.high[1]; ++y) {
        const Folded in_y = fold(y, count[1]);
        const std::uint64_t column = column_key(in_x.index, in_y.index);
        for (std::int64_t z = cells.low[2]; z <= cells.high[2]; ++z) {
          const Folded in_z = fold(z, count[2]);
          const std::uint64_t key = cell_key(column, in_z.index);
          const Bucket& bucket = buckets[key & mask];
          if ((bucket.tags & tag(key)) == 0) continue;
          const Vec3 shift = box_.shift({{in_x.boxes, in_y.boxes, in_z.boxes}});
          for (std::uint32_t i = bucket.last; i != kNone; i = spheres_[i].next) {
            const Resting& sphere = spheres_[i];
            if (sphere.cell != key) continue;
            if (predicate(i, (sphere.center - center) + shift, radius + sphere.radius)) return true;
          }
        }
      }
    }
    return false;
  }

  // Whether it takes less time to visit all spheres than these cells, most of which must be empty.
  bool are_too_many(const Cells& cells) const {
    constexpr double kFew = 1e6;
    constexpr double kEach = 64;
    double count = 1;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      count *= static_cast<double>(cells.high[axis] - cells.low[axis]) + 1;
    }
    return count > kFew + kEach * static_cast<double>(spheres_.size());
  }

  // Searches by visiting all spheres of the level in each box that these cells lie in.
  template <class Predicate>
  bool search_all(const Level& level, const Cells& cells, const Vec3& center, double radius,
                  Predicate&& predicate) const {
    constexpr double kMaxBoxes = 8e6;
    double boxes = 1;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (level.count[axis] == 0) continue;
      boxes *= static_cast<double>((cells.high[axis] - cells.low[axis]) / level.count[axis]) + 2;
    }
    HARDBALL_CHECK(boxes <= kMaxBoxes);
    Image low;
    Image high;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      low[axis] = fold(cells.low[axis], level.count[axis]).boxes;
      high[axis] = fold(cells.high[axis], level.count[axis]).boxes;
    }
    Image image;
    for (image[0] = low[0]; image[0] <= high[0]; ++image[0]) {
      for (image[1] = low[1]; image[1] <= high[1]; ++image[1]) {
        for (image[2] = low[2]; image[2] <= high[2]; ++image[2]) {
          const Vec3 shift = box_.shift(image);
          for (std::uint32_t i = 0; i < spheres_.size(); ++i) {
            const Resting& sphere = spheres_[i];
            if (&levels_[level_for(sphere.radius)] != &level) continue;
            if (predicate(i, (sphere.center - center) + shift, radius + sphere.radius)) return true;
          }
        }
      }
    }
    return false;
  }

  // Fetches the spheres in these cells of a level from memory, all at a time rather than one after another.
  void fetch(const Level& level, const Cells& cells) const {
    const std::uint64_t mask = level.buckets.size() - 1;
    std::array<std::uint64_t, kFetched> keys;
    std::size_t count = 0;
    for (std::int64_t x = cells.low[0]; x <= cells.high[0]; ++x) {
      for (std::int64_t y = cells.low[1]; y <= cells.high[1]; ++y) {
        const std::uint64_t column = column_key(fold(x, level.count[0]).index, fold(y, level.count[1]).index);
        for (std::int64_t z = cells.low[2]; z <= cells.high[2] && count < kFetched; ++z, ++count) {
          keys[count] = cell_key(column, fold(z, level.count[2]).index);
          prefetch(&level.buckets[keys[count] & mask]);
        }
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Bucket& bucket = level.buckets[keys[i] & mask];
      if ((bucket.tags & tag(keys[i])) != 0) prefetch(spheres_.data() + bucket.last);
    }
  }

  static Cell cell_at(const Level& level, const Vec3& position);
  static Cells cells_near(const Level& level, const Vec3& center, double radius) {
    const double margin = (radius + level.largest_radius) * (1 + 1e-9);
    const Vec3 reach{margin, margin, margin};
    return {cell_at(level, center - reach), cell_at(level, center + reach)};
  }
  static Folded fold(std::int64_t index, std::int64_t count) {
    if (count == 0 || (index >= 0 && index < count)) return {index, 0};
    const std::int64_t boxes = index >= 0 ? index / count : -((count - 1 - index) / count);
    return {index - boxes * count, static_cast<std::int32_t>(boxes)};
  }
  // The key of a cell: 64 bits, equal for two cells about once in 10^19 times. Cells adjacent along z are
  // adjacent in memory.
  static std::uint64_t column_key(std::int64_t x, std::int64_t y) { return mix(mix(0, x), y); }
  static std::uint64_t cell_key(std::uint64_t column, std::int64_t z) {
    return column + static_cast<std::uint64_t>(z);
  }
  static std::uint64_t mix(std::uint64_t key, std::int64_t index) {
    key = (key ^ static_cast<std::uint64_t>(index)) * 0x9e3779b97f4a7c15;
    return key ^ (key >> 32);
  }
  static std::uint32_t tag(std::uint64_t key) { return std::uint32_t{1} << (key >> 59); }
  std::size_t level_for(double radius) const;

  Box box_;
  double slid_;  // by how much the image above a sheared box is displaced
  std::size_t capacity_;
  std::vector<Level> levels_;
  LargeVector<Resting> spheres_;
};

}  // namespace hardball
