// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/fluid_theory.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "hardball/tuning/kinetic_theory.hpp"

namespace hardball {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kPi = std::numbers::pi;

// `xi` holds pi / 6 times the number density times the mean k-th power of the diameter.
double mixture_compressibility(const std::array<double, 4>& xi) {
  const double free = 1 - xi[3];
  return 1 / free + 3 * xi[1] * xi[2] / (xi[0] * free * free) +
         xi[2] * xi[2] * xi[2] * (3 - xi[3]) / (xi[0] * free * free * free);
}

}  // namespace

double fluid_compressibility(double packing_fraction) {
  struct Term {
    int power;
    double coefficient;
  };
  constexpr std::array<Term, 11> kTerms{{{1, 4},
                                         {2, 6},
                                         {3, 2.3647684},
                                         {4, -0.8698551},
                                         {5, 1.1062803},
                                         {6, -1.1014221},
                                         {7, 0.66605866},
                                         {8, -0.03633431},
                                         {10, -0.20965164},
                                         {14, 0.10555569},
                                         {22, -0.0087238}}};
  const double x = packing_fraction / (1 - packing_fraction);
  double z = 1;
  for (const Term& term : kTerms) z += term.coefficient * std::pow(x, term.power);
  return z;
}

FluidTheory::FluidTheory(const World& world, const Species& species)
    : species_(species),
      is_flat_(world.box().is_flat()),
      holds_(world.box().is_all(Boundary::periodic) && world.motion().is_straight() &&
             world.surfaces().empty() && world.size() > 1),
      has_equal_radii_(world.radii().is_common()),
      density_(static_cast<double>(world.size()) / world.box().volume()),
      compressibility_(kNone) {
  if (!holds_) return;
  std::array<double, 4> xi{};
  world.for_each_by_id([&](Slot slot) {
    double power = 1;
    for (double& sum : xi) {
      sum += power;
      power *= 2 * world.radius(slot);
    }
  });
  if (is_flat_) {
    packing_fraction_ = kPi / 4 * xi[2] / world.box().volume();
    surface_ = xi[1] / xi[2];
    holds_ = packing_fraction_ <= kFreezingOfDiscs;
    if (!holds_) return;
    const double of_points = 1 / (1 - packing_fraction_);
    const double of_equal = fluid_compressibility_of_discs(packing_fraction_);
    compressibility_ = of_points + xi[1] * xi[1] / (xi[0] * xi[2]) * (of_equal - of_points);
    return;
  }
  for (double& sum : xi) sum *= kPi / 6 / world.box().volume();
  packing_fraction_ = xi[3];
  surface_ = xi[2];
  holds_ = packing_fraction_ <= kFreezing;
  if (!holds_) return;
  compressibility_ =
      has_equal_radii_ ? fluid_compressibility(packing_fraction_) : mixture_compressibility(xi);
}

double FluidTheory::contact_value(std::size_t a, std::size_t b) const {
  if (!holds_) return kNone;
  const double free = 1 - packing_fraction_;
  const double mean_curvature = (is_flat_ ? 2 : 1) * 2 * species_.radius(a) * species_.radius(b) /
                                (species_.radius(a) + species_.radius(b)) * surface_;
  if (is_flat_) {
    const double of_equal = (fluid_compressibility_of_discs(packing_fraction_) - 1) / (2 * packing_fraction_);
    return 1 / free + mean_curvature * (of_equal - 1 / free);
  }
  if (has_equal_radii_) return (compressibility_ - 1) / (4 * packing_fraction_);
  return 1 / free + 3 * mean_curvature / (free * free) +
         2 * mean_curvature * mean_curvature / (free * free * free);
}

double FluidTheory::collision_rate(std::size_t a, std::size_t b, double temperature) const {
  const double reach = species_.radius(a) + species_.radius(b);
  const double reduced_mass = species_.mass(a) * species_.mass(b) / (species_.mass(a) + species_.mass(b));
  const double relative_speed = std::sqrt(2 * kPi * temperature / reduced_mass);  // up to a factor
  const double width = is_flat_ ? reach : 2 * reach * reach;
  return density_ * species_.fraction(b) * width * contact_value(a, b) * relative_speed;
}

double FluidTheory::collision_rate(double temperature) const {
  double rate = 0;
  for (std::size_t a = 0; a < species_.size(); ++a) {
    for (std::size_t b = 0; b < species_.size(); ++b) {
      rate += species_.fraction(a) * collision_rate(a, b, temperature);
    }
  }
  return rate;
}

double FluidTheory::mean_speed(double temperature) const {
  if (!holds_) return kNone;
  double speed = 0;
  for (std::size_t a = 0; a < species_.size(); ++a) {
    const double square = is_flat_ ? kPi / 2 : 8 / kPi;
    speed += species_.fraction(a) * std::sqrt(square * temperature / species_.mass(a));
  }
  return speed;
}

double FluidTheory::enskog_diffusion(double temperature) const {
  if (!species_.is_one_kind()) return kNone;
  // The dilute gas to first and to higher order in Sonine polynomials.
  constexpr double kHigherOrders = 1.01896;
  const double diameter = 2 * species_.radius(0);
  const double speed = std::sqrt(temperature / (kPi * species_.mass(0)));
  if (is_flat_) return speed / (2 * density_ * diameter * contact_value(0, 0));
  const double dilute = 3 * speed / (8 * density_ * diameter * diameter);
  return kHigherOrders * dilute / contact_value(0, 0);
}

double FluidTheory::diffusion(double temperature) const {
  if (!species_.is_one_kind() || !holds_ || is_flat_) return kNone;
  const double diameter = 2 * species_.radius(0);
  const double reduced = density_ * diameter * diameter * diameter;
  const double dilute =
      3 * std::sqrt(temperature / (kPi * species_.mass(0))) / (8 * density_ * diameter * diameter);
  return dilute * (1 - reduced / 1.09) * (1 + reduced * reduced * (0.4 - 0.83 * reduced * reduced));
}

}  // namespace hardball
