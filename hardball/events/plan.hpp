// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "hardball/events/event.hpp"

namespace hardball {

/// What comes next for a sphere: its crossing, and its planned contact.
///
/// A planned contact is exact, with a sphere or a wall; or a bound, before which the sphere touches nothing,
/// and a time until which it is safe from all but its partner; or, if there is no partner, a time before
/// which nothing happens and after which nothing is known.
class alignas(32) Plan {
 public:
  /// Revisions of paths are multiples of it.
  static constexpr std::uint32_t kRevision = 8;

  /// The earlier of both times [T].
  double time() const { return std::min(contact_, crossing_); }
  /// The time of the contact, to the nearest double, or its bound [T].
  double contact() const { return contact_; }
  /// [T], or any time after the contact.
  double crossing() const { return crossing_; }
  /// The safe-until time of a bound: no contact comes before it but with the partner [T].
  double safe_until() const { return safe_until_or_low_; }
  /// The time of a contact.
  Time contact_time() const { return {contact_, safe_until_or_low_}; }
  /// The slot of the sphere met. Precondition: has_partner().
  Slot partner() const { return partner_; }
  /// The number of the wall met. Precondition: meets_wall().
  std::uint32_t wall() const { return partner_; }

  bool crosses_first() const { return crossing_ <= contact_; }
  /// Whether the planned contact is not exact.
  bool is_bound() const { return (tag_ & kExact) == 0; }
  bool has_partner() const { return (tag_ & kNoPartner) == 0; }
  bool meets_wall() const { return (tag_ & kKind) == (kExact | kNoPartner); }
  /// Whether the planned contact is a bound of the contact with a partner.
  bool is_bounded_pair() const { return (tag_ & kKind) == 0; }
  /// Whether only a time is known before which nothing happens.
  bool is_unknown() const { return (tag_ & kKind) == kNoPartner; }
  /// Whether the crossing only copies the path again.
  bool is_renewal() const { return (tag_ & kRenewal) != 0; }
  /// Whether this revision of the partner's path is the one predicted with. Precondition: has_partner().
  bool has_seen(std::uint32_t revision) const { return (tag_ ^ revision) < kRevision; }
  /// A sphere at rest may have neither crossing nor contact.
  bool will_cross_first() const { return crosses_first() && crossing_ < kNever.high; }
  bool meets_first() const { return !crosses_first() && has_partner(); }

  void set_bound(double time, double safe_until, Slot partner, std::uint32_t revision) {
    contact_ = time;
    safe_until_or_low_ = safe_until;
    partner_ = partner;
    tag_ = revision;
  }
  void set_collision(const Time& time, Slot partner, std::uint32_t revision) {
    set_bound(time.high, time.low, partner, revision | kExact);
  }
  void set_wall(const Time& time, std::uint32_t wall) {
    set_bound(time.high, time.low, wall, kExact | kNoPartner);
  }
  /// Sets a bound without a partner: nothing happens before `time`. The crossing does not change.
  void set_unknown(double time) { set_bound(time, time, 0, kNoPartner | (tag_ & kRenewal)); }
  /// Replaces a bound by the contact with the partner; returns false if that may not be the earliest, and
  /// then the bound stays.
  bool refine(const Time& contact) {
    if (!(contact.high < safe_until_or_low_)) return false;
    contact_ = contact.high;
    safe_until_or_low_ = contact.low;
    tag_ |= kExact;
    return true;
  }
  /// Lowers the safe-until time: other candidates may be met from `time` on. Precondition: a bound.
  void lower_safe_until(double time) { safe_until_or_low_ = std::min(safe_until_or_low_, time); }
  void set_crossing(double time) {
    crossing_ = time;
    tag_ &= ~kRenewal;
  }
  void set_renewal(double time) {
    crossing_ = time;
    tag_ |= kRenewal;
  }
  /// Lets the revision predicted with pass for another one.
  void forget_revision() { tag_ ^= kRevision; }

 private:
  static constexpr std::uint32_t kExact = 1;
  static constexpr std::uint32_t kNoPartner = 2;
  static constexpr std::uint32_t kKind = kExact | kNoPartner;
  static constexpr std::uint32_t kRenewal = 4;

  double contact_ = kNever.high;
  double crossing_ = kNever.high;
  double safe_until_or_low_ = 0;  // of a contact, the low part of its time
  std::uint32_t partner_ = 0;     // or the wall
  std::uint32_t tag_ = 0;         // the revision of the partner's path, and the bits above
};
static_assert(sizeof(Plan) == 32);

}  // namespace hardball
