// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/response/contact.hpp"

namespace hardball {

/// Smooth spheres with a constant coefficient of restitution: the speed of separation along the normal is
/// this fraction of the speed of approach, and momentum is kept. One is elastic.
class Restitution {
 public:
  /// Error: `coefficient` [1] is not between 0 and 1.
  explicit Restitution(double coefficient = 1);

  double coefficient() const { return coefficient_; }
  Velocities operator()(const Contact& contact) const {
    return contact.is_collision() ? collide(contact) : bounce(contact);
  }

 private:
  Velocities collide(const Contact& contact) const {
    Velocities after = contact.before;
    // The impulse lies along the separation r, of length reach up to rounding: dividing by r.r instead of
    // normalising keeps exact cases exact.
    const Vec3& r = contact.separation;
    const double approaching = approach(r, contact.before);
    if (!(approaching < 0)) return after;
    const double exchange = (1 + coefficient_) * (approaching / dot(r, r));
    const double total_mass = contact.first_mass + contact.second_mass;
    after.first += (exchange * (contact.second_mass / total_mass)) * r;
    after.second -= (exchange * (contact.first_mass / total_mass)) * r;
    return after;
  }
  Velocities bounce(const Contact& contact) const;

  double coefficient_;
};

static_assert(Response<Restitution>);

}  // namespace hardball
