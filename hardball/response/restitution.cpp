// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/response/restitution.hpp"

#include "hardball/errors/error.hpp"

namespace hardball {

Restitution::Restitution(double coefficient) : coefficient_(coefficient) {
  if (coefficient >= 0 && coefficient <= 1) return;
  throw Error("restitution is " + to_text(coefficient), "restitution", "give a number between 0 and 1");
}

Velocities Restitution::bounce(const Contact& contact) const {
  Velocities after = contact.before;
  after.first[axis_of(contact.second)] *= -coefficient_;
  return after;
}

}  // namespace hardball
