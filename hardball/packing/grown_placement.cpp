// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/grown_placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "hardball/errors/error.hpp"
#include "hardball/packing/jamming.hpp"
#include "hardball/packing/protocol.hpp"
#include "hardball/packing/random_start.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/walls.hpp"

namespace hardball {
namespace {

// Of the packing fraction at which spheres jam. Denser ones would have to grow ever more slowly.
constexpr double kMostOfJamming = 0.97;
// Spheres grow slightly beyond their sizes, so that rounding makes none of them overlap.
constexpr double kMargin = 1 + 0x1p-30;
// The fractions of the work at which spheres have been placed at random, and have grown or locked.
constexpr double kStarted = 0.1;
constexpr double kTried = 0.7;
// Growth is reported in this many steps.
constexpr std::size_t kSteps = 100;
// Contacts between two reports.
constexpr std::uint64_t kReported = 1 << 17;

std::string rounded(double fraction) {
  return to_text(std::round(1e3 * fraction) / 1e3);
}

// The box at time zero without properties of its faces.
Box plain(const Box& box, const std::string& where) {
  std::array<Boundary, kAxes> boundaries{};
  for (std::size_t axis = 0; axis < kAxes; ++axis) boundaries[axis] = box.boundary(axis);
  const double boxes = box.is_sheared() ? box.shear().offset / box.size().x : 0;
  if (boxes != std::round(boxes)) {
    throw Error("random placement cannot reach this density in a box that is displaced at the start", where,
                "give shear_offset = 0, or fewer or smaller spheres");
  }
  return Box(boundaries, box.size());
}

// What spheres grow between: the surfaces as they are at time zero, at rest; spheres that have their places;
// and walls at the ends of the region where the box is open.
std::vector<Surface> walls_around(const World& empty, const Region& region,
                                  std::span<const PlacedSphere> placed) {
  std::vector<Surface> walls;
  for (const Surface& surface : empty.surfaces()) {
    walls.emplace_back(surface.shape_at_rest(), surface.point());
  }
  for (const PlacedSphere& sphere : placed) walls.emplace_back(Obstacle(sphere.radius), sphere.center);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!empty.box().is_open(axis)) continue;
    Vec3 upward;
    upward[axis] = 1;
    walls.emplace_back(Plane(upward), region.low);
    walls.emplace_back(Plane(-1 * upward), region.high);
  }
  return walls;
}

// The time at which the spheres of an epoch reach a scale; none if that is later than its end.
std::optional<double> time_of_scale(const Growth& epoch, double scale) {
  if (!(epoch.rate > 0) || epoch.scale_at(epoch.end) < scale) return std::nullopt;
  return epoch.begin.value() + (scale - epoch.scale) / epoch.rate;
}

// Whether the spheres of a world have grown to a scale before they lock; `now` holds their centers then.
bool grow(const World& start, double rate, double scale, std::vector<Vec3>& centers,
          const Progress& progress) {
  Simulation simulation(start);
  simulation.grow({.rate = rate});
  while (!simulation.growth()->is_over()) {
    const Growth epoch = simulation.world().motion().growth();
    const std::optional<double> end = time_of_scale(epoch, scale);
    const RunStatus status =
        simulation.run({.until = Time(end.value_or(simulation.growth()->next())), .contacts = kReported});
    const double present = simulation.world().motion().scale_at(simulation.now());
    const auto done = static_cast<std::size_t>(kSteps * std::max(0.0, present - 1) / (scale - 1));
    progress.record(std::min(done, kSteps), kSteps);
    if (end && status == RunStatus::time_reached) {
      centers = simulation.positions();
      return true;
    }
    if (simulation.growth()->compressibility() > protocol::kLocked) return false;
  }
  return false;
}

}  // namespace

std::vector<Vec3> place_by_growth(const World& empty, const Region& region, std::span<const double> radii,
                                  std::span<const PlacedSphere> placed, Random& random,
                                  const std::string& where, const Progress& progress) {
  const std::size_t dimensions = empty.box().dimensions();
  double volume = 0;
  for (const double radius : radii) volume += empty.box().sphere_volume(radius);
  double taken = 0;
  for (const PlacedSphere& sphere : placed) taken += empty.box().sphere_volume(sphere.radius);
  const double fraction = volume / (empty.box().volume_of(region.high - region.low) - taken);
  const double jammed = jamming_in_bulk(radii, dimensions);
  const std::string remedy =
      "enlarge the box, use fewer or smaller spheres, or start from a packing of "
      "'hardball pack'";
  if (!(fraction > 0 && fraction <= kMostOfJamming * jammed)) {
    const bool are_equal = ranges::min(radii) == ranges::max(radii);
    const char* const lattice = !are_equal        ? ""
                                : dimensions == 2 ? "use placement = \"hexagonal\", which reaches 0.9, "
                                                  : "use placement = \"fcc\", which reaches 0.74, ";
    throw Error("a packing fraction of " + rounded(fraction) +
                    " is too high for placement = \"random\": spheres of these sizes jam at about " +
                    rounded(jammed),
                where, lattice + remedy);
  }
  World world(plain(empty.box(), where), {}, walls_around(empty, region, placed));
  const double begin = dimensions == 2 ? protocol::kStartOfDiscs : protocol::kStart;
  std::vector<double> small(radii.begin(), radii.end());
  const double shrink = root(std::min(1.0, begin / fraction), dimensions);
  for (double& radius : small) radius *= shrink;
  const std::vector<Vec3> starts =
      place_shrunken(world, region, small, random, where, progress.part(0, kStarted));
  const std::vector<Vec3> velocities =
      thermal_velocities(starts.size(), dimensions, has_walls(world), random);
  world.reserve(starts.size());
  for (std::size_t i = 0; i < starts.size(); ++i)
    world.add({.position = starts[i], .velocity = velocities[i], .radius = small[i]});
  const double scale = kMargin * radii.front() / small.front();
  std::vector<Vec3> centers;
  if (grow(world, rate_for(fraction, jammed), scale, centers, progress.part(kStarted, kTried)))
    return centers;
  constexpr double kSlow = 0.01;  // for spheres that have locked
  if (grow(world, kSlow, scale, centers, progress.part(kTried, 1))) return centers;
  throw Error("spheres that are placed at random and grow lock before they fill " + rounded(fraction) +
                  " of the space",
              where, remedy);
}

}  // namespace hardball
