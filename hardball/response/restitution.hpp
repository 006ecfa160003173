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
    if (!(approach(contact.separation, contact.before) < 0)) return after;
    // The impulse lies along the separation r, whose length is reach up to rounding: dividing by r.r instead
    // of normalising keeps exact cases exact. Energy drifts unless rounding errors have mean zero, which
    // those of a number that hardly varies from contact to contact do not have. So r, whose length cancels,
    // is scaled by a factor between 1 and 2 that depends on its direction, and no function of the masses
    // alone is rounded.
    const Vec3& separation = contact.separation;
    const Vec3 r = (1 + separation.x * separation.x / dot(separation, separation)) * separation;
    const double square = dot(r, r);
    const double exchange = (1 + coefficient_) * approach(r, contact.before) /
                            (square * contact.first_mass + square * contact.second_mass);
    after.first += (exchange * contact.second_mass) * r;
    after.second -= (exchange * contact.first_mass) * r;
    return after;
  }
  Velocities bounce(const Contact& contact) const;

  double coefficient_;
};

static_assert(Response<Restitution>);

}  // namespace hardball
