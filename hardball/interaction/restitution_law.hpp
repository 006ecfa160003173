// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <variant>
#include <vector>

#include "hardball/errors/export.hpp"

namespace hardball {

/// A coefficient of restitution that does not depend on the impact speed [1].
struct ConstantRestitution {
  double value = 1;

  double at(double) const { return value; }
  static void persist(auto& archive, auto& self) { archive(self.value); }
};

/// The coefficient of restitution of viscoelastic spheres, which is one at zero impact speed and decreases as
/// 1 - 1.15344 b u^(1/5) at first. Source: Mueller and Poeschel, Phys. Rev. E 84 (2011) 021302.
class HARDBALL_EXPORT ViscoelasticRestitution {
 public:
  /// A law with the coefficient `value` [1] at the impact speed `speed` [L/T]. Error: `value` is not between
  /// 0 and 1, or too small to be reached; `speed` is not positive.
  ViscoelasticRestitution(double value, double speed);

  /// At an impact speed [L/T].
  double at(double speed) const;
  /// The impact speed at which the coefficient was given [L/T].
  double speed() const { return speed_; }
  /// This law where all speeds are multiplied by `factor`.
  ViscoelasticRestitution scaled(double factor) const;

 private:
  friend class Persistence;
  ViscoelasticRestitution() = default;
  static void persist(auto& archive, auto& self) { archive(self.speed_, self.unit_); }
  // Elastic impacts have the unit zero.
  bool restored() const { return speed_ > 1e-200 && speed_ < 1e200 && unit_ >= 0 && unit_ <= 16; }

  double speed_;  // at which `unit_` is the reduced speed
  double unit_;
};

/// A coefficient of restitution that is linear between given points, and constant before the first and after
/// the last.
class HARDBALL_EXPORT TabulatedRestitution {
 public:
  struct Point {
    double speed;  ///< Impact speed [L/T].
    double value;  ///< [1]
    static void persist(auto& archive, auto& self) { archive(self.speed, self.value); }
  };

  /// Error: there are no points, speeds do not increase, or a value is not between 0 and 1.
  explicit TabulatedRestitution(std::vector<Point> points);

  double at(double speed) const;
  /// In the order of speeds; at least one.
  const std::vector<Point>& points() const { return points_; }
  TabulatedRestitution scaled(double factor) const;

 private:
  friend class Persistence;
  TabulatedRestitution() = default;
  static void persist(auto& archive, auto& self) { archive(self.points_); }
  bool restored() {
    *this = TabulatedRestitution(std::move(points_));
    return true;
  }

  std::vector<Point> points_;
};

/// How the coefficient of restitution depends on the impact speed: each kind has `at(speed)`.
using RestitutionLaw = std::variant<ConstantRestitution, ViscoelasticRestitution, TabulatedRestitution>;

/// Error: `value` [1] is not between 0 and 1.
HARDBALL_EXPORT void check_restitution(double value);

}  // namespace hardball
