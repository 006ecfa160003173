// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/temperature.hpp"

#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "hardball/measure/sphere_groups.hpp"
#include "hardball/measure/transient.hpp"

namespace hardball {
namespace {

constexpr const char* kEnergyUnit = "M L^2 T^-2";

// Bins of the average; those of the species follow, and that of the spins, sum of I w^2, is the last.
constexpr std::size_t kTime = 0;    // since the start
constexpr std::size_t kAll = 1;     // kT
constexpr std::size_t kSquare = 2;  // sum of m v^2, by groups of spheres, and so in each of the rest
constexpr std::size_t kAlong = 3;
constexpr std::size_t kOfSpecies = kAlong + kAxes;

}  // namespace

Temperature::Temperature(const Scene& scene)
    : species_(scene.species()),
      masses_(species_.size()),
      box_(scene.world().box()),
      spheres_(static_cast<double>(scene.world().size())),
      motion_(scene.thermal_motion()),
      begin_(scene.now()),
      average_(kOfSpecies + species_.size() + 1, kSphereGroups) {
  const World& world = scene.world();
  world.for_each_by_id([&](Slot slot) { masses_[species_.of(world.id(slot))] += world.mass(slot); });
}

void Temperature::sample(const Scene& scene) {
  const World& world = scene.world();
  if (world.size() == 0) return;
  const ThermalMotion& motion = scene.thermal_motion();
  average_.put(kTime, duration(begin_, scene.now()));
  average_.put(kAll, motion.temperature());
  std::size_t rank = 0;
  world.for_each_by_id([&](Slot slot) {
    const Vec3 v = world.peculiar_velocity(slot, scene.now()) - motion.drift;
    const double mass = world.mass(slot);
    double* const sums = average_.open_bins(0, group_of(rank++));
    const double square = mass * dot(v, v);
    sums[kSquare] += square;
    for (std::size_t axis = 0; axis < kAxes; ++axis) sums[kAlong + axis] += mass * v[axis] * v[axis];
    sums[kOfSpecies + species_.of(world.id(slot))] += square;
    sums[kOfSpecies + species_.size()] += 2 * rotational_energy(world, slot);
  });
  average_.close_sample(duration(begin_, scene.now()));
}

// The degrees of freedom of so many spheres with so much mass: along an axis without walls the motion of the
// center of mass is theirs in proportion to their mass, unless other walls may drag them along.
double Temperature::freedom(std::size_t axis, double spheres, double mass) const {
  return spheres - (box_.is_wall(axis) || !box_.has_plain_faces()
                        ? 0
                        : mass / std::accumulate(masses_.begin(), masses_.end(), 0.0));
}

Measurement Temperature::result(const Scene& scene) const {
  Measurement found{
      .name = std::string(kName),
      .title = "Temperature",
      .formula =
          R"($kT = \frac{1}{f} \sum m v^2$ with $f$ degrees of freedom, one for each sphere and dimension )"
          R"(less one for each axis without walls)",
      .source = "Equipartition; Allen and Tildesley, Computer Simulation of Liquids, section 2.4"};
  using Means = std::span<const double>;
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
  std::vector<FunctionOfMeans> shares;
  for (const Part& part : parts) {
    shares.push_back([bin = part.bin](Means means) { return means[bin] / means[kSquare]; });
  }
  const Transient transient = find_transient(average_, shares, BlockAverage::Groups::exchanging);
  const BlockAverage average = transient.left_out_of(average_);

  const bool is_conserved = is_energy_conserved(motion_, scene.thermal_motion());
  Estimate all = average.ratio(kAll);
  if (is_conserved) all.error = 0;
  found.quantities.push_back({"temperature", kEnergyUnit, all.value, all.error});
  found.columns.push_back({"time", "T", ColumnRole::argument,
                           average_.history([&](Means means) { return begin_.value() + means[kTime]; })});
  found.columns.push_back({"temperature", kEnergyUnit, ColumnRole::value,
                           average_.history([](Means means) { return means[kAll]; })});
  const double square = average.mean(kSquare);
  const double tolerance = scene.has_equilibrium(motion_) ? 0 : kForComparison;
  for (const Part& part : parts) {
    const FunctionOfMeans of_sum = [&](Means means) { return means[part.bin] / part.freedom; };
    // As in mean_speed.
    const FunctionOfMeans of_share = [&](Means means) { return of_sum(means) / means[kSquare] * square; };
    const Estimate value = is_conserved ? average.estimate(of_share, BlockAverage::Groups::exchanging)
                                        : average.estimate(of_sum);
    found.quantities.push_back({part.name, kEnergyUnit, value.value, value.error, all.value, tolerance});
    found.columns.push_back({part.name, kEnergyUnit, ColumnRole::value, average_.history(of_sum)});
  }
  transient.note_in(found);
  return found;
}

bool Temperature::restored() const {
  return average_.has(kOfSpecies + species_.size() + 1, kSphereGroups) && masses_.size() == species_.size();
}

bool Temperature::matches(const World& world) const {
  return species_.matches(world);
}

}  // namespace hardball
