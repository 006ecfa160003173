// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/time.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// An oscillation along a line: after the time t, bodies are displaced by amplitude * sin(2 pi frequency t).
class HARDBALL_EXPORT Oscillation {
 public:
  static constexpr std::string_view kName = "oscillation";

  /// `direction` may have any length; amplitude [L]; frequency [1/T]. Error: a number is not finite or out of
  /// range; the direction has no length; the amplitude is not positive; the frequency is zero.
  Oscillation(const Vec3& direction, double amplitude, double frequency);

  const Vec3& direction() const { return direction_; }  ///< A unit vector [1].
  double amplitude() const { return amplitude_; }
  double frequency() const { return frequency_; }

  /// How far all bodies have moved after `elapsed` [L].
  Vec3 displacement(const Time& elapsed) const;
  /// The greatest acceleration [L/T^2].
  double acceleration() const;
  /// A vector with a component of zero along the axes of space along which bodies do not move.
  Vec3 span() const { return direction_; }

 private:
  friend class Persistence;
  Oscillation() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.direction_, self.amplitude_, self.frequency_);
  }
  bool restored() const;

  Vec3 direction_;
  double amplitude_ = 0;
  double frequency_ = 0;
};

}  // namespace hardball
