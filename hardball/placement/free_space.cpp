// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/placement/free_space.hpp"

#include <algorithm>
#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

// Without SSE4.1, std::floor is a function call.
std::int64_t rounded_down(double number) {
  const auto toward_zero = static_cast<std::int64_t>(number);
  return toward_zero - (static_cast<double>(toward_zero) > number ? 1 : 0);
}

// The square of the larger of two distances along an axis: from 0 to `from`, and to `from + edge`.
double farther_squared(double from, double edge) {
  const double farther = std::max(std::fabs(from), std::fabs(from + edge));
  return farther * farther;
}

}  // namespace

FreeSpace::FreeSpace(const Box& box, const Region& centers, double least_radius, double finest_edge,
                     std::size_t most_voxels)
    : parts_(std::uint32_t{1} << box.dimensions()), least_radius_(least_radius), low_(centers.low) {
  double edge = finest_edge;
  std::int64_t voxels = 0;
  do {
    voxels = 1;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double length = centers.high[axis] - centers.low[axis];
      count_[axis] =
          std::clamp(static_cast<std::int64_t>(std::min(length / edge, 1e9)), std::int64_t{1}, kMaxAlongAxis);
      voxels *= count_[axis];
    }
    edge *= 1.25;
  } while (voxels > static_cast<std::int64_t>(std::max<std::size_t>(most_voxels, 1)));
  constexpr double kRounding = 1e-13;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double length = centers.high[axis] - centers.low[axis];
    blocks_[axis] = (count_[axis] + 7) / 8;
    edge_[axis] = length / static_cast<double>(count_[axis]);
    inverse_edge_[axis] = length > 0 ? static_cast<double>(count_[axis]) / length : 0;
    is_periodic_[axis] =
        box.is_periodic(axis) && centers.low[axis] == 0 && centers.high[axis] == box.size()[axis];
    margin_ = std::max(
        margin_, kRounding * (std::fabs(centers.low[axis]) + std::fabs(centers.high[axis]) + least_radius));
  }
  excluded_.resize(static_cast<std::size_t>(64 * blocks_[0] * blocks_[1] * blocks_[2]));
}

void FreeSpace::exclude(const Vec3& center, double radius) {
  const double reach = certain_reach(radius);
  if (!(reach > 0)) return;
  const Vec3 from_low = center - low_;
  // The voxels along an axis that the sphere touches; an axis without width has only one.
  const auto first = [&](std::size_t axis) {
    return rounded_down((from_low[axis] - reach) * inverse_edge_[axis]);
  };
  const auto last = [&](std::size_t axis) {
    return rounded_down((from_low[axis] + reach) * inverse_edge_[axis]);
  };
  const auto distance_squared = [&](std::size_t axis, std::int64_t index) {
    return farther_squared(static_cast<double>(index) * edge_[axis] - from_low[axis], edge_[axis]);
  };
  // Once around a periodic axis is enough.
  const auto clipped = [&](std::size_t axis) {
    std::array<std::int64_t, 2> range{first(axis), last(axis)};
    if (is_periodic_[axis]) {
      range[1] = std::min(range[1], range[0] + 2 * count_[axis]);
    } else {
      range = {std::max(range[0], std::int64_t{0}), std::min(range[1], count_[axis] - 1)};
    }
    return range;
  };
  const auto [z_begin, z_end] = clipped(2);
  const auto [y_begin, y_end] = clipped(1);
  for (std::int64_t z = z_begin; z <= z_end; ++z) {
    const double left_of_z = reach * reach - distance_squared(2, z);
    if (left_of_z <= 0) continue;
    const std::int64_t folded_z = folded(z, 2);
    for (std::int64_t y = y_begin; y <= y_end; ++y) {
      const double left = left_of_z - distance_squared(1, y);
      if (left <= 0) continue;
      const double half = std::sqrt(left);
      if (edge_.x == 0) {
        exclude_row(folded(y, 1), folded_z, 0, std::fabs(from_low.x) < half ? 1 : 0);
        continue;
      }
      exclude_row(folded(y, 1), folded_z, -rounded_down((half - from_low.x) * inverse_edge_.x),
                  rounded_down((from_low.x + half) * inverse_edge_.x));
    }
  }
}

void FreeSpace::list() {
  is_listed_ = true;
  for (std::int64_t z = 0; z < count_[2]; ++z) {
    for (std::int64_t y = 0; y < count_[1]; ++y) {
      for (std::int64_t x = 0; x < count_[0]; ++x) {
        if (is_excluded(x, y, z)) continue;
        listed_[0].push_back(
            {static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), static_cast<std::uint32_t>(z)});
      }
    }
  }
  excluded_ = {};
}

bool FreeSpace::is_empty() const {
  return ranges::all_of(listed_, [](const auto& voxels) { return voxels.empty(); });
}

FreeSpace::Draw FreeSpace::draw(Random& random) const {
  HARDBALL_CHECK(!is_empty());
  double volume = 0;
  for (std::size_t level = 0; level < kLevels; ++level) {
    volume += part_of_volume(level) * static_cast<double>(listed_[level].size());
  }
  Draw draw{};
  double chosen = random.uniform() * volume;
  for (std::size_t level = 0; level < kLevels; ++level) {
    if (listed_[level].empty()) continue;
    draw.level = level;
    chosen -= part_of_volume(level) * static_cast<double>(listed_[level].size());
    if (chosen < 0) break;
  }
  const std::vector<Voxel>& voxels = listed_[draw.level];
  draw.index = static_cast<std::size_t>(random.uniform() * static_cast<double>(voxels.size()));
  const Vec3 edge = edge_at(draw.level);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    draw.center[axis] = low_[axis] + (voxels[draw.index][axis] + random.uniform()) * edge[axis];
  }
  return draw;
}

bool FreeSpace::covers(const Draw& draw, const Overlap& overlap) const {
  return covers(listed_[draw.level][draw.index], draw.level, draw.center, overlap);
}

void FreeSpace::refine(const Draw& draw, const Overlap& overlap) {
  // A sphere of the least radius may still fit where a larger one does not.
  const double reach = certain_reach(overlap.radius);
  if (dot(overlap.separation, overlap.separation) >= reach * reach) return;
  const bool has_no_room = covers(draw, overlap);
  if (!has_no_room && draw.level + 1 == kLevels) return;
  std::vector<Voxel>& voxels = listed_[draw.level];
  const Voxel voxel = voxels[draw.index];
  voxels[draw.index] = voxels.back();
  voxels.pop_back();
  if (has_no_room) return;
  for (std::uint32_t corner = 0; corner < parts_; ++corner) {
    const Voxel part{2 * voxel[0] + (corner & 1), 2 * voxel[1] + (corner >> 1 & 1),
                     2 * voxel[2] + (corner >> 2 & 1)};
    if (!covers(part, draw.level + 1, draw.center, overlap)) listed_[draw.level + 1].push_back(part);
  }
}

// `overlap` is that of a sphere at `center`.
bool FreeSpace::covers(const Voxel& voxel, std::size_t level, const Vec3& center,
                       const Overlap& overlap) const {
  const double reach = certain_reach(overlap.radius);
  if (!(reach > 0)) return false;
  const Vec3 edge = edge_at(level);
  double farthest_squared = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double corner = low_[axis] + voxel[axis] * edge[axis];
    farthest_squared += farther_squared((corner - center[axis]) - overlap.separation[axis], edge[axis]);
  }
  return farthest_squared < reach * reach;
}

void FreeSpace::exclude_row(std::int64_t y, std::int64_t z, std::int64_t begin, std::int64_t end) {
  if (!is_periodic_[0]) {
    exclude_part(y, z, std::max(begin, std::int64_t{0}), std::min(end, count_[0]));
    return;
  }
  if (begin >= end) return;
  const std::int64_t length = std::min(end - begin, count_[0]);
  const std::int64_t first = folded(begin, 0);
  exclude_part(y, z, first, std::min(first + length, count_[0]));
  exclude_part(y, z, 0, first + length - count_[0]);
}

// Excludes a part of a row that lies in the region.
void FreeSpace::exclude_part(std::int64_t y, std::int64_t z, std::int64_t begin, std::int64_t end) {
  for (std::int64_t x = begin >> 3; 8 * x < end; ++x) {
    const std::int64_t first = std::max(begin - 8 * x, std::int64_t{0});
    const std::int64_t last = std::min(end - 8 * x, std::int64_t{8});
    excluded_[byte_at(x, y, z)] |= static_cast<std::uint8_t>((0xff >> (8 - (last - first))) << first);
  }
}

// Relative to a voxel of the first level.
double FreeSpace::part_of_volume(std::size_t level) const {
  double part = 1;
  for (std::size_t i = 0; i < level; ++i) part /= parts_;
  return part;
}

Vec3 FreeSpace::edge_at(std::size_t level) const {
  return 1 / static_cast<double>(std::uint64_t{1} << level) * edge_;
}

}  // namespace hardball
