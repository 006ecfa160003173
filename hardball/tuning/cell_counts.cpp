// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/cell_counts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "hardball/broadphase/cell_table.hpp"
#include "hardball/broadphase/subdivision.hpp"
#include "hardball/theory/kinetic_theory.hpp"
#include "hardball/tuning/cell_axes.hpp"

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

// The mean product over two of the axes only [L^2].
double mean_section(const CellAxes& axes, const RowSurplus& surplus, const Powers& width,
                    std::size_t left_out) {
  const std::size_t b = (left_out + 1) % kAxes;
  const std::size_t c = (left_out + 2) % kAxes;
  return axes[b].edge * axes[c].edge * (1 + surplus.along[b] + surplus.along[c] + surplus.across[left_out]) +
         width[1] * (axes[b].edge * (1 + surplus.along[b]) + axes[c].edge * (1 + surplus.along[c])) +
         width[2];
}

// Means of the powers of the diameter of a sphere.
Powers diameter_powers(const std::array<double, 6>& radius_power) {
  return {1, 2 * radius_power[1], 4 * radius_power[2], 8 * radius_power[3]};
}

// Means of the powers of the diameter of a colliding sphere, weighted by the squared sum of the two radii, of
// discs by their sum.
Powers colliding_diameter_powers(const std::array<double, 6>& m, bool is_flat) {
  if (is_flat)
    return {1, (m[1] * m[1] + m[2]) / m[1], 2 * (m[1] * m[2] + m[3]) / m[1], 4 * (m[3] + m[4] / m[1])};
  const double all = 2 * m[2] + 2 * m[1] * m[1];
  return {1, 2 * (3 * m[1] * m[2] + m[3]) / all, 4 * (m[2] * m[2] + 2 * m[1] * m[3] + m[4]) / all,
          8 * (m[2] * m[3] + 2 * m[1] * m[4] + m[5]) / all};
}

// How far apart two spheres are, in diameters: the means of |r_a| along an axis, of the product along two,
// and along three.
struct Separation {
  double one;
  double two;
  double three;
};
constexpr Separation kInContact{1.0 / 2, 2 / (3 * std::numbers::pi), 1 / (4 * std::numbers::pi)};
constexpr Separation kDiscsInContact{2 / std::numbers::pi, 1 / std::numbers::pi, 0};
// Anywhere in the sphere that a sphere excludes.
constexpr Separation kOverlapping{3.0 / 8, 2 / (5 * std::numbers::pi), 1 / (8 * std::numbers::pi)};
constexpr Separation kDiscsOverlapping{4 / (3 * std::numbers::pi), 1 / (2 * std::numbers::pi), 0};

// The mean number of cells that they share.
double shared_cells(const CellAxes& axes, double diameter, const Separation& mean) {
  const double x = diameter / axes[0].edge;
  const double y = diameter / axes[1].edge;
  const double z = diameter / axes[2].edge;
  return 1 + (1 - mean.one) * (x + y + z) + (1 - 2 * mean.one + mean.two) * (x * y + y * z + z * x) +
         (1 - 3 * mean.one + 3 * mean.two - mean.three) * x * y * z;
}

// The mean number of shared cells in one row of cells across an axis.
double shared_cells_in_row(const CellAxes& axes, double diameter, const Separation& mean, std::size_t axis) {
  const double x = diameter / axes[(axis + 1) % kAxes].edge;
  const double y = diameter / axes[(axis + 2) % kAxes].edge;
  return 1 + (1 - mean.one) * (x + y) + (1 - 2 * mean.one + mean.two) * x * y;
}

// The spheres of other cells in the list of a cell, each in this many cells. Cells are spread over lists so
// that the variance of their number in a list is about a fifth of its mean, except in long and narrow boxes.
double found_elsewhere(const GasStatistics& statistics, double edge, double cells) {
  const Subdivision subdivision(statistics.box, edge);
  const CellTable table(subdivision, statistics.spheres);
  if (!table.is_shared()) return 0;
  const auto lists = static_cast<double>(table.size());
  double cells_of_box = 1;
  for (const std::int32_t count : subdivision.shape()) {
    cells_of_box *= count > 0 ? count : std::numeric_limits<double>::infinity();
  }
  constexpr double kVariance = 0.2;
  return static_cast<double>(statistics.spheres) * cells * (1 / lists - (1 - kVariance) / cells_of_box);
}

}  // namespace

CellCounts expected_counts(const GasStatistics& statistics, double edge) {
  CellCounts counts;
  if (statistics.spheres == 0) return counts;
  const CellAxes axes = cell_axes(statistics, edge);
  double density = static_cast<double>(statistics.spheres);  // of centers in the volume accessible to them
  // What walls leave of the cells that a sphere touches, and of its candidates; the same at a wall.
  double rows = 1;
  double shared = 1;
  double rows_at_wall = 0;
  double shared_at_wall = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    density /= axes[axis].room;
    rows *= axes[axis].rows;
    shared *= axes[axis].candidates;
  }
  double walls = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!statistics.box.is_wall(axis)) continue;
    rows_at_wall += rows * axes[axis].rows_at_wall / axes[axis].rows;
    shared_at_wall += shared * axes[axis].candidates_at_wall / axes[axis].candidates;
    ++walls;
  }
  const double free_path = mean_free_path(statistics);
  const RowSurplus none;
  const RowSurplus surplus =
      mean_row_surplus(axes, 2 * statistics.region_power()[1], free_path, statistics.box.dimensions());
  const bool is_flat = statistics.is_flat();
  const Separation& in_contact = is_flat ? kDiscsInContact : kInContact;
  const Separation& overlapping = is_flat ? kDiscsOverlapping : kOverlapping;
  const Powers one = diameter_powers(statistics.region_power());
  const Powers colliding = colliding_diameter_powers(statistics.region_power(), is_flat);

  counts.are_images_listed =
      !axes[0].has_nearest_images || !axes[1].has_nearest_images || !axes[2].has_nearest_images;
  counts.collision = statistics.events_per_collision() / mean_free_time(statistics);
  counts.wall = wall_rate(statistics);
  const double cell = axes[0].edge * axes[1].edge * axes[2].edge;
  // Far from walls, the cells of a sphere after a collision, after a wall contact, at any time, and when its
  // planned contact is found stale.
  const double after_collision = mean_region(axes, none, colliding) / cell;
  const double after_wall = mean_region(axes, none, one) / cell;
  const double at_any_time = mean_region(axes, surplus, one) / cell;
  const double when_stale = mean_region(axes, surplus, colliding) / cell;
  // In each of them there is the sphere itself, and this number of others. Candidates that come with their
  // images are collected once, and without the sphere.
  const double diameter = one[1];
  const bool is_once = counts.are_images_listed;
  const auto repeated = [&](std::size_t axis) {
    return is_once ? (1 + 1 / (1 + axes[axis].edge / diameter)) / (1 + diameter / axes[axis].edge) : 1;
  };
  double others = density * mean_region(axes, surplus, one);
  for (std::size_t axis = 0; axis < kAxes; ++axis) others *= repeated(axis);
  // Where cells share lists, their spheres are found in each.
  const double elsewhere = found_elsewhere(statistics, edge, at_any_time * rows);
  const double in_cells = (is_once ? 0 : rows) + shared * others + rows * elsewhere;
  // Spheres nearby share several cells; some are missing there.
  const double held = at_any_time / after_wall;
  const double missing = is_once ? 1 : held * shared_cells(axes, diameter, overlapping);
  const double excess = missing * excess_about_sphere(statistics);
  counts.cells = after_collision * rows;
  counts.candidates_after_collision =
      std::max(1.0, after_collision * in_cells + (is_once ? 1 : shared_cells(axes, diameter, in_contact)) +
                        missing * (excess_about_pair(statistics) - 1));
  if (walls > 0) {
    const double in_cells_at_wall =
        (is_once ? 0 : rows_at_wall) + shared_at_wall * others + rows_at_wall * elsewhere;
    counts.candidates_after_wall = std::max(0.0, after_wall * in_cells_at_wall / walls + excess);
  }
  counts.candidates_at_any_time = std::max(0.0, at_any_time * in_cells + excess);
  counts.candidates_when_stale = std::max(1.0, when_stale * in_cells + excess);

  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double rate = statistics.mean_speed_along_axis() * axes[axis].crossings;
    counts.enter += rate;
    const double entered =
        mean_section(axes, none, one, axis) * axes[axis].edge / cell * rows / axes[axis].rows;
    counts.cells_entered += rate * entered;
    // Half of the volume around a sphere lies in the row ahead.
    const double near = is_once ? 1 : held * shared_cells_in_row(axes, diameter, overlapping, axis);
    const double in_row = entered * (others / repeated(axis) * shared / rows + elsewhere);
    counts.candidates_after_enter += rate * (in_row + near / 2 * excess_about_sphere(statistics));
  }
  if (counts.enter > 0) {
    counts.cells_entered /= counts.enter;
    counts.candidates_after_enter = std::max(0.0, counts.candidates_after_enter / counts.enter);
  }
  // Measured in simulations from dilute to dense: docs/theory.md.
  const double mean_edge = is_flat ? std::sqrt(axes[0].edge * axes[1].edge) : std::cbrt(cell);
  counts.stale = counts.collision / 2 * (is_flat ? 0.04 : 0.065) * mean_edge / (mean_edge + 1.35 * free_path);
  return counts;
}

}  // namespace hardball
