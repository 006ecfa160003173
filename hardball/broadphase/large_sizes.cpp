// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/large_sizes.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace hardball {
namespace {

constexpr double kMaxSurfacesPerSphere = 1000;

// The least skin over the edge of a cell [1].
constexpr double kLeastSkin = 0.01;

// Candidates stay closer than this fraction of a periodic box along each axis.
constexpr double kLargestShare = 0.495;

double smallest_edge(const Subdivision& cells) {
  return std::min({cells.edge(0), cells.edge(1), cells.edge(2)});
}

// Nothing if no sphere is large, or if so many are large that other cells suit the world better.
std::optional<LargeSizes> if_they_pay(const std::optional<LargeSizes>& sizes, const World& world) {
  if (!sizes || sizes->count == 0 || 2 * sizes->count > world.size()) return std::nullopt;
  const auto spheres = static_cast<double>(world.size());
  return sizes->surfaces > kMaxSurfacesPerSphere * spheres ? std::nullopt : sizes;
}

// The sizes if radii up to this many edges are not large; nothing if candidates would not be nearest images.
std::optional<LargeSizes> sizes_above(double largest_in_edges, const World& world, const Subdivision& cells) {
  const double edge = smallest_edge(cells);
  LargeSizes sizes;
  const double room_to_grow = world.room_to_grow();
  if (room_to_grow > 1) sizes.largest_in_grid = largest_in_edges * edge;
  std::size_t count = 0;
  double largest = 0;
  double second_largest = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const double radius = world.bounding_radius(slot);
    if (radius <= largest_in_edges * edge) {
      sizes.largest_in_grid = std::max(sizes.largest_in_grid, radius);
      continue;
    }
    ++count;
    sizes.surfaces += LargeSizes::cells_of_surface(radius / edge, world.box().dimensions());
    second_largest = std::max(second_largest, std::min(radius, largest));
    largest = std::max(largest, radius);
  }
  sizes.count = count;
  sizes.skin = LargeSizes::kSkin * edge;
  sizes.largest = largest;
  sizes.second_largest = second_largest;
  // A shell must be no thicker for the rounding of coordinates along an axis that is far longer than others.
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (cells.reach(axis, 0) > kLeastSkin * edge) return std::nullopt;
  }
  Vec3 extent;  // of a region of the grid; it shares one cell with that of a large sphere
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    extent[axis] = (cells.most_touched(axis, sizes.largest_in_grid) + 1) * cells.edge(axis);
    if (!world.box().is_periodic(axis)) continue;
    if (!cells.has_nearest_images(axis, sizes.largest_in_grid)) return std::nullopt;
    const double room = kLargestShare * world.box().size()[axis];
    if (count > 1) sizes.skin = std::min(sizes.skin, (room - (largest + second_largest)) / 4);
    sizes.skin = std::min(sizes.skin, (room - (largest + extent[axis])) / 2);
  }
  if (sizes.skin < kLeastSkin * edge) return std::nullopt;
  if (room_to_grow > 1) {
    const double grown = room_to_grow * largest;
    const double second_grown = room_to_grow * std::max(second_largest, sizes.largest_in_grid);
    double room = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!world.box().is_periodic(axis)) continue;
      const double beside = std::max(second_grown + 4 * sizes.skin, extent[axis] + 2 * sizes.skin);
      room = std::min(room, kLargestShare * world.box().size()[axis] - beside);
    }
    if (grown <= room) {
      count = 2;
      sizes.largest = grown;
      sizes.second_largest = second_grown;
    }
  }
  // From a large sphere to any point of its cells, and on to the center of one in the grid that shares them.
  sizes.farthest = sizes.largest + 2 * sizes.skin + length(cells.edges()) + length(extent);
  if (count > 1) {
    sizes.farthest = std::max(sizes.farthest, sizes.largest + sizes.second_largest + 5 * sizes.skin);
  }
  return sizes;
}

}  // namespace

double LargeSizes::cells_of_surface(double radius, std::size_t dimensions) {
  // By Steiner's formula for those that touch the sphere; those inside are missing.
  constexpr double kSphere = 4 * std::numbers::pi / 3;
  constexpr double kDepth = 2 * kSkin + 0.75;
  const double outer = radius + kSkin;
  const double inner = std::max(0.0, outer - kDepth);
  const double depth =
      std::min(outer, kDepth);  // of the largest radii, outer - inner would be rounded to zero
  if (dimensions == 2) return 1 + 4 * outer + std::numbers::pi * depth * (outer + inner);
  return 1 + 6 * outer + 3 * std::numbers::pi * outer * outer +
         kSphere * depth * (outer * outer + outer * inner + inner * inner);
}

std::optional<LargeSizes> LargeSizes::in(const World& world, const Subdivision& cells) {
  // With potentials of steps spheres meet deep inside of regions, where shells do not look.
  if (world.base_radii().is_common() || world.has_steps()) return std::nullopt;
  const auto in_blocks = if_they_pay(sizes_above(kLargestInCell, world, cells), world);
  const auto spheres = static_cast<double>(world.size());
  if (in_blocks && largest_in_edges(in_blocks->surfaces, spheres) == kLargestInCell) return in_blocks;
  if (world.largest_bounding_radius() <= kLargestInRows * smallest_edge(cells)) return std::nullopt;
  const auto in_rows = if_they_pay(sizes_above(kLargestInRows, world, cells), world);
  return in_rows ? in_rows : in_blocks;
}

std::optional<LargeSizes> LargeSizes::in_part(const World& part, const Subdivision& cells) {
  if (const std::optional<LargeSizes> sizes = in(part, cells)) return sizes;
  const std::optional<LargeSizes> in_blocks = sizes_above(kLargestInCell, part, cells);
  return in_blocks ? in_blocks : sizes_above(kLargestInRows, part, cells);
}

}  // namespace hardball
