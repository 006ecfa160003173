// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "hardball/world/world.hpp"

namespace hardball::bench {

/// The simulation by time steps that the paper argues against: after each step every pair of spheres is
/// tested for overlap, and pairs that overlap and approach collide elastically.
class TimeStepped {
 public:
  /// Starts from where the spheres are at `now`. Precondition: walls along all axes, one radius, one mass.
  TimeStepped(const World& world, const Time& now);

  /// Moves all spheres for `duration` [T], reflects them at the walls, and resolves the collisions found;
  /// returns their number. Cost: O(n^2).
  std::uint64_t step(double duration);

 private:
  void move(double duration);
  bool collide(std::size_t a, std::size_t b);

  Vec3 size_;
  double radius_;
  // Shape (3, n): each coordinate of all spheres is contiguous.
  std::vector<double> position_[kAxes];
  std::vector<double> velocity_[kAxes];
};

}  // namespace hardball::bench
