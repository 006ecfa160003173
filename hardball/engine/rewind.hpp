// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <unordered_set>
#include <vector>

#include "hardball/engine/engine_journal.hpp"
#include "hardball/engine/prefetching.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Undoes all changes of a world that came after a moment.
inline void undo_changes(World& world, const Time& last_kept) {
  while (!world.journal().empty() && world.journal().back().time > last_kept) world.undo();
}

/// Takes a forecast back to `moment`, with its world, of which changes up to `last_kept` stay. The spheres
/// that have changed since, and those of other events since then (`handled`), get regions and plans of that
/// moment: of any two spheres one has just predicted, or neither has done anything since. Returns the slots
/// whose plans have changed. Cost: as of what was done since.
template <class Forecast>
std::vector<Slot> rewind(Forecast& forecast, const Time& last_kept, const Time& moment,
                         std::vector<StoredSphere> handled) {
  World& world = forecast.world();
  std::unordered_set<SphereId> moved;  // by births and deaths: they have no regions
  std::size_t slots_in_use = world.size();
  while (!world.journal().empty() && world.journal().back().time > last_kept) {
    using Kind = Journal::Kind;
    const Kind kind = world.journal().back().kind;
    const Slot slot = world.journal().back().slot;
    if (kind == Kind::path || kind == Kind::state) handled.push_back({world.id(slot), slot});
    const bool moves = kind == Kind::birth || kind == Kind::death;
    // Either the sphere that was born, or the one that took the place of one that died.
    if (moves && slot < world.size() && moved.insert(world.id(slot)).second) forecast.erase(slot);
    const SphereId id = moves ? world.journal().state().id : SphereId{0};
    world.undo();
    if (kind == Kind::birth) moved.erase(id);
    if (kind == Kind::death) moved.insert(id);
    slots_in_use = std::max(slots_in_use, world.size());
  }
  std::vector<Slot> slots;
  slots.reserve(handled.size() + moved.size());
  for (const StoredSphere& sphere : handled) {
    if (const std::optional<Slot> slot = world.find(sphere.id, sphere.slot)) slots.push_back(*slot);
  }
  for (const SphereId id : moved) slots.push_back(world.slot_of(id));
  ranges::sort(slots);
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
  for (const Slot slot : slots) {
    if (moved.empty() || !moved.contains(world.id(slot))) forecast.erase(slot);
  }
  forecast.advance(moment);
  for (const Slot slot : slots) forecast.insert(slot);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    Prefetching::prefetch_prediction(forecast, slots, i);
    forecast.predict(slots[i]);
  }
  for (std::size_t slot = world.size(); slot < slots_in_use; ++slot) slots.push_back(static_cast<Slot>(slot));
  return slots;
}

}  // namespace hardball
