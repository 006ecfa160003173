// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/response/collapse_guard.hpp"

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// A sphere that moves less than this fraction of its radius between contacts stands still as far as its
// position can tell.
constexpr double kHardlyMoved = 1e-15;
constexpr std::uint32_t kMostIdleContacts = 10000;

}  // namespace

void CollapseGuard::note_contact(const World& world, Slot slot, const Time& now) {
  const Path& path = world.path(slot);
  const double time = duration(path.time, now);
  const double least = kHardlyMoved * world.radius(slot);
  if (dot(path.velocity, path.velocity) * time * time > least * least) {
    if (!idle_contacts_.empty()) idle_contacts_.erase(world.id(slot));
    return;
  }
  const SphereId id = world.id(slot);
  if (++idle_contacts_[id] < kMostIdleContacts) return;
  throw RunFailure("inelastic collapse: sphere " + to_text(id) + " was hit " + to_text(kMostIdleContacts) +
                   " times in a row without moving, at time " + to_text(now.value()) +
                   "; raise the restitution or give it room to move");
}

std::size_t CollapseGuard::memory_bytes() const {
  constexpr std::size_t kNode = 2 * sizeof(void*) + sizeof(decltype(idle_contacts_)::value_type);
  return idle_contacts_.size() * kNode + idle_contacts_.bucket_count() * sizeof(void*);
}

}  // namespace hardball
