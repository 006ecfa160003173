// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "hardball/interaction/contact.hpp"
#include "hardball/measure/scene.hpp"
#include "hardball/world/velocity_change.hpp"

namespace hardball {

/// The components xx, yy, zz, xy, xz and yz of a symmetric tensor.
using SymmetricTensor = std::array<double, 6>;

/// Adds the mean of a b and b a to the components of a tensor.
void add_symmetric_product(double* components, const Vec3& a, const Vec3& b);

/// The sum of m v v over all spheres but kinematic ones, as it changes from contact to contact, so that its
/// integral over time is exact. Velocities are relative to the common drift along axes on which momentum is
/// conserved, and to the flow of a sheared box.
class KineticTensor {
 public:
  /// The tensor of no spheres.
  KineticTensor() = default;
  /// The tensor of a scene. Cost: O(n).
  explicit KineticTensor(const Scene& scene);

  /// Lets time pass, and adds the integral of the tensor to `integral`, which has six components [M L^2
  /// T^-1]. Cost: O(1).
  void advance(const Box& box, double elapsed, double* integral);
  /// Accounts for a contact, or another change of a velocity, at the time that it has advanced to. Cost:
  /// O(1).
  void record(const Box& box, const Contact& contact);
  void record(const Box& box, const VelocityChange& change);

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    archive(self.mass_, self.drift_, self.components_, self.momentum_, self.gravity_, self.has_drift_);
  }

  void change(double mass, const Vec3& before, const Vec3& after);

  double mass_ = 0;               // of all spheres [M]
  Vec3 drift_;                    // at present [L/T]
  SymmetricTensor components_{};  // [M L^2 T^-2]
  Vec3 momentum_;                 // relative to the drift [M L/T]
  Vec3 gravity_;                  // [L/T^2]
  std::array<bool, kAxes> has_drift_{true, true, true};
};

}  // namespace hardball
