// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/random_start.hpp"

#include "hardball/errors/error.hpp"
#include "hardball/placement/placement.hpp"
#include "hardball/world/walls.hpp"

namespace hardball {

std::vector<Vec3> place_shrunken(const World& empty, const Region& region, std::vector<double>& radii,
                                 Random& random, const std::string& where, const Progress& progress) {
  const IsAllowed is_allowed = [&empty](const Vec3& center, double radius) {
    return is_clear_of_surfaces(empty, center, radius, Time(0));
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
