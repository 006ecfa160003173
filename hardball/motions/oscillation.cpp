// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/motions/oscillation.hpp"

#include "hardball/geometry/range.hpp"
#include "hardball/motions/check_motion.hpp"
#include "hardball/surfaces/sine.hpp"

namespace hardball {

Oscillation::Oscillation(const Vec3& direction, double amplitude, double frequency)
    : direction_(direction_of_motion(direction, "direction")), amplitude_(amplitude), frequency_(frequency) {
  check_positive(amplitude, "amplitude", "motion");
  check_motion_frequency(frequency);
}

Vec3 Oscillation::displacement(const Time& elapsed) const {
  return (amplitude_ * circular(frequency_, elapsed).sine.high) * direction_;
}

double Oscillation::acceleration() const {
  const double turning = kTurnOfMotion * frequency_;
  return turning * turning * amplitude_;
}

bool Oscillation::restored() const {
  check_positive(amplitude_, "amplitude", "motion");
  check_motion_frequency(frequency_);
  return is_direction_of_motion(direction_);
}

}  // namespace hardball
