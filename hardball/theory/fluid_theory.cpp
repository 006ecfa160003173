// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/theory/fluid_theory.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "hardball/numbers/no_number.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/theory/gas_statistics.hpp"
#include "hardball/theory/kinetic_theory.hpp"
#include "hardball/theory/thermal_motion.hpp"

namespace hardball {
namespace {

constexpr double kPi = std::numbers::pi;

// `xi` holds pi / 6 times the number density times the mean k-th power of the diameter.
double mixture_compressibility(const std::array<double, 4>& xi) {
  const double free = 1 - xi[3];
  return 1 / free + 3 * xi[1] * xi[2] / (xi[0] * free * free) +
         xi[2] * xi[2] * xi[2] * (3 - xi[3]) / (xi[0] * free * free * free);
}

// Whether spheres of the species that there are pass through each other: those of any two, and of all.
struct PassingPairs {
  bool any = false;
  bool all = false;
};

PassingPairs passing_in(const World& world) {
  if (!world.interactions().has_passing()) return {};
  std::vector<SpeciesId> present;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const auto place = ranges::lower_bound(present, world.species(slot));
    if (place == present.end() || *place != world.species(slot)) present.insert(place, world.species(slot));
  }
  PassingPairs found{.any = false, .all = true};
  for (const SpeciesId a : present) {
    for (const SpeciesId b : present) {
      const bool pass = world.interactions().pass(a, b);
      found = {found.any || pass, found.all && pass};
    }
  }
  return found;
}

}  // namespace

FluidTheory::FluidTheory(const World& world, const SpeciesList& species)
    : species_(species),
      is_flat_(world.box().is_flat()),
      holds_(world.box().is_all(Boundary::periodic) && world.motion().is_straight() &&
             world.surfaces().empty() && world.size() > 1 && !world.has_steps() &&
             world.kinematic_count() == 0),
      has_equal_radii_(world.base_radii().is_common()),
      density_(static_cast<double>(world.size()) / world.box().volume()),
      compressibility_(kNoNumber) {
  const PassingPairs passing = passing_in(world);
  is_ideal_ = world.size() > 1 && passing.all;
  holds_ = holds_ && (is_ideal_ || !passing.any);
  if (!holds_) return;
  if (is_ideal_) {
    compressibility_ = 1;
    return;
  }
  std::array<double, 4> xi{};
  world.for_each_by_id([&](Slot slot) {
    double power = 1;
    for (double& sum : xi) {
      sum += power;
      power *= 2 * world.base_radius(slot);
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
  if (species.size() == 1 && !species.is_one_kind() && !std::isnan(species.mass(0))) {
    mean_free_path_ = hardball::mean_free_path(gas_statistics(world, Time(0)));
  }
  compressibility_ =
      has_equal_radii_ ? fluid_compressibility(packing_fraction_) : mixture_compressibility(xi);
}

double FluidTheory::spheres() const {
  std::size_t spheres = 0;
  for (std::size_t s = 0; s < species_.size(); ++s) spheres += species_.count(s);
  return static_cast<double>(spheres);
}

double FluidTheory::tolerance() const {
  constexpr double kOfEqual = 4e-5;
  constexpr double kOfMixtures = 0.01;
  constexpr double kOfMixturesOfDiscs = 0.02;
  const double crowding = packing_fraction_ / (is_flat_ ? kFreezingOfDiscs : kFreezing);
  const double of_equation = has_equal_radii_ ? kOfEqual : is_flat_ ? kOfMixturesOfDiscs : kOfMixtures;
  return of_equation + std::pow(crowding, 4) / spheres() + 4 / (spheres() * spheres());
}

// Pairs in contact in a closed box over those in a large system of the same density: 1 - S / 2N times the
// second derivative of the density of pairs with respect to that of spheres, in units of these, S being the
// structure factor at zero.
double FluidTheory::fixed_number() const {
  if (is_ideal_) return 1 - 1 / spheres();
  constexpr double kStep = 0.01;
  const auto pairs = [this](double density) {
    const double packing = density * packing_fraction_;
    const double z = is_flat_ ? fluid_compressibility_of_discs(packing) : fluid_compressibility(packing);
    return packing * (z - 1);
  };
  const double below = pairs(1 - kStep);
  const double here = pairs(1);
  const double above = pairs(1 + kStep);
  const double structure_factor = 1 / (1 + (above - below) / (2 * kStep * packing_fraction_));
  const double curvature = (above - 2 * here + below) / (kStep * kStep * here);
  return 1 - structure_factor * curvature / (2 * spheres());
}

// The mean magnitude of a component of the motion over that of a normal distribution.
double FluidTheory::fixed_energy() const {
  return mean_over_normal((is_flat_ ? 2 : 3) * (spheres() - 1));
}

// With the total momentum fixed n spheres have the degrees of freedom of n - 1, and meet a little faster
// than their mean energy suggests.
double FluidTheory::compressibility() const {
  if (!holds_) return kNoNumber;
  return 1 + (compressibility_ - 1) * fixed_number() * spheres() / (spheres() - 1);
}

double FluidTheory::contact_value(std::size_t a, std::size_t b) const {
  if (!holds_) return kNoNumber;
  return fixed_number() * contact_value_of_many(a, b);
}

double FluidTheory::contact_value_of_many(std::size_t a, std::size_t b) const {
  if (is_ideal_) return 1;
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
  return density_ * species_.fraction(b) * width * contact_value(a, b) * relative_speed * fixed_energy();
}

double FluidTheory::collision_rate(double temperature) const {
  if (!std::isnan(mean_free_path_)) {
    const double square = is_flat_ ? kPi / 2 : 8 / kPi;
    return std::sqrt(square * temperature / species_.mass(0)) / mean_free_path_ * fixed_number() *
           fixed_energy();
  }
  double rate = 0;
  for (std::size_t a = 0; a < species_.size(); ++a) {
    for (std::size_t b = 0; b < species_.size(); ++b) {
      rate += species_.fraction(a) * collision_rate(a, b, temperature);
    }
  }
  return rate;
}

double FluidTheory::mean_speed(double temperature) const {
  if (!holds_) return kNoNumber;
  double mass = 0;  // of all spheres
  for (std::size_t a = 0; a < species_.size(); ++a)
    mass += spheres() * species_.fraction(a) * species_.mass(a);
  double speed = 0;
  for (std::size_t a = 0; a < species_.size(); ++a) {
    const double square = (is_flat_ ? kPi / 2 : 8 / kPi) * (1 - species_.mass(a) / mass);
    speed += species_.fraction(a) * std::sqrt(square * temperature / species_.mass(a));
  }
  return speed * fixed_energy();
}

double FluidTheory::enskog_diffusion(double temperature) const {
  if (!species_.is_one_kind() || !holds_ || is_ideal_) return kNoNumber;
  // The dilute gas to first and to higher order in Sonine polynomials.
  constexpr double kHigherOrders = 1.01896;
  const double diameter = 2 * species_.radius(0);
  const double speed = std::sqrt(temperature / (kPi * species_.mass(0)));
  if (is_flat_) return speed / (2 * density_ * diameter * contact_value_of_many(0, 0));
  const double dilute = 3 * speed / (8 * density_ * diameter * diameter);
  return kHigherOrders * dilute / contact_value_of_many(0, 0);
}

// To higher order in Sonine polynomials.
double FluidTheory::dilute_viscosity(double temperature) const {
  const double diameter = 2 * species_.radius(0);
  return 0.17914 * std::sqrt(species_.mass(0) * temperature) / (diameter * diameter);
}

double FluidTheory::enskog_viscosity(double temperature) const {
  if (!has_transport()) return kNoNumber;
  const double y = compressibility_ - 1;
  const double b = 4 * packing_fraction_;
  return dilute_viscosity(temperature) * b * (1 / y + 0.8 + 0.7614 * y);
}

double FluidTheory::viscosity(double temperature) const {
  struct Point {
    double packing_fraction;
    double ratio;
  };
  constexpr std::array<Point, 5> kRatio{{{0, 1}, {0.35, 1.03}, {0.41, 1.1}, {0.46, 1.4}, {0.494, 2}}};
  std::size_t next = 1;
  while (next + 1 < kRatio.size() && kRatio[next].packing_fraction < packing_fraction_) ++next;
  const Point& low = kRatio[next - 1];
  const Point& high = kRatio[next];
  const double share =
      (packing_fraction_ - low.packing_fraction) / (high.packing_fraction - low.packing_fraction);
  return enskog_viscosity(temperature) * (low.ratio + share * (high.ratio - low.ratio));
}

double FluidTheory::enskog_bulk_viscosity(double temperature) const {
  if (!has_transport()) return kNoNumber;
  return dilute_viscosity(temperature) * 4 * packing_fraction_ * 1.002 * (compressibility_ - 1);
}

double FluidTheory::enskog_thermal_conductivity(double temperature) const {
  if (!has_transport()) return kNoNumber;
  const double diameter = 2 * species_.radius(0);
  const double dilute = 0.67783 * std::sqrt(temperature / species_.mass(0)) / (diameter * diameter);
  const double y = compressibility_ - 1;
  return dilute * 4 * packing_fraction_ * (1 / y + 1.2 + 0.7574 * y);
}

double FluidTheory::diffusion(double temperature) const {
  if (!has_transport()) return kNoNumber;
  constexpr double kSpheresOfSpeedy = 500;
  const double diameter = 2 * species_.radius(0);
  const double reduced = density_ * diameter * diameter * diameter;
  const double dilute =
      3 * std::sqrt(temperature / (kPi * species_.mass(0))) / (8 * density_ * diameter * diameter);
  const double of_speedy =
      dilute * (1 - reduced / 1.09) * (1 + reduced * reduced * (0.4 - 0.83 * reduced * reduced));
  return of_speedy + diffusion_missing(temperature) * (std::cbrt(spheres() / kSpheresOfSpeedy) - 1);
}

double FluidTheory::diffusion_missing(double temperature) const {
  if (!has_transport()) return kNoNumber;
  constexpr double kCubicLattice = 2.837297;
  const double inverse_edge = std::cbrt(density_ / spheres());
  return kCubicLattice * temperature / (6 * kPi * viscosity(temperature)) * inverse_edge;
}

}  // namespace hardball
