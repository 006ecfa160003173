// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/measure/scene.hpp"
#include "hardball/statistics/qualification.hpp"

namespace hardball {

/// How far the total energy of a start that was drawn at random may be from that of others drawn alike.
///
/// Kinetic energy is prescribed. Potential energy is that of the places, in potentials of steps and under
/// gravity, and energy of rotation that of the spins. A run without losses keeps what it was given, and so
/// settles at another temperature than others.
class RandomStart {
 public:
  RandomStart() = default;
  /// Cost: O(n).
  explicit RandomStart(const Scene& scene);

  /// What that does to means of a run that has come to this scene; nothing if its energy is not conserved.
  StartSpread spread(const Scene& scene) const;

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    archive(self.energy_, self.rotational_energy_, self.variance_of_places_, self.variance_of_spins_);
  }

  double energy_ = 0;              // of all spheres [M L^2 T^-2]
  double rotational_energy_ = 0;   // [M L^2 T^-2]
  double variance_of_places_ = 0;  // of the potential energy [M^2 L^4 T^-4]
  double variance_of_spins_ = 0;   // of the rotational energy [M^2 L^4 T^-4]
};

}  // namespace hardball
