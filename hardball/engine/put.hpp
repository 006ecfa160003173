// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "hardball/world/sphere_edit.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Makes spheres of a forecast what they are in another world with the same box, as of its time: those that
/// it has are replaced, and the others added. They get regions; appends their slots, which remain to be
/// predicted. Returns whether all could be inserted; if not, the forecast must be rebuilt. Cost: as of a
/// collision each.
template <class Forecast>
bool put(Forecast& forecast, std::span<const SphereState> spheres, bool are_all_inserted,
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

}  // namespace hardball
