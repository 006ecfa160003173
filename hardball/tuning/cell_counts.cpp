// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/cell_counts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "hardball/tuning/cell_axes.hpp"
#include "hardball/tuning/kinetic_theory.hpp"
#include "hardball/tuning/row_surplus.hpp"

namespace hardball {
namespace {

using Powers = std::array<double, 4>;  // means of the powers 0 to 3 of a length

// The mean of the product over all axes of (edge (1 + surplus) + width) [L^3].
double mean_region(const CellAxes& axes, const RowSurplus& surplus, const Powers& width) {
  const auto edge = [&](std::size_t axis) { return axes[axis].edge; };
  double region = edge(0) * edge(1) * edge(2) * (1 + surplus.all) + width[3];
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::size_t b = (axis + 1) % kAxes;
    const std::size_t c = (axis + 2) % kAxes;
    region += edge(0) * edge(1) * edge(2) * (surplus.along[axis] + surplus.across[axis]);
    region += width[1] * edge(b) * edge(c) * (1 + surplus.along[b] + surplus.along[c] + surplus.across[axis]);
    region += width[2] * edge(axis) * (1 + surplus.along[axis]);
  }
  return region;
}

// The same product over two of the axes only [L^2].
double mean_section(const CellAxes& axes, const RowSurplus& surplus, const Powers& width,
                    std::size_t left_out) {
  const std::size_t b = (left_out + 1) % kAxes;
  const std::size_t c = (left_out + 2) % kAxes;
  return axes[b].edge * axes[c].edge * (1 + surplus.along[b] + surplus.along[c] + surplus.across[left_out]) +
         width[1] * (axes[b].edge * (1 + surplus.along[b]) + axes[c].edge * (1 + surplus.along[c])) +
         width[2];
}

// Means of the powers of the diameter of one sphere, and of the sum of two diameters.
Powers diameter_powers(const std::array<double, 6>& radius_power) {
  return {1, 2 * radius_power[1], 4 * radius_power[2], 8 * radius_power[3]};
}

Powers sum_powers(const Powers& a, const Powers& b) {
  return {1, a[1] + b[1], a[2] + 2 * a[1] * b[1] + b[2], a[3] + 3 * a[2] * b[1] + 3 * a[1] * b[2] + b[3]};
}

// The same for colliding spheres, weighted by the squared sum of the two radii.
Powers colliding_diameter_powers(const std::array<double, 6>& m) {
  const double all = 2 * m[2] + 2 * m[1] * m[1];
  return {1, 2 * (3 * m[1] * m[2] + m[3]) / all, 4 * (m[2] * m[2] + 2 * m[1] * m[3] + m[4]) / all,
          8 * (m[2] * m[3] + 2 * m[1] * m[4] + m[5]) / all};
}

}  // namespace

CellCounts expected_counts(const Moments& moments, double edge) {
  CellCounts counts;
  if (moments.spheres == 0) return counts;
  const CellAxes axes = cell_axes(moments, edge);
  double density = static_cast<double>(moments.spheres);  // of centres in the volume accessible to them
  double shared = 1;          // the fraction of the candidates' volume that walls leave
  double shared_at_wall = 0;  // the same for a sphere touching a wall
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    density /= axes[axis].room;
    shared *= axes[axis].candidates;
  }
  double walls = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!moments.box.is_wall(axis)) continue;
    shared_at_wall += shared * axes[axis].candidates_at_wall / axes[axis].candidates;
    ++walls;
  }
  if (walls > 0) shared_at_wall /= walls;
  const double free_path = mean_free_path(moments);
  const RowSurplus none;
  const RowSurplus surplus = mean_row_surplus(axes, 2 * moments.mean_radius(), free_path);
  const Powers one = diameter_powers(moments.radius_power);
  const Powers colliding = colliding_diameter_powers(moments.radius_power);

  const Box& box = moments.box;
  counts.is_hashed = box.is_open(0) || box.is_open(1) || box.is_open(2);
  counts.are_images_listed =
      !axes[0].has_nearest_images || !axes[1].has_nearest_images || !axes[2].has_nearest_images;
  counts.collision = 1 / mean_free_time(moments);
  counts.wall = wall_rate(moments);
  const auto pairs_in = [&](double region) { return density * shared * region; };
  counts.candidates_after_collision = std::max(
      1.0, pairs_in(mean_region(axes, surplus, sum_powers(colliding, one))) + excess_about_pair(moments));
  const double region = mean_region(axes, surplus, sum_powers(one, one));
  counts.candidates_after_wall =
      std::max(0.0, density * shared_at_wall * region + excess_about_sphere(moments));
  counts.candidates_at_any_time = std::max(0.0, pairs_in(region) + excess_about_sphere(moments));
  counts.candidates_when_stale =
      std::max(1.0, pairs_in(mean_region(axes, of_two(surplus), sum_powers(colliding, one))) +
                        excess_about_sphere(moments));

  const double cell = axes[0].edge * axes[1].edge * axes[2].edge;
  counts.cells = mean_region(axes, none, colliding) / cell;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double rate = moments.mean_speed / 2 * axes[axis].crossings;
    counts.enter += rate;
    counts.cells_entered += rate * mean_section(axes, none, one, axis) * axes[axis].edge / cell;
    counts.candidates_after_enter += rate * pairs_in((axes[axis].edge * (1 + surplus.along[axis]) + one[1]) *
                                                     mean_section(axes, surplus, sum_powers(one, one), axis));
  }
  if (counts.enter > 0) {
    counts.cells_entered /= counts.enter;
    // Half of the volume around a sphere, in which it excludes others, lies in the row ahead.
    counts.candidates_after_enter =
        std::max(0.0, counts.candidates_after_enter / counts.enter + excess_about_sphere(moments) / 2);
  }
  // Measured in simulations from dilute to dense: docs/theory.md.
  const double mean_edge = std::cbrt(cell);
  counts.stale = counts.collision / 2 * 0.065 * mean_edge / (mean_edge + 1.35 * free_path);
  return counts;
}

}  // namespace hardball
