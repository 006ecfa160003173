// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/execution/follow.hpp"

#include "hardball/world/sphere_edit.hpp"

namespace hardball {

void follow(World& world, const Contact& contact) {
  if (contact.outcome == ContactOutcome::pass)
    return world.note_passage({contact.time, contact.kind, contact.first, contact.second, contact.image});
  const Slot first = world.slot_of(contact.first);
  world.rewrite_path(first, contact.time, contact.after.first);
  if (contact.is_collision())
    world.rewrite_path(world.slot_of(contact.second), contact.time, contact.after.second);
  if (contact.spins_after == contact.spins_before) return;
  SphereEdit(world, contact.time, first).store_spin(first, contact.spins_after.first);
  if (!contact.is_collision()) return;
  const Slot second = world.slot_of(contact.second);
  SphereEdit(world, contact.time, second).store_spin(second, contact.spins_after.second);
}

}  // namespace hardball
