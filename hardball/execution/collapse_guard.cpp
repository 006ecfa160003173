// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/execution/collapse_guard.hpp"

#include <algorithm>
#include <cmath>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

constexpr std::uint32_t kMaxIdleContacts = 10000;

double largest_coordinate(const Vec3& place) {
  return std::max({std::fabs(place.x), std::fabs(place.y), std::fabs(place.z)});
}

}  // namespace

bool have_not_parted(const Contact& contact) {
  const double flight = contact.flight();
  const double radius =
      contact.is_collision() ? std::min(contact.first_radius, contact.second_radius) : contact.first_radius;
  const auto way = [flight](const Vec3& velocity) { return length(velocity) * flight; };
  if (std::max(way(contact.before.first), way(contact.before.second)) > kHardlyMoved * radius) return false;
  // Rounding of places opens gaps of a few units in the last place.
  constexpr double kResolution = 0x1p-48;
  const double coordinate =
      std::max(largest_coordinate(contact.position), largest_coordinate(contact.second_position));
  const Vec3 normal = contact.normal();
  const double closing = dot(contact.before.first - contact.before.second, normal) + contact.growth;
  if (closing * flight > kResolution * (coordinate + contact.reach)) return false;
  constexpr double kElastic = 1 - 1e-6;
  constexpr double kRounding = 1e-14;
  const double opening = dot(contact.after.second - contact.after.first, normal) - contact.growth;
  return opening < kElastic * closing ||
         closing <= kRounding * (length(contact.before.first) + length(contact.before.second));
}

void CollapseGuard::count(const Contact& contact) {
  const bool is_idle = have_not_parted(contact);
  count(contact.first, is_idle, contact);
  if (contact.is_collision()) count(contact.second, is_idle, contact);
}

void CollapseGuard::count(SphereId id, bool is_idle, const Contact& contact) {
  const Time& now = contact.time;
  if (!is_idle) {
    // What creeps along may be hit now and then.
    constexpr std::uint32_t kMadeUp = 100;
    const auto counted = idle_contacts_.find(id);
    if (counted == idle_contacts_.end()) return;
    if (has_journal_) changes_.push_back({now, id, counted->second});
    if (counted->second <= kMadeUp) {
      idle_contacts_.erase(counted);
    } else {
      counted->second -= kMadeUp;
    }
    return;
  }
  if (has_journal_) changes_.push_back({now, id, idle_contacts_[id]});
  if (++idle_contacts_[id] < kMaxIdleContacts) return;
  if (contact.pressing > 0 && contact.before.first == contact.before.second) {
    throw RunFailure("sphere " + to_text(id) + " lies still, pressed against what does not move, at time " +
                     to_text(now.value()) +
                     ", and hard spheres bear a weight only by contacts; let it bounce (settle, or "
                     "elastic_below), or place it higher");
  }
  throw RunFailure("inelastic collapse: sphere " + to_text(id) + " was hit " + to_text(kMaxIdleContacts) +
                   " times without separating from what hit it, at time " + to_text(now.value()) +
                   "; let heaps settle (settle), make those impacts elastic that follow another at once "
                   "(contact_duration) or are slow (elastic_below), "
                   "by larger values if they are set, raise the restitution, or " +
                   (now.value() > 0 ? "end the run before this time"
                                    : "place spheres that touch at the start farther apart"));
}

void CollapseGuard::rewind(const Time& moment) {
  for (; !changes_.empty() && changes_.back().time > moment; changes_.pop_back()) {
    const Change& change = changes_.back();
    if (change.before == 0) {
      idle_contacts_.erase(change.sphere);
    } else {
      idle_contacts_[change.sphere] = change.before;
    }
  }
}

std::size_t CollapseGuard::memory_bytes() const {
  constexpr std::size_t kNode = 2 * sizeof(void*) + sizeof(decltype(idle_contacts_)::value_type);
  return idle_contacts_.size() * kNode + idle_contacts_.bucket_count() * sizeof(void*);
}

}  // namespace hardball
