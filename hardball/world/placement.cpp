// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/placement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/world/neighborhood.hpp"
#include "hardball/world/range.hpp"
#include "hardball/world/spacing.hpp"

namespace hardball {
namespace {

// Random sequential addition of equal spheres jams at a packing fraction of 0.38 and slows down long before.
constexpr double kRandomLimit = 0.36;
constexpr int kMaxAttempts = 20000;

void check_fits(const Region& region, double radius, const std::string& where) {
  constexpr double kRounding = 1e-12;
  const Vec3 size = region.high - region.low;
  const double narrowest = std::min({size.x, size.y, size.z});
  if (2 * radius <= narrowest * (1 + kRounding)) return;
  throw Error(
      "diameter " + to_text(2 * radius) + " exceeds the length " + to_text(narrowest) + " of the region",
      where, "enlarge the region or shrink the spheres");
}

void check_region(const Region& region, const std::string& where) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    check_finite(region.low[axis], "an end of the region", where);
    check_finite(region.high[axis], "an end of the region", where);
    check_positive(region.high[axis] - region.low[axis], "a length of the region", where);
  }
}

// The interval along an axis in which a centre may lie.
struct Span {
  double low;
  double high;
};

Span span_for_centers(const Box& box, const Region& region, double radius, std::size_t axis) {
  const double inset = box.is_periodic(axis) ? 0 : radius;
  return {region.low[axis] + inset, region.high[axis] - inset};
}

// A random centre in the region.
Vec3 draw_center(const Box& box, const Region& region, double radius, Random& random) {
  Vec3 center;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const Span span = span_for_centers(box, region, radius, axis);
    center[axis] = span.low + random.uniform() * (span.high - span.low);
  }
  return center;
}

double volume(const Region& region) {
  const Vec3 size = region.high - region.low;
  return size.x * size.y * size.z;
}

double sphere_volume(std::span<const double> radii) {
  double cubes = 0;
  for (const double radius : radii) cubes += radius * radius * radius;
  return 4 * std::numbers::pi / 3 * cubes;
}

// A face-centred cubic lattice. Its sites are every second point, as on a chessboard, of a grid with half the
// edges of its cube.
struct Lattice {
  std::array<std::size_t, kAxes> cubes{};
  Vec3 half_edge;
  Vec3 origin;
  double nearest = 0;

  std::size_t sites() const { return 4 * cubes[0] * cubes[1] * cubes[2]; }
};

Lattice make_lattice(const Box& box, const Region& region, double radius,
                     const std::array<std::size_t, kAxes>& cubes) {
  Lattice lattice{cubes, {}, {}, 0};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const Span span = span_for_centers(box, region, radius, axis);
    const auto points = static_cast<double>(2 * cubes[axis]);
    const bool periodic = box.is_periodic(axis);
    lattice.half_edge[axis] = (span.high - span.low) / (periodic ? points : points - 1);
    lattice.origin[axis] = span.low + (periodic ? lattice.half_edge[axis] / 2 : 0);
  }
  const Vec3& h = lattice.half_edge;
  lattice.nearest = std::min(
      {length({h.x, h.y, 0}), length({0, h.y, h.z}), length({h.x, 0, h.z}), 2 * h.x, 2 * h.y, 2 * h.z});
  return lattice;
}

// The lattice with room for `count` spheres whose nearest sites are farthest apart.
Lattice widest_lattice(const Box& box, const Region& region, std::size_t count, double radius) {
  const Vec3 size = region.high - region.low;
  const double edge = spacing(size, static_cast<double>(count) / 4);
  std::array<std::size_t, kAxes> low{};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    low[axis] = static_cast<std::size_t>(std::max(1.0, std::floor(size[axis] / edge) - 2));
  }
  constexpr std::size_t kTries = 6;
  Lattice widest;
  for (std::size_t a = low[0]; a < low[0] + kTries; ++a) {
    for (std::size_t b = low[1]; b < low[1] + kTries; ++b) {
      const std::size_t c = (count + 4 * a * b - 1) / (4 * a * b);
      const Lattice lattice = make_lattice(box, region, radius, {a, b, c});
      if (lattice.nearest > widest.nearest) widest = lattice;
    }
  }
  return widest;
}

}  // namespace

std::vector<Vec3> place_randomly(const Box& box, const Region& region, std::span<const double> radii,
                                 Random& random, const std::string& where, const Progress& progress) {
  std::vector<Vec3> centers(radii.size());
  if (radii.empty()) return centers;
  check_region(region, where);
  for (const double radius : radii) check_positive(radius, "radius", where);
  check_fits(region, std::ranges::max(radii), where);
  const double packing = sphere_volume(radii) / volume(region);
  if (packing > kClosePacking && std::ranges::min(radii) == std::ranges::max(radii)) {
    throw Error("a packing fraction of " + to_text(packing) + " cannot exist", where,
                "equal spheres fill at most 0.7405; enlarge the box, or take fewer or smaller spheres");
  }
  if (packing > kRandomLimit && std::ranges::min(radii) == std::ranges::max(radii)) {
    throw Error("random placement cannot reach a packing fraction of " + to_text(packing), where,
                "use placement = \"fcc\", which reaches 0.74, or stay below 0.36");
  }
  std::vector<std::size_t> by_size(radii.size());
  std::iota(by_size.begin(), by_size.end(), std::size_t{0});
  if (std::ranges::min(radii) != std::ranges::max(radii)) {
    std::stable_sort(by_size.begin(), by_size.end(),
                     [&](std::size_t a, std::size_t b) { return radii[a] > radii[b]; });
  }
  Neighborhood neighborhood(box, radii.size(), std::ranges::max(radii));
  std::size_t placed = 0;
  for (const std::size_t i : by_size) {
    progress.note(placed, radii.size());
    bool fits = false;
    for (int attempt = 0; attempt < kMaxAttempts && !fits; ++attempt) {
      const Vec3 center = draw_center(box, region, radii[i], random);
      fits = !neighborhood.is_any_near(center, radii[i],
                                       [](std::uint32_t, const Vec3& separation, double reach) {
                                         return dot(separation, separation) < reach * reach;
                                       });
      if (fits) centers[i] = center;
    }
    if (!fits) {
      throw Error(
          "random placement found room for " + to_text(placed) + " of " + to_text(radii.size()) + " spheres",
          where, "use placement = \"fcc\", a larger box, or fewer or smaller spheres");
    }
    neighborhood.insert(centers[i], radii[i]);
    ++placed;
  }
  return centers;
}

std::vector<Vec3> place_on_lattice(const Box& box, const Region& region, std::size_t count, double radius,
                                   const std::string& where) {
  std::vector<Vec3> centers;
  if (count == 0) return centers;
  check_region(region, where);
  check_positive(radius, "radius", where);
  check_fits(region, radius, where);
  const Lattice lattice = widest_lattice(box, region, count, radius);
  if (lattice.nearest < 2 * radius) {
    throw Error("no face-centred cubic lattice holds " + to_text(count) + " spheres of radius " +
                    to_text(radius) + " in this box",
                where, "with this count and box the radius can be at most " + to_text(lattice.nearest / 2));
  }
  centers.reserve(count);
  const std::size_t sites = lattice.sites();
  std::size_t site = 0;
  for (std::size_t x = 0; x < 2 * lattice.cubes[0]; ++x) {
    for (std::size_t y = 0; y < 2 * lattice.cubes[1]; ++y) {
      for (std::size_t z = (x + y) % 2; z < 2 * lattice.cubes[2]; z += 2) {
        // Site k is taken where k * count / sites increases: at `count` sites, evenly spread.
        const bool taken = (site + 1) * count / sites > site * count / sites;
        ++site;
        if (!taken) continue;
        centers.push_back({lattice.origin.x + static_cast<double>(x) * lattice.half_edge.x,
                           lattice.origin.y + static_cast<double>(y) * lattice.half_edge.y,
                           lattice.origin.z + static_cast<double>(z) * lattice.half_edge.z});
      }
    }
  }
  return centers;
}

}  // namespace hardball
