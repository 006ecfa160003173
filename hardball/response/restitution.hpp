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
  Velocities operator()(const Contact& contact) const;

 private:
  double coefficient_;
};

static_assert(Response<Restitution>);

}  // namespace hardball
