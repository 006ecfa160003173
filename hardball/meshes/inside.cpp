// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <numbers>

#include "hardball/geometry/double_double.hpp"
#include "hardball/meshes/exact_sign.hpp"
#include "hardball/meshes/mesh.hpp"

// What is inside a mesh and what is outside.

namespace hardball {
namespace {

// How often the sides of a triangle, seen along z, turn around a point: 1 if counterclockwise, -1, or 0. A
// point on a side is as if it were a little farther along x, or, there being none, along y, in all triangles
// alike.
int turns_along_z(const std::array<Vec3, 3>& corners, const Vec3& point) {
  int turns = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& begin = corners[k];
    const Vec3& end = corners[(k + 1) % 3];
    if (begin.y <= point.y && point.y < end.y) {
      turns += orientation_along_z(begin, end, point) > 0 ? 1 : 0;
    } else if (end.y <= point.y && point.y < begin.y) {
      turns -= orientation_along_z(begin, end, point) < 0 ? 1 : 0;
    }
  }
  return turns;
}

// The arctangent of a number from 0 to 1, from operations that are exactly rounded.
double arctangent(double tangent) {
  // Twice halved, the angle is at most a sixteenth of half a turn; what the series leaves out is below 2^-57.
  for (int halving = 0; halving < 2; ++halving) tangent /= 1 + std::sqrt(1 + tangent * tangent);
  constexpr int kLast = 23;
  const double square = tangent * tangent;
  double sum = 0;
  for (int power = kLast; power >= 1; power -= 2) sum = 1.0 / power - square * sum;
  return 4 * tangent * sum;
}

// The angle from the axis x to a direction, from minus half a turn to half a turn.
double angle_of(double x, double y) {
  const double ahead = std::fabs(x);
  const double aside = std::fabs(y);
  double angle = 0;
  if (aside > ahead) {
    angle = std::numbers::pi / 2 - arctangent(ahead / aside);
  } else if (ahead > 0) {
    angle = arctangent(aside / ahead);
  }
  if (x < 0) angle = std::numbers::pi - angle;
  return y < 0 ? -angle : angle;
}

}  // namespace

bool Mesh::contains(const Vec3& point) const {
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  int crossings = 0;
  const double farthest = 0;
  tree_.for_each_within(
      farthest,
      [&](const Extent& extent) {
        const bool is_above = extent.low.x <= point.x && point.x <= extent.high.x &&
                              extent.low.y <= point.y && point.y <= extent.high.y && extent.high.z >= point.z;
        return is_above ? 0 : kNowhere;
      },
      [&](std::uint32_t triangle) {
        std::array<Vec3, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = parts_.vertices[parts_.triangles[triangle][k]];
        const int turns = turns_along_z(corners, point);
        if (turns != 0 && turns * orientation(corners[0], corners[1], corners[2], point) > 0)
          crossings += turns;
      });
  // Where triangles are inside out, only whether their number is odd means something.
  return report_.flipped_edges == 0 ? crossings != 0 : crossings % 2 != 0;
}

double Mesh::winding_number(const Vec3& point) const {
  DoubleDouble<> half_angles{0, 0};
  for (const auto& [a, b, c] : parts_.triangles) {
    const Vec3 to_a = parts_.vertices[a] - point;
    const Vec3 to_b = parts_.vertices[b] - point;
    const Vec3 to_c = parts_.vertices[c] - point;
    const double sine = dot(to_a, cross(to_b, to_c));
    const double cosine = length(to_a) * length(to_b) * length(to_c) + dot(to_a, to_b) * length(to_c) +
                          dot(to_b, to_c) * length(to_a) + dot(to_c, to_a) * length(to_b);
    half_angles = half_angles + DoubleDouble<>{angle_of(cosine, sine), 0};
  }
  return half_angles.high / (2 * std::numbers::pi);
}

}  // namespace hardball
