// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/packed_spheres.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "hardball/numbers/exact_sum.hpp"
#include "hardball/packing/fine.hpp"
#include "hardball/packing/mesh_walls.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/static_hash_grid.hpp"

namespace hardball {
namespace {

// Of two centers along an axis, with the shift of an image.
Fine apart(double first, double second, double shift) {
  return difference(second, first) + Fine{shift, 0};
}

// How far the center of a sphere is from a wall.
Fine distance_to_face(const Container& container, Face face, const Vec3& center) {
  const std::size_t axis = face / 2;
  return face % 2 == 0 ? Fine{center[axis], 0} : difference(container.size[axis], center[axis]);
}

// From the curved wall of this number; only that within a shell or an annulus is not the first.
Fine distance_to_curved(const Container& container, std::size_t number, const Vec3& center) {
  using enum Container::Shape;
  const Fine radius{container.size.x / 2, 0};
  const bool is_round = container.shape == sphere || container.shape == shell;
  std::array<Fine, kAxes> from_axis{difference(center.x, container.size.x / 2),
                                    difference(center.y, container.size.y / 2), Fine{0, 0}};
  if (is_round && container.dimensions == 3) from_axis[2] = difference(center.z, container.size.z / 2);
  const Fine distance = length_of(from_axis);
  if (number > 0) return distance - Fine{container.inner / 2, 0};
  if (is_round || container.shape == cylinder || container.shape == annulus) return radius - distance;
  // Of a point at height z the mantle is (z (R - r) + H r - H rho) / sqrt((R - r)^2 + H^2) away.
  const Fine height{container.size.z, 0};
  const Fine narrow{container.inner / 2, 0};
  const Fine wider = radius - narrow;
  const Fine across = Fine{center.z, 0} * wider + height * (narrow - distance);
  return quotient(across, square_root(square(wider) + square(height)));
}

}  // namespace

double PackedSpheres::mean_diameter() const {
  ExactSum sum;
  for (const double radius : radii) sum += 2 * radius;
  return sum.value() / static_cast<double>(radii.size());
}

double PackedSpheres::packing_fraction() const {
  const Box box = container.box();
  ExactSum volume;
  for (const double radius : radii) volume += box.sphere_volume(radius);
  return volume.value() / container.volume();
}

void PackedSpheres::for_each_near(double gap, const Function<void(const NearPair&)>& visit) const {
  const Box box = container.box();
  std::vector<std::uint32_t> order(size());
  std::iota(order.begin(), order.end(), 0U);
  ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) { return radii[a] > radii[b]; });
  const double wider = 1 + gap;
  StaticHashGrid grid(box, size(), wider * radii[order.front()]);
  for (const std::uint32_t sphere : order) grid.insert(positions[sphere], wider * radii[sphere]);
  const std::vector<Surface> surfaces = container.surfaces();
  std::optional<MeshWalls> mesh;
  if (container.mesh) mesh.emplace(surfaces.front().mesh()->shared_mesh());
  std::vector<NearPair> found;
  for (std::uint32_t first = 0; first < size(); ++first) {
    found.clear();
    const double radius = radii[first];
    const auto take = [&](NearPair pair, const Fine& distance) {
      const Fine between = distance - Fine{pair.reach, 0};
      pair.gap = between.high;
      if (pair.gap <= gap * pair.reach) found.push_back(pair);
    };
    grid.for_each_near(
        positions[first], wider * radius, [&](std::uint32_t index, const Vec3& separation, double /*reach*/) {
          const std::uint32_t second = order[index];
          // Each pair once; a sphere and its own image, too.
          const Vec3 from_to = positions[second] - positions[first];
          Image image;
          for (std::size_t axis = 0; axis < kAxes; ++axis) {
            if (!box.is_periodic(axis)) continue;
            image[axis] =
                static_cast<std::int32_t>(std::lround((separation[axis] - from_to[axis]) / box.size()[axis]));
          }
          if (second < first || (second == first && !(Image{} < image))) return;
          const Vec3 shift = box.shift(image);
          std::array<Fine, kAxes> vector;
          for (std::size_t axis = 0; axis < kAxes; ++axis)
            vector[axis] = apart(positions[first][axis], positions[second][axis], shift[axis]);
          take({.bodies = {first, second, false, image},
                .separation = separation,
                .reach = radius + radii[second]},
               length_of(vector));
        });
    ranges::sort(found, {},
                 [](const NearPair& pair) { return std::pair(pair.bodies.second, pair.bodies.image); });
    for (Face face = 0; face < kFaces; ++face) {
      if (!box.is_wall(face / 2)) continue;
      const Fine distance = distance_to_face(container, face, positions[first]);
      Vec3 separation;
      separation[face / 2] = face % 2 == 0 ? -distance.high : distance.high;
      take({.bodies = {first, face, true}, .separation = separation, .reach = radius}, distance);
    }
    if (mesh) {
      mesh->for_each_near(positions[first], wider * radius, [&](const NearWall& wall) {
        take({.bodies = {first, wall.number, true}, .separation = wall.separation, .reach = radius},
             wall.distance);
      });
    } else {
      for (std::uint32_t number = 0; number < surfaces.size(); ++number) {
        const Fine distance = distance_to_curved(container, number, positions[first]);
        take({.bodies = {first, kFaces + number, true},
              .separation = distance.high * surfaces[number].direction(positions[first], Time(0)),
              .reach = radius},
             distance);
      }
    }
    for (const NearPair& pair : found) visit(pair);
  }
}

double PackedSpheres::largest_overlap() const {
  double deepest = 0;
  for_each_near(0, [&](const NearPair& pair) { deepest = std::max(deepest, -pair.gap / pair.reach); });
  return deepest;
}

double PackedSpheres::smallest_gap() const {
  constexpr double kFirst = 1e-3;
  constexpr double kWider = 8;
  for (double within = kFirst;; within *= kWider) {
    double least = std::numeric_limits<double>::infinity();
    for_each_near(within, [&](const NearPair& pair) { least = std::min(least, pair.gap / pair.reach); });
    if (std::isfinite(least)) return least;
  }
}

}  // namespace hardball
