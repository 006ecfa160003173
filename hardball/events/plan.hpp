// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "hardball/events/event.hpp"

namespace hardball {

/// What comes next for a sphere: its crossing, and its prospect, which is a contact or a bound of it.
struct alignas(32) Plan {
  double contact = kNever.high;   ///< The bound, or the high part of the time of the contact [T].
  double crossing = kNever.high;  ///< Or any time after the contact [T].
  double limit_or_low = 0;        ///< The limit of a bound, or the low part of the time of the contact [T].
  std::uint32_t partner = 0;      ///< A slot, or the number of a wall.
  std::uint32_t tag = 0;          ///< The revision of the partner's path, and of these bits any:

  static constexpr std::uint32_t kExact = 1;     ///< Not a bound.
  static constexpr std::uint32_t kWall = 2;      ///< The contact is with a wall.
  static constexpr std::uint32_t kRenewal = 4;   ///< The crossing only copies the path again.
  static constexpr std::uint32_t kRevision = 8;  ///< Revisions are multiples of it.

  double time() const { return std::min(contact, crossing); }
  bool crosses_first() const { return crossing <= contact; }
  bool is_bound() const { return (tag & kExact) == 0; }
  bool is_wall() const { return (tag & kWall) != 0; }
  bool is_renewal() const { return (tag & kRenewal) != 0; }
  bool has_seen(std::uint32_t revision) const { return (tag ^ revision) < kRevision; }
  /// A sphere at rest may have neither crossing nor contact.
  bool will_cross_first() const { return crosses_first() && crossing < kNever.high; }
  bool meets_first() const { return !crosses_first() && !is_wall(); }
  /// The time of an exact contact.
  Time moment() const { return {contact, limit_or_low}; }

  void set_bound(double time, double limit, Slot with, std::uint32_t revision) {
    contact = time;
    limit_or_low = limit;
    partner = with;
    tag = revision;
  }
  void set_collision(const Time& time, Slot with, std::uint32_t revision) {
    set_bound(time.high, time.low, with, revision | kExact);
  }
  void set_wall(const Time& time, std::uint32_t wall) {
    set_bound(time.high, time.low, wall, kExact | kWall);
  }
};
static_assert(sizeof(Plan) == 32);

}  // namespace hardball
