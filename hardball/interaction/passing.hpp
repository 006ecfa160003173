// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/events/event.hpp"
#include "hardball/interaction/contact.hpp"

namespace hardball {

/// Spheres that pass through each other: their contact is recorded, and deflects neither. A custom response
/// is not called for them.
struct Passing {
  bool decide(Contact& contact) const {
    contact.outcome = ContactOutcome::pass;
    return false;
  }

  static void persist(auto& /*archive*/, auto& /*self*/) {}
};

static_assert(Response<Passing>);

/// Whether two spheres that pass through each other are already inside each other at a time from which on
/// their paths do not change, at which they are `separation` [L] apart: then they do not touch.
inline bool are_inside(const Vec3& separation, double reach) {
  return dot(separation, separation) <= reach * reach;
}

/// Whether the contact of two spheres that pass through each other has been recorded, `last` being the last
/// such contact. An engine may know it by another image: the spheres and the time identify it.
inline bool is_recorded(Event contact, const Event& last) {
  contact.image = last.image;
  return contact <= last;
}

}  // namespace hardball
