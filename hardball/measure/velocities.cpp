// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/velocities.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "hardball/measure/sphere_groups.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/totals.hpp"

namespace hardball {
namespace {

constexpr const char* kEnergyUnit = "M L^2 T^-2";
constexpr const char* kBegunWithoutEnergy = "the run was begun by a version that did not follow the energy";

// Bins of the samples; those of the species follow, and that of the spins, sum of I w^2, is the last.
enum : std::size_t {
  kTime,         // since the start
  kAll,          // kT
  kTwiceEnergy,  // sum of m v^2, by groups of spheres, and so in each of the rest
  kAlong,
  kOfSpecies = kAlong + kAxes
};

// The probability of a component, or of a speed, below c.
double component_below(double c) {
  return std::erfc(-c / std::numbers::sqrt2) / 2;
}
double speed_below(double c, std::size_t dimensions) {
  if (dimensions == 2) return -std::expm1(-c * c / 2);
  return std::erf(c / std::numbers::sqrt2) - std::sqrt(2 / std::numbers::pi) * c * std::exp(-c * c / 2);
}

}  // namespace

Temperature::Temperature(const Scene& scene)
    : species_(scene.species()),
      masses_(species_.size()),
      box_(scene.world().box()),
      spheres_(0),
      motion_(scene.thermal_motion()),
      begin_(scene.now()),
      last_(scene.now()),
      is_followed_(true),
      kinetic_(scene),
      samples_(kOfSpecies + species_.size() + 1, kSphereGroups) {
  const World& world = scene.world();
  world.for_each_by_id([&](Slot slot) {
    if (world.is_kinematic(slot)) return;
    ++spheres_;
    masses_[species_.of(world.id(slot))] += world.mass(slot);
  });
}

void Temperature::advance(const Time& now) {
  const double elapsed = duration(last_, now);
  last_ = now;
  kinetic_.advance(box_, elapsed, energy_.open_bins(0));
  energy_.close_sample(duration(begin_, now), elapsed);
}

void Temperature::record(const Contact& contact) {
  advance(contact.time);
  kinetic_.record(box_, contact);
}

void Temperature::record(const VelocityChange& change) {
  if (last_ < change.time) advance(change.time);
  kinetic_.record(box_, change);
}

void Temperature::sample(const Scene& scene) {
  const World& world = scene.world();
  if (world.size() == 0) return;
  const ThermalMotion& motion = scene.thermal_motion();
  samples_.put(kTime, duration(begin_, scene.now()));
  samples_.put(kAll, motion.temperature());
  std::size_t rank = 0;
  world.for_each_by_id([&](Slot slot) {
    const std::size_t group = group_of(rank++);
    if (world.is_kinematic(slot)) return;
    const Vec3 v = peculiar_velocity(world, slot, scene.now()) - motion.drift;
    const double mass = world.mass(slot);
    double* const sums = samples_.open_bins(0, group);
    const double square = mass * dot(v, v);
    sums[kTwiceEnergy] += square;
    for (std::size_t axis = 0; axis < kAxes; ++axis) sums[kAlong + axis] += mass * v[axis] * v[axis];
    sums[kOfSpecies + species_.of(world.id(slot))] += square;
    sums[kOfSpecies + species_.size()] += 2 * rotational_energy(world, slot);
  });
  samples_.close_sample(duration(begin_, scene.now()));
}

// The degrees of freedom of spheres with this number and total mass: along an axis without walls the motion
// of the center of mass is theirs in proportion to their mass, unless other walls may drag them along.
double Temperature::freedom(std::size_t axis, double spheres, double mass) const {
  return spheres - (box_.is_wall(axis) || !box_.has_plain_faces()
                        ? 0
                        : mass / std::accumulate(masses_.begin(), masses_.end(), 0.0));
}

void Temperature::add_results(const Scene& scene, Measurement& found) const {
  // A part of the energy, and its degrees of freedom.
  struct Part {
    std::string name;
    std::size_t bin;
    double freedom;
  };
  std::vector<Part> parts;
  const double total_mass = std::accumulate(masses_.begin(), masses_.end(), 0.0);
  for (std::size_t axis = 0; axis < box_.dimensions(); ++axis) {
    parts.push_back({std::string("temperature_along_") + kAxisNames[axis], kAlong + axis,
                     freedom(axis, spheres_, total_mass)});
  }
  for (std::size_t s = 0; species_.size() > 1 && s < species_.size(); ++s) {
    if (masses_[s] == 0) continue;
    double of_species = 0;
    for (std::size_t axis = 0; axis < box_.dimensions(); ++axis) {
      of_species += freedom(axis, static_cast<double>(species_.count(s)), masses_[s]);
    }
    parts.push_back({"temperature_of_species" + species_.suffix(s), kOfSpecies + s, of_species});
  }
  if (scene.world().has_spins()) {
    const double freedom_of_spin = box_.is_flat() ? 1 : kAxes;
    parts.push_back({"rotational_temperature", kOfSpecies + species_.size(), freedom_of_spin * spheres_});
  }
  // The temperature of a part over that of all.
  const auto share_of = [this](const Part& part) -> FunctionOfMeans {
    return [bin = part.bin, scale = motion_.degrees_of_freedom / part.freedom](Means means) {
      return means[bin] / means[kTwiceEnergy] * scale;
    };
  };
  std::vector<FunctionOfMeans> shares;
  for (const Part& part : parts) shares.push_back(share_of(part));
  Temperature up_to_now = *this;
  up_to_now.advance(scene.now());
  const FunctionOfMeans of_all = [this](Means means) {
    return (means[0] + means[1] + means[2]) / motion_.degrees_of_freedom;
  };
  const bool is_conserved = is_energy_conserved(motion_, scene.thermal_motion());
  Transient transient = find_transient(samples_, shares, scene.settled(), BlockAverage::Groups::exchanging);
  if (!is_conserved) {
    transient = longer(transient, find_transient(up_to_now.energy_, std::array{of_all}, scene.settled()));
  }
  if (!scene.settled().is_steady) transient = {.end = {}, .is_over = false, .reason = kNotSteady};
  transient.note_in(found);
  const BlockAverage samples = transient.left_out_of(samples_);

  Estimate all;
  if (is_followed_) all = transient.left_out_of(up_to_now.energy_).estimate(of_all);
  if (is_followed_ && is_conserved) all.error = 0;
  if (duration(begin_, scene.now()) == 0) all.value = motion_.temperature();
  found.add("temperature", kEnergyUnit, all).reason = is_followed_ ? "" : kBegunWithoutEnergy;
  found.add_argument("time", "T",
                     samples_.history([&](Means means) { return begin_.value() + means[kTime]; }));
  found.add("temperature", kEnergyUnit, samples_.history(mean_of(kAll)));
  const double tolerance = scene.has_equilibrium(motion_) ? 0 : kForComparison;
  for (const Part& part : parts) {
    const Estimate share = samples.estimate(share_of(part), BlockAverage::Groups::exchanging);
    found.add(part.name, kEnergyUnit, all * share, all.value, tolerance);
    found.add(part.name, kEnergyUnit,
              samples_.history([&](Means means) { return means[part.bin] / part.freedom; }));
  }
}

bool Temperature::restored() const {
  return samples_.has(kOfSpecies + species_.size() + 1, kSphereGroups) && energy_.has(kComponents) &&
         masses_.size() == species_.size();
}

VelocityDistribution::VelocityDistribution(const Scene& scene)
    : spheres_(static_cast<double>(scene.world().size())),
      dimensions_(scene.world().box().dimensions()),
      motion_(scene.thermal_motion()),
      begin_(scene.now()),
      average_(kAllBins, kSphereGroups) {}

void VelocityDistribution::sample(const Scene& scene) {
  const World& world = scene.world();
  const ThermalMotion& motion = scene.thermal_motion();
  const double temperature = motion.temperature();
  if (!(temperature > 0)) return;
  // What a sphere has of the motion of the center of mass, along the axes on which it counts as drift, is
  // missing in its own.
  const double drifting = 1 - motion.degrees_of_freedom / (static_cast<double>(dimensions_) * spheres_);
  double mass = 0;
  world.for_each_by_id([&](Slot slot) { mass += world.mass(slot); });
  std::size_t rank = 0;
  world.for_each_by_id([&](Slot slot) {
    const Vec3 velocity = peculiar_velocity(world, slot, scene.now()) - motion.drift;
    const double unit = std::sqrt(temperature / world.mass(slot));
    const Vec3 c = (1 / unit) * velocity;
    double* const sums = average_.open_bins(0, group_of(rank++));
    for (std::size_t axis = 0; axis < dimensions_; ++axis) {
      const double bin = (c[axis] + kEdge) / kWidth;
      if (bin >= 0 && bin < kBins) ++sums[kComponents + static_cast<std::size_t>(bin)];
    }
    const double square = dot(c, c);
    const double speed = std::sqrt(square);
    if (speed < kEdge) ++sums[kSpeeds + static_cast<std::size_t>(speed / kWidth)];
    ++sums[kSpheres];
    sums[kSquare] += square;
    sums[kFourth] += square * square;
    sums[kSpeed] += speed * unit;
    const double own = drifting > 0 ? 1 - drifting * spheres_ * world.mass(slot) / mass : 1;
    sums[kExpectedSpeed] += unit * std::sqrt(own);
  });
  average_.close_sample(duration(begin_, scene.now()));
}

void VelocityDistribution::add_results(const Scene& scene, Measurement& found) const {
  const FunctionOfMeans kurtosis_of = [](Means means) {
    return means[kFourth] * means[kSpheres] / (means[kSquare] * means[kSquare]);
  };
  const BlockAverage average =
      without_transient(average_, std::array{kurtosis_of}, scene, found, BlockAverage::Groups::exchanging);
  const bool is_conserved = is_energy_conserved(motion_, scene.thermal_motion());
  // 5/3 for many spheres, 2 for many discs; exact where the energy is fixed.
  const double freedom = motion_.degrees_of_freedom;
  const auto dimensions = static_cast<double>(dimensions_);
  const double of_many = (dimensions + 2) / dimensions;
  const double mean_of_maxwell = dimensions_ == 2 ? std::numbers::pi / 2 : 8 / std::numbers::pi;
  // Faces that heat or drag the spheres keep them out of equilibrium.
  const double theory = scene.world().box().has_plain_faces() ? 1 : kNoNumber;
  const double tolerance = scene.has_equilibrium(motion_) ? 0 : kForComparison;
  found.add("speed_kurtosis", "1", average.estimate(kurtosis_of, BlockAverage::Groups::exchanging),
            theory * of_many * freedom / (freedom + 2), tolerance);
  found.add("mean_speed", "L T^-1", mean_speed(average, kSpeed, kSquare, kSpheres, is_conserved),
            theory * std::sqrt(mean_of_maxwell) * mean_over_normal(freedom) *
                average.ratio(kExpectedSpeed, kSpheres).value,
            tolerance);
  // There are no negative speeds.
  std::vector<Estimate> speeds(kBins / 2);
  ranges::copy(average.histogram(kSpeeds, kBins / 2, kSpheres) / kWidth, std::back_inserter(speeds));
  const auto edge = [](std::size_t bin) { return (static_cast<double>(bin) - kBins / 2) * kWidth; };
  found.add_argument("reduced_velocity", "1",
                     tabulated(kBins, [&](std::size_t bin) { return (edge(bin) + edge(bin + 1)) / 2; }));
  found.add("component_density", "1", average.histogram(kComponents, kBins, kSpheres) / dimensions / kWidth,
            tabulated(kBins, [&](std::size_t bin) {
              return theory * (component_below(edge(bin + 1)) - component_below(edge(bin))) / kWidth;
            }));
  found.add("speed_density", "1", speeds, tabulated(kBins, [&](std::size_t bin) {
              const double share =
                  speed_below(edge(bin + 1), dimensions_) - speed_below(edge(bin), dimensions_);
              return bin >= kBins / 2 ? theory * share / kWidth : kNoNumber;
            }));
}

}  // namespace hardball
