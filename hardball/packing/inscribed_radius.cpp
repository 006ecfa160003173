// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/inscribed_radius.hpp"

#include <algorithm>
#include <cstddef>
#include <queue>
#include <vector>

namespace hardball {
namespace {

// A part of space, and a bound of the distance from the mesh of all points of it that are inside.
struct Part {
  double bound;
  std::size_t number;
  Vec3 center;
  Vec3 half;  // of its edges
};

double depth(const Mesh& mesh, const Vec3& point) {
  const double distance = length(mesh.nearest(point).point - point);
  return mesh.contains(point) ? distance : -distance;
}

}  // namespace

double inscribed_radius(const Mesh& mesh) {
  constexpr double kPrecision = 0.01;
  constexpr std::size_t kMostQuestions = 5000;
  const auto is_lower = [](const Part& a, const Part& b) {
    return a.bound != b.bound ? a.bound < b.bound : a.number > b.number;
  };
  std::priority_queue<Part, std::vector<Part>, decltype(is_lower)> parts(is_lower);
  double best = 0;
  std::size_t questions = 0;
  const auto add = [&](const Vec3& center, const Vec3& half) {
    const double found = depth(mesh, center);
    best = std::max(best, found);
    // A point is no deeper than another by more than they are apart.
    parts.push({found + length(half), questions++, center, half});
  };
  const Extent& extent = mesh.extent();
  const Vec3 size = extent.high - extent.low;
  add(extent.low + 0.5 * size, 0.5 * size);
  while (parts.top().bound > (1 + kPrecision) * best && questions < kMostQuestions) {
    const Part whole = parts.top();
    parts.pop();
    // The longest edge is halved.
    std::size_t axis = 0;
    for (std::size_t other = 1; other < kAxes; ++other)
      if (whole.half[other] > whole.half[axis]) axis = other;
    Vec3 half = whole.half;
    half[axis] /= 2;
    for (const double side : {-1.0, 1.0}) {
      Vec3 center = whole.center;
      center[axis] += side * half[axis];
      add(center, half);
    }
  }
  return std::min(parts.top().bound, 0.5 * std::min({size.x, size.y, size.z}));
}

}  // namespace hardball
