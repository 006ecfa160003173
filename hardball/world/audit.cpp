// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/audit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "hardball/errors/error.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/pair_event.hpp"
#include "hardball/world/static_hash_grid.hpp"
#include "hardball/world/step_levels.hpp"
#include "hardball/world/walls.hpp"

namespace hardball {
namespace {

bool is_finite(const Vec3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

void note_escape(const World& world, Slot slot, const Vec3& position, const Time& moment, Audit& found) {
  const double radius = world.radius(slot, moment);
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

// From one center to the nearest image of another, from folded positions.
Vec3 nearest_separation(const World& world, Slot from, Slot to, const Time& moment) {
  const Vec3 separation = world.position(to, moment) - world.position(from, moment);
  return separation + world.box().shift(world.box().nearest_image(-separation, moment), moment);
}

}  // namespace

std::vector<Slot> all_slots(const World& world) {
  std::vector<Slot> slots(world.size());
  std::iota(slots.begin(), slots.end(), Slot{0});
  return slots;
}

Audit audit(const World& world, const Time& moment, const Progress& progress) {
  Audit found;
  std::vector<Slot> by_size = all_slots(world);
  if (!world.base_radii().is_common()) {
    std::stable_sort(by_size.begin(), by_size.end(),
                     [&](Slot a, Slot b) { return world.base_radius(a) > world.base_radius(b); });
  }
  const bool may_overlap = has_passing_pairs(world) || world.has_steps();
  StaticHashGrid neighborhood(world.box(), world.size(), world.largest_radius(), moment);
  std::vector<Slot> inserted;
  inserted.reserve(world.size());
  std::size_t seen = 0;
  for (const Slot slot : by_size) {
    progress.record(seen++, by_size.size());
    const Path& path = world.path(slot);
    if (!is_finite(path.position) || !is_finite(path.velocity)) {
      ++found.not_finite;
      continue;
    }
    const Vec3 position = world.position(slot, moment);
    note_escape(world, slot, position, moment, found);
    neighborhood.for_each_near(
        position, world.radius(slot, moment), [&](std::uint32_t index, const Vec3& separation, double reach) {
          // With a margin for rounding; most neighbors are farther away.
          if (dot(separation, separation) > 1.001 * (reach * reach)) return;
          const double core = may_overlap ? core_ratio(world, slot, inserted[index]) : 1;
          const double overlap = 1 - length(separation) / (core * reach);
          if (!(overlap > found.max_overlap)) return;
          found.max_overlap = overlap;
          found.overlap_first = std::min(world.id(slot), world.id(inserted[index]));
          found.overlap_second = std::max(world.id(slot), world.id(inserted[index]));
        });
    neighborhood.insert(position, world.radius(slot, moment));
    inserted.push_back(slot);
  }
  return found;
}

void require_no_overlap(const World& world, const Time& moment, const Progress& progress) {
  require_sound(audit(world, moment, progress), moment);
}

void require_sound(const Audit& found, const Time& moment) {
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

void require_room(const World& world, Slot added, std::span<const Slot> others, const Time& moment) {
  const double through =
      world.radius(added, moment) - distance_to_surfaces(world, world.position(added, moment), moment);
  if (through > 2 * world.radius(added, moment) * kOverlapTolerance) {
    throw Error("the new sphere reaches through a wall by " + to_text(through), "sphere to add",
                "place it elsewhere or shrink it");
  }
  std::optional<SphereId> in_the_way;
  double its_overlap = 0;
  for (const Slot other : others) {
    if (other == added) continue;
    const double reach =
        core_ratio(world, added, other) * (world.radius(added, moment) + world.radius(other, moment));
    const double overlap = 1 - length(nearest_separation(world, added, other, moment)) / reach;
    if (!(overlap > kOverlapTolerance) || (in_the_way && world.id(other) >= *in_the_way)) continue;
    in_the_way = world.id(other);
    its_overlap = overlap;
  }
  if (!in_the_way) return;
  throw Error("the new sphere overlaps sphere " + to_text(*in_the_way) + " by " + to_text(its_overlap) +
                  " of the sum of their radii",
              "sphere to add", "place it elsewhere or shrink it");
}

std::vector<Event> overlaps_of(const World& world, Slot slot, std::span<const Slot> others, const Time& now) {
  std::vector<Event> overlaps;
  for (const Slot other : others) {
    if (other == slot || pass(world, slot, other)) continue;
    const Image image = nearest_image(world, slot, other, now);
    const Vec3 separation = relative_state(world, slot, other, image, now).position;
    const double reach = world.radius(slot, now) + world.radius(other, now);
    if (!(dot(separation, separation) < reach * reach)) continue;
    overlaps.push_back(make_collision(now, world.id(slot), world.id(other), image));
  }
  ranges::sort(overlaps);
  overlaps.erase(std::unique(overlaps.begin(), overlaps.end()), overlaps.end());
  return overlaps;
}

}  // namespace hardball
