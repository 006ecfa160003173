// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// An arm of two links passes between a post and a ball that comes flying: what it touches first on its way,
// how near it comes to anything, and how much later it may start to pass unharmed.
#include <cstdio>

#include "hardball/robots.hpp"

namespace {

hardball::Robot two_links() {
  hardball::Link upper{"upper"};
  hardball::Link lower{"lower"};
  for (int k = 1; k <= 5; ++k) {
    upper.spheres.push_back({{0.1 * k, 0, 0}, 0.05});
    lower.spheres.push_back({{0.1 * k, 0, 0}, 0.04});
  }
  return hardball::Robot::from_spheres(
      {upper, lower}, {{.name = "shoulder", .parent = "base", .child = "upper", .origin = {0, 0, 0.5}},
                       {.name = "elbow", .parent = "upper", .child = "lower", .origin = {0.5, 0, 0}}});
}

// The same way, begun at any time.
hardball::JointTrajectory way_from(double begin) {
  return hardball::JointTrajectory::cubic({begin, begin + 1, begin + 2}, {{0, 0}, {0.9, 0.4}, {1.6, 0}},
                                          hardball::SplineEnds::clamped);
}

}  // namespace

int main() {
  const hardball::Robot robot = two_links();
  hardball::Obstacles obstacles;
  obstacles.add_capsule({-0.4, 0.9, 0}, {-0.4, 0.9, 1}, 0.1);
  obstacles.add_sphere({0.4, 2.6, 0.5}, 0.1, {0, -1, 0});
  obstacles.add_plane({0, 0, 0}, {0, 0, 1});
  for (int k = 0; k < 5; ++k) {
    const double begin = k;
    const hardball::JointTrajectory way = way_from(begin);
    if (const auto contact = hardball::first_contact(robot, way, obstacles)) {
      std::printf("begun at %.0f, sphere %zu touches obstacle %zu at %.6f, at (%.4f %.4f %.4f)\n", begin,
                  contact->sphere, contact->obstacle.value(), contact->time, contact->point.x,
                  contact->point.y, contact->point.z);
    } else if (const auto nearest = hardball::least_clearance(robot, way, obstacles)) {
      std::printf("begun at %.0f, it touches nothing, and comes as near as %.4f to obstacle %zu at %.4f\n",
                  begin, nearest->distance, nearest->obstacle.value(), nearest->time);
    }
  }
}
