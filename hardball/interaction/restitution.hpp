// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include "hardball/errors/export.hpp"
#include "hardball/interaction/contact.hpp"

namespace hardball {

/// The velocities of two smooth spheres after a collision with this coefficient of restitution [1].
/// Precondition: at most one of them is kinematic.
inline Velocities velocities_after_impact(const Contact& contact, double coefficient) {
  const Vec3& first = contact.before.first;
  const Vec3& second = contact.before.second;
  if (!(approach(contact.separation, contact.before) < 0)) return {first, second};
  // The impulse lies along the separation r, whose length is reach up to rounding: dividing by r.r instead
  // of normalizing keeps exact cases exact. Energy drifts unless rounding errors have mean zero, which
  // those of a number that hardly varies from contact to contact do not have. So r, whose length cancels,
  // is scaled by a factor between 1 and 2 that depends on its direction, and no function of the masses
  // alone is rounded.
  const Vec3& separation = contact.separation;
  const Vec3 r = (1 + separation.x * separation.x / dot(separation, separation)) * separation;
  const double square = dot(r, r);
  const double closing = approach(r, contact.before);
  const double masses = square * contact.first_mass + square * contact.second_mass;
  if (!(masses < std::numeric_limits<double>::infinity())) [[unlikely]] {
    const double exchange = (1 + coefficient) * closing / square;
    if (std::isinf(contact.first_mass)) return {first, second - exchange * r};
    return {first + exchange * r, second};
  }
  const double exchange = (1 + coefficient) * closing / masses;
  return {first + (exchange * contact.second_mass) * r, second - (exchange * contact.first_mass) * r};
}

/// The velocity of a smooth sphere after a contact with a wall [L/T], which it leaves with at least
/// `least_speed` [L/T].
HARDBALL_EXPORT Vec3 velocity_after_bounce(const Contact& contact, double coefficient, double least_speed);

/// The least speed with which a sphere leaves a wall that gravity presses it against, if impacts slower than
/// `elastic_below` are elastic [L/T].
inline double least_parting_speed(const Contact& contact, double elastic_below) {
  constexpr double kLeast = 0.1;
  return contact.pressing > 0 ? kLeast * elastic_below : 0;
}

/// Smooth spheres with a constant coefficient of restitution: the speed of separation along the normal is
/// this fraction of the speed of approach, and momentum is kept. One is elastic. Walls may have a coefficient
/// of their own, be rough, or have a temperature: see SurfaceMaterial.
///
/// Slow impacts may be elastic: then spheres that lose energy collide at a bounded rate, and those that come
/// to rest under gravity keep bouncing by a height too small to matter. Source: Luding and McNamara, Granular
/// Matter 1 (1998) 113, on why restitution tends to one for slow impacts.
class HARDBALL_EXPORT Restitution {
 public:
  /// `elastic_below` [L/T]: slower impacts are elastic, and a sphere that gravity presses against a wall
  /// leaves it with at least a tenth of this speed. Error: `coefficient` [1] is not between 0 and 1, or
  /// `elastic_below` negative or not finite.
  explicit Restitution(double coefficient = 1, double elastic_below = 0);

  double coefficient() const { return coefficient_; }
  double elastic_below() const { return elastic_below_; }
  friend bool operator==(const Restitution&, const Restitution&) = default;
  /// The velocities after a contact of smooth bodies.
  Velocities operator()(const Contact& contact) const {
    return contact.is_collision() ? collide(contact) : bounce(contact);
  }
  /// See Response. Walls may be rough.
  bool decide(Contact& contact) const {
    if (!contact.is_collision()) return decide_at_wall(contact);
    contact.after = collide(contact);
    return false;
  }

 private:
  Velocities collide(const Contact& contact) const {
    return velocities_after_impact(contact, elastic_below_ > 0 && is_slow(contact) ? 1 : coefficient_);
  }
  Velocities bounce(const Contact& contact) const;
  bool decide_at_wall(Contact& contact) const;
  bool is_slow(const Contact& collision) const;

  double coefficient_;
  double elastic_below_;
};

static_assert(Response<Restitution>);

}  // namespace hardball
