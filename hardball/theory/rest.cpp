// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/theory/rest.hpp"

#include <cmath>
#include <numbers>

namespace hardball {
namespace {

// Of a sphere of the mean volume, or a disc of the mean area.
double diameter_of(double volume, bool is_flat) {
  return is_flat ? std::sqrt(4 * volume / std::numbers::pi) : std::cbrt(6 * volume / std::numbers::pi);
}

}  // namespace

Rest::Rest(const Totals& totals, std::size_t spheres, bool is_flat, double gravity) {
  const double diameter = diameter_of(totals.sphere_volume.value() / static_cast<double>(spheres), is_flat);
  lift_ = gravity * diameter;
  interval_ = 2 * std::sqrt(diameter / gravity);
}

double Rest::next_look(double now) const {
  double looks = std::floor(now / interval_) + 1;
  while (looks * interval_ <= now) ++looks;
  return looks * interval_;
}

bool Rest::is_time_to_look(double time) const {
  return time > 0 && std::round(time / interval_) * interval_ == time;
}

bool Rest::is_reached(const Totals& totals) const {
  constexpr double kEnergy = 0.01;
  constexpr double kSquareOfSpeed = 0.4;
  return totals.kinetic_energy.value() < kEnergy * totals.mass.value() * lift_ &&
         totals.highest_speed * totals.highest_speed < kSquareOfSpeed * lift_;
}

}  // namespace hardball
