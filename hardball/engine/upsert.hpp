// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "hardball/engine/prefetching.hpp"
#include "hardball/world/sphere_edit.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The path and the spin [1/T] of a sphere according to another world with the same box.
struct NewPath {
  Slot slot = 0;
  Path path;
  Vec3 spin;
};

/// Predicts spheres in turn, and schedules them.
template <class Forecast, class Queue>
void predict_all(Forecast& forecast, Queue& queue, std::span<const Slot> slots) {
  for (std::size_t i = 0; i < slots.size(); ++i) {
    Prefetching::prefetch_prediction(forecast, slots, i);
    forecast.predict(slots[i]);
    queue.schedule(slots[i], forecast);
  }
}

/// Makes spheres of a forecast what they are in another world with the same box, as of its time: those that
/// it has are replaced, and the others added. They get regions; appends their slots, which remain to be
/// predicted. Returns whether all could be inserted; if not, the forecast must be rebuilt. Cost: as of a
/// collision each.
template <class Forecast>
bool upsert_spheres(Forecast& forecast, std::span<const SphereState> spheres, bool are_all_inserted,
                    std::vector<Slot>& slots) {
  World& world = forecast.world();
  for (const SphereState& sphere : spheres) {
    Slot slot;
    if (const std::optional<Slot> stored = world.find(sphere.id)) {
      slot = *stored;
      if (are_all_inserted) forecast.erase(slot);
      SphereEdit(world, forecast.now(), slot).store(slot, sphere);
    } else {
      slot = world.insert(sphere);
    }
    are_all_inserted = are_all_inserted && forecast.admits(slot);
    if (are_all_inserted) forecast.insert(slot);
    slots.push_back(slot);
  }
  return are_all_inserted;
}

/// Puts spheres on other paths, as of the time of the forecast, and appends their slots, which remain to be
/// predicted. Without regions, they get none. Cost: half of a collision each, if they stay in their regions.
template <class Forecast>
void replace_paths(Forecast& forecast, std::span<const NewPath> paths, bool have_regions,
                   std::vector<Slot>& slots) {
  constexpr std::size_t kAhead = 6;
  World& world = forecast.world();
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (i + kAhead < paths.size()) forecast.prefetch_sphere(paths[i + kAhead].slot);
    const auto& [slot, path, spin] = paths[i];
    SphereEdit edit(world, forecast.now(), slot);
    edit.store_path(slot, path, Image());
    if (world.spin(slot) != spin) edit.store_spin(slot, spin);
    if (have_regions) forecast.note_moved(slot);
    slots.push_back(slot);
  }
}

}  // namespace hardball
