// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "bench/time_stepped.hpp"

namespace hardball::bench {
TimeStepped::TimeStepped(const World& world, const Time& now)
    : size_(world.box().size()), radius_(world.largest_radius()) {
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const Vec3 position = world.position(slot, now);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      position_[axis].push_back(position[axis]);
      velocity_[axis].push_back(world.path(slot).velocity[axis]);
    }
  }
}

std::uint64_t TimeStepped::step(double duration) {
  move(duration);
  const double* x = position_[0].data();
  const double* y = position_[1].data();
  const double* z = position_[2].data();
  const std::size_t count = position_[0].size();
  const double limit = 4 * radius_ * radius_;
  std::uint64_t collisions = 0;
  for (std::size_t a = 0; a < count; ++a) {
    const auto overlap = [=, center = Vec3{x[a], y[a], z[a]}](std::size_t b) {
      const double dx = x[b] - center.x;
      const double dy = y[b] - center.y;
      const double dz = z[b] - center.z;
      return dx * dx + dy * dy + dz * dz < limit;
    };
    // Nearly all time is spent here. Compilers vectorize a loop that only counts; spheres with overlaps are
    // few, and examined again.
    std::uint64_t overlaps = 0;
    for (std::size_t b = a + 1; b < count; ++b) {
      if (overlap(b)) ++overlaps;
    }
    for (std::size_t b = a + 1; overlaps > 0; ++b) {
      if (!overlap(b)) continue;
      --overlaps;
      if (collide(a, b)) ++collisions;
    }
  }
  return collisions;
}

void TimeStepped::move(double duration) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double low = radius_;
    const double high = size_[axis] - radius_;
    for (std::size_t i = 0; i < position_[axis].size(); ++i) {
      double& position = position_[axis][i];
      double& velocity = velocity_[axis][i];
      position += velocity * duration;
      if (position < low) {
        position = 2 * low - position;
        velocity = -velocity;
      } else if (position > high) {
        position = 2 * high - position;
        velocity = -velocity;
      }
    }
  }
}

// Exchanges the velocities along the line of centers if two spheres approach; returns whether they did.
bool TimeStepped::collide(std::size_t a, std::size_t b) {
  Vec3 separation;
  Vec3 approach;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    separation[axis] = position_[axis][b] - position_[axis][a];
    approach[axis] = velocity_[axis][a] - velocity_[axis][b];
  }
  const double speed = dot(approach, separation);
  if (!(speed > 0)) return false;
  const double factor = speed / dot(separation, separation);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    velocity_[axis][a] -= factor * separation[axis];
    velocity_[axis][b] += factor * separation[axis];
  }
  return true;
}

}  // namespace hardball::bench
