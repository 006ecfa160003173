// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "hardball/robots/joint_trajectory.hpp"
#include "hardball/robots/obstacles.hpp"
#include "hardball/robots/robot.hpp"

/// Robots, trajectories and obstacles for tests and measurements.
namespace hardball::support {

inline double within(Random& random, double most) {
  return most * (2 * random.uniform() - 1);
}

/// An arm of seven joints that turn and about 1.2 m, with as many spheres of 2 to 5 cm along its links. Links
/// meet if more than two lie between them; `meets_itself` says whether any do.
inline Robot arm(Random& random, std::size_t spheres, bool meets_itself) {
  constexpr double kLengths[] = {0.33, 0.1, 0.3, 0.1, 0.3, 0.1, 0.2};
  constexpr std::size_t kJoints = std::size(kLengths);
  std::vector<Link> links{{"base"}};
  std::vector<Joint> joints;
  for (std::size_t k = 0; k < kJoints; ++k) {
    Link link{"link " + std::to_string(k)};
    const std::size_t share = spheres * (k + 1) / kJoints - spheres * k / kJoints;
    for (std::size_t i = 0; i < share; ++i) {
      link.spheres.push_back({{within(random, 0.04), within(random, 0.04), kLengths[k] * random.uniform()},
                              0.02 + 0.03 * random.uniform()});
    }
    joints.push_back({.name = "joint " + std::to_string(k),
                      .parent = links.back().name,
                      .child = link.name,
                      .origin = {0, 0, k > 0 ? kLengths[k - 1] : 0.1},
                      .axis = k % 2 == 0 ? Vec3{0, 0, 1} : Vec3{0, 1, 0}});
    links.push_back(std::move(link));
  }
  std::vector<std::pair<std::string, std::string>> ignored;
  for (std::size_t a = 0; a < links.size(); ++a) {
    for (std::size_t b = a + 1; b < links.size(); ++b) {
      if (!meets_itself || b - a < 4) ignored.emplace_back(links[a].name, links[b].name);
    }
  }
  return Robot::from_spheres(links, joints, ignored);
}

/// A spline through knots one second apart, the coordinates of which are at most `most`.
inline JointTrajectory random_trajectory(Random& random, std::size_t joints, std::size_t knots, double most) {
  std::vector<double> times;
  std::vector<JointTrajectory::Row> rows;
  for (std::size_t k = 0; k < knots; ++k) {
    times.push_back(static_cast<double>(k));
    rows.emplace_back();
    for (std::size_t j = 0; j < joints; ++j) rows.back().push_back(within(random, most));
  }
  return JointTrajectory::cubic(times, rows);
}

/// Obstacles of this size at distances from the origin from `nearest` to 1.3: spheres, turned boxes, capsules
/// and triangles in turn, or spheres alone.
inline Obstacles random_obstacles(Random& random, std::size_t count, double size, double nearest,
                                  bool only_spheres) {
  Obstacles obstacles;
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3 center = (nearest + (1.3 - nearest) * random.uniform()) * random.direction();
    const Vec3 along = size * random.direction();
    if (only_spheres || k % 4 == 0) {
      obstacles.add_sphere(center, size / 2);
    } else if (k % 4 == 1) {
      obstacles.add_box(center, {size, size / 2, size},
                        RotationMatrix::from_angles(within(random, 3), within(random, 3), within(random, 3)));
    } else if (k % 4 == 2) {
      obstacles.add_capsule(center, center + along, size / 4);
    } else {
      const std::vector<Vec3> corners{center, center + along, center + size * random.direction()};
      const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}};
      obstacles.add_mesh(corners, triangles);
    }
  }
  return obstacles;
}

}  // namespace hardball::support
