// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <unordered_set>
#include <vector>

#include "hardball/world/world.hpp"

namespace hardball {

/// Undoes all changes of a world that came after a moment.
inline void undo_changes(World& world, const Time& last_kept) {
  while (!world.journal().empty() && world.journal().back().time > last_kept) world.undo();
}

/// Takes a forecast back to `moment`, with its world, of which changes up to `last_kept` stay. The spheres
/// that have changed since, and those of other events since then (`handled`, by id), get regions and plans of
/// that moment: of any two spheres one has just predicted, or neither has done anything since. Returns the
/// slots whose plans have changed. Cost: as of what was done since.
template <class Forecast>
std::vector<Slot> rewind(Forecast& forecast, const Time& last_kept, const Time& moment,
                         const std::vector<SphereId>& handled) {
  World& world = forecast.world();
  std::unordered_set<SphereId> without_region;
  const auto drop_region = [&](Slot slot) {
    if (without_region.insert(world.id(slot)).second) forecast.erase(slot);
  };
  std::vector<SphereId> changed = handled;
  std::size_t slots_in_use = world.size();
  while (!world.journal().empty() && world.journal().back().time > last_kept) {
    using Kind = Journal::Kind;
    const Kind kind = world.journal().back().kind;
    const Slot slot = world.journal().back().slot;
    const bool has_changed = kind == Kind::path || kind == Kind::state;
    const SphereId id = has_changed             ? world.id(slot)
                        : kind == Kind::passage ? SphereId{0}
                                                : world.journal().state().id;
    if (has_changed) changed.push_back(id);
    // Either the sphere that was born, or the one that took the place of one that died.
    const bool moves = kind == Kind::birth || kind == Kind::death;
    if (moves && slot < world.size()) drop_region(slot);
    world.undo();
    if (kind == Kind::birth) without_region.erase(id);
    if (kind == Kind::death) without_region.insert(id);
    slots_in_use = std::max(slots_in_use, world.size());
  }
  for (const SphereId id : changed) {
    if (world.contains(id)) drop_region(world.slot_of(id));
  }
  forecast.advance(moment);
  std::vector<Slot> slots;
  for (const SphereId id : without_region) slots.push_back(world.slot_of(id));
  std::ranges::sort(slots);
  for (const Slot slot : slots) forecast.insert(slot);
  for (const Slot slot : slots) forecast.predict(slot);
  for (std::size_t slot = world.size(); slot < slots_in_use; ++slot) slots.push_back(static_cast<Slot>(slot));
  return slots;
}

}  // namespace hardball
