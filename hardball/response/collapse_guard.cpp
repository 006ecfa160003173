// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/response/collapse_guard.hpp"

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

constexpr std::uint32_t kMostIdleContacts = 10000;

}  // namespace

void CollapseGuard::count(SphereId id, bool was_idle, const Time& now) {
  if (!was_idle) {
    idle_contacts_.erase(id);
    return;
  }
  if (++idle_contacts_[id] < kMostIdleContacts) return;
  throw RunFailure(
      "inelastic collapse: sphere " + to_text(id) + " was hit " + to_text(kMostIdleContacts) +
      " times in a row without moving, at time " + to_text(now.value()) +
      "; make slow impacts elastic (elastic_below) or those that follow another at once (contact_duration), "
      "raise the restitution, or end the run before this time");
}

std::size_t CollapseGuard::memory_bytes() const {
  constexpr std::size_t kNode = 2 * sizeof(void*) + sizeof(decltype(idle_contacts_)::value_type);
  return idle_contacts_.size() * kNode + idle_contacts_.bucket_count() * sizeof(void*);
}

}  // namespace hardball
