// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/response/restitution.hpp"

#include "hardball/errors/error.hpp"

namespace hardball {

Restitution::Restitution(double coefficient) : coefficient_(coefficient) {
  if (coefficient >= 0 && coefficient <= 1) return;
  throw Error("restitution is " + to_text(coefficient), "restitution", "give a number between 0 and 1");
}

Velocities Restitution::operator()(const Contact& contact) const {
  Velocities after = contact.before;
  if (!contact.is_collision()) {
    const std::size_t axis = axis_of(contact.second);
    after.first[axis] *= -coefficient_;
    return after;
  }
  // The impulse lies along the separation r, of length reach up to rounding: dividing by r.r instead of
  // normalising keeps exact cases exact.
  const Vec3& r = contact.separation;
  const double approach = dot(r, contact.before.second - contact.before.first);
  if (!(approach < 0)) return after;
  const double exchange = (1 + coefficient_) * (approach / dot(r, r));
  const double total_mass = contact.first_mass + contact.second_mass;
  after.first += (exchange * (contact.second_mass / total_mass)) * r;
  after.second -= (exchange * (contact.first_mass / total_mass)) * r;
  return after;
}

}  // namespace hardball
