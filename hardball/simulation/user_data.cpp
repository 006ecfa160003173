// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/simulation/user_data.hpp"

#include <algorithm>
#include <functional>

namespace hardball {

std::uint64_t UserData::get(SphereId id) const {
  const auto found = std::ranges::lower_bound(entries_, id, {}, &Entry::id);
  return found != entries_.end() && found->id == id ? found->data : 0;
}

void UserData::set(const World& world, SphereId id, std::uint64_t data) {
  // Ids count up: those of spheres added since follow at the end.
  if (entries_.empty() || entries_.back().id < id) {
    const SphereId next = entries_.empty() ? 0 : entries_.back().id + 1;
    world.for_each_by_id([&](Slot slot) {
      if (world.id(slot) >= next) entries_.push_back({world.id(slot), 0});
    });
  }
  std::ranges::lower_bound(entries_, id, {}, &Entry::id)->data = data;
}

void UserData::remove(SphereId id) {
  const auto found = std::ranges::lower_bound(entries_, id, {}, &Entry::id);
  if (found != entries_.end() && found->id == id) entries_.erase(found);
}

bool UserData::restored() const {
  return std::ranges::is_sorted(entries_, std::ranges::less_equal(), &Entry::id);
}

}  // namespace hardball
