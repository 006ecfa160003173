// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/audit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hardball/errors/error.hpp"
#include "hardball/world/static_hash_grid.hpp"
#include "hardball/world/walls.hpp"

namespace hardball {
namespace {

bool is_finite(const Vec3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

void note_escape(const World& world, Slot slot, const Vec3& position, const Time& moment, Audit& found) {
  const double radius = world.radius(slot);
  const auto note = [&](double reach_through) {
    const double through = reach_through / (2 * radius);
    if (through <= found.max_escape) return;
    found.max_escape = through;
    found.escaped = world.id(slot);
  };
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!world.box().is_wall(axis)) continue;
    note(std::max(radius - position[axis], position[axis] + radius - world.box().size()[axis]));
  }
  note(radius - distance_to_surfaces(world, position, moment));
}

}  // namespace

Audit audit(const World& world, const Time& moment, const Progress& progress) {
  Audit found;
  std::vector<Slot> by_size(world.size());
  std::iota(by_size.begin(), by_size.end(), Slot{0});
  if (!world.radii().is_common()) {
    std::stable_sort(by_size.begin(), by_size.end(),
                     [&](Slot a, Slot b) { return world.radius(a) > world.radius(b); });
  }
  const bool passes = world.has_passing_pairs();
  StaticHashGrid neighborhood(world.box(), world.size(), world.largest_radius());
  std::vector<Slot> inserted;
  inserted.reserve(world.size());
  std::size_t seen = 0;
  for (const Slot slot : by_size) {
    progress.note(seen++, by_size.size());
    const Path& path = world.path(slot);
    if (!is_finite(path.position) || !is_finite(path.velocity)) {
      ++found.not_finite;
      continue;
    }
    const Vec3 position = world.position(slot, moment);
    note_escape(world, slot, position, moment, found);
    neighborhood.for_each_near(position, world.radius(slot),
                               [&](std::uint32_t index, const Vec3& separation, double reach) {
                                 // With a margin for rounding; most neighbors are farther away.
                                 if (dot(separation, separation) > 1.001 * (reach * reach)) return;
                                 const double overlap = 1 - length(separation) / reach;
                                 if (overlap <= found.max_overlap) return;
                                 if (passes && world.pass(slot, inserted[index])) return;
                                 found.max_overlap = overlap;
                                 found.overlap_first = std::min(world.id(slot), world.id(inserted[index]));
                                 found.overlap_second = std::max(world.id(slot), world.id(inserted[index]));
                               });
    neighborhood.insert(position, world.radius(slot));
    inserted.push_back(slot);
  }
  return found;
}

void require_no_overlap(const World& world, const Time& moment, const Progress& progress) {
  const Audit found = audit(world, moment, progress);
  HARDBALL_CHECK(found.not_finite == 0);
  if (found.max_escape > kOverlapTolerance) {
    throw Error("at time " + to_text(moment.value()) + " sphere " + to_text(found.escaped) +
                    " reaches through a wall by " + to_text(found.max_escape) + " of its diameter",
                "start state", "add it at a later time, or farther from the wall");
  }
  if (found.max_overlap <= kOverlapTolerance) return;
  throw Error("spheres " + to_text(found.overlap_first) + " and " + to_text(found.overlap_second) +
                  " overlap by " + to_text(found.max_overlap) + " of the sum of their radii",
              "start state", "move them apart or shrink them");
}

void refuse_overlap(const World& world, const Sphere& sphere, const Time& moment) {
  const double through = sphere.radius - distance_to_surfaces(world, sphere.position, moment);
  if (through > 2 * sphere.radius * kOverlapTolerance) {
    throw Error("the new sphere reaches through a wall by " + to_text(through), "sphere to add",
                "place it elsewhere or shrink it");
  }
  for (Slot slot = 0; slot < world.size(); ++slot) {
    Vec3 separation = world.position(slot, moment) - sphere.position;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!world.box().is_periodic(axis)) continue;
      const double size = world.box().size()[axis];
      separation[axis] -= size * std::round(separation[axis] / size);
    }
    const double overlap = 1 - length(separation) / (sphere.radius + world.radius(slot));
    const bool passes = world.may_pass(sphere.species, world.species(slot)) ||
                        (std::isinf(sphere.mass) && world.is_kinematic(slot));
    if (overlap <= kOverlapTolerance || passes) continue;
    throw Error("the new sphere overlaps sphere " + to_text(world.id(slot)) + " by " + to_text(overlap) +
                    " of the sum of their radii",
                "sphere to add", "place it elsewhere or shrink it");
  }
}

}  // namespace hardball
