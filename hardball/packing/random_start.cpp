// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/random_start.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "hardball/errors/error.hpp"
#include "hardball/numbers/cube_root.hpp"
#include "hardball/placement/placement.hpp"
#include "hardball/world/walls.hpp"

namespace hardball {
namespace {

// Whether spheres are clear of surfaces. Distances from meshes cost much: that of the middle of a voxel,
// found once, says enough about most centers in it, as those of two points differ by no more than they are
// apart.
class ClearOfSurfaces {
 public:
  ClearOfSurfaces(const World& empty, const Region& region, std::size_t spheres)
      : empty_(empty), low_(region.low), rounding_(rounding_near_solids(empty)) {
    if (empty.meshes().empty()) return;
    const Vec3 size = region.high - region.low;
    constexpr std::size_t kPerSphere = 256;
    constexpr std::size_t kMost = 1 << 20;
    edge_ = cube_root(size.x * size.y * size.z / static_cast<double>(std::min(kMost, kPerSphere * spheres)));
    std::size_t voxels = 1;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      count_[axis] = static_cast<std::size_t>(std::clamp(size[axis] / edge_, 0.0, double{kMost})) + 1;
      voxels *= count_[axis];
    }
    if (voxels <= 4 * kMost) distances_.assign(voxels, std::numeric_limits<double>::quiet_NaN());
    reach_ = std::sqrt(3.0) / 2 * edge_ * (1 + 0x1p-30) + rounding_;
  }

  bool operator()(const Vec3& center, double radius) {
    if (!distances_.empty()) {
      const double known = distance_in_voxel(center);
      if (known + reach_ < radius) return false;
      if (known - reach_ > radius) return true;
    }
    return is_clear_of_surfaces(empty_, center, radius, Time(0));
  }

 private:
  double distance_in_voxel(const Vec3& center) {
    std::size_t voxel = 0;
    Vec3 middle = low_;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const auto place = static_cast<std::size_t>(std::max(0.0, (center[axis] - low_[axis]) / edge_));
      const std::size_t index = std::min(place, count_[axis] - 1);
      voxel = voxel * count_[axis] + index;
      middle[axis] += (static_cast<double>(index) + 0.5) * edge_;
    }
    if (std::isnan(distances_[voxel])) distances_[voxel] = distance_to_surfaces(empty_, middle, Time(0));
    return distances_[voxel];
  }

  const World& empty_;
  Vec3 low_;
  double rounding_;
  double edge_ = 0;
  double reach_ = 0;  // from the middle of a voxel to its corners, and more than rounding
  std::array<std::size_t, kAxes> count_{};
  std::vector<double> distances_;
};

}  // namespace

std::vector<Vec3> place_shrunken(const World& empty, const Region& region, std::vector<double>& radii,
                                 Random& random, const std::string& where, const Progress& progress) {
  ClearOfSurfaces is_clear(empty, region, radii.size());
  const IsAllowed is_allowed = [&is_clear](const Vec3& center, double radius) {
    return is_clear(center, radius);
  };
  constexpr int kAttempts = 12;
  constexpr double kSmaller = 0.8;
  for (int attempt = 1;; ++attempt) {
    try {
      return place_randomly(empty.box(), region, radii, random, where, progress,
                            empty.surfaces().empty() ? IsAllowed() : is_allowed);
    } catch (const Error&) {
      if (attempt == kAttempts) throw;
      for (double& radius : radii) radius *= kSmaller;
    }
  }
}

std::vector<Vec3> thermal_velocities(std::size_t count, std::size_t dimensions, bool has_walls,
                                     Random& random) {
  std::vector<Vec3> velocities(count);
  Vec3 mean;
  for (Vec3& velocity : velocities) {
    velocity = random.normal_vector(dimensions);
    mean += (1 / static_cast<double>(count)) * velocity;
  }
  if (has_walls) return velocities;
  // A drift would only make spheres seem hotter than they are.
  for (Vec3& velocity : velocities) velocity = velocity - mean;
  return velocities;
}

}  // namespace hardball
