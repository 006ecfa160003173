// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/temperature.hpp"

#include <numeric>
#include <string>
#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

constexpr const char* kEnergyUnit = "M L^2 T^-2";
constexpr const char* kAxisNames[] = {"x", "y", "z"};

// Bins of the average; those of the species follow.
constexpr std::size_t kTime = 0;  // since the beginning
constexpr std::size_t kAll = 1;
constexpr std::size_t kAlong = 2;
constexpr std::size_t kOfSpecies = kAlong + kAxes;

}  // namespace

Temperature::Temperature(const Scene& scene)
    : species_(scene.species()),
      masses_(species_.size()),
      box_(scene.world().box()),
      spheres_(static_cast<double>(scene.world().size())),
      begin_(scene.now()),
      average_(kOfSpecies + species_.size()) {
  const World& world = scene.world();
  world.for_each_by_id([&](Slot slot) { masses_[species_.of(world.id(slot))] += world.mass(slot); });
}

void Temperature::sample(const Scene& scene) {
  const World& world = scene.world();
  if (world.size() == 0) return;
  const ThermalMotion& motion = scene.motion();
  std::vector<double> values(average_.bins());
  values[kTime] = duration(begin_, scene.now());
  values[kAll] = motion.temperature();
  world.for_each_by_id([&](Slot slot) {
    const Vec3 v = world.path(slot).velocity - motion.drift;
    const double mass = world.mass(slot);
    for (std::size_t axis = 0; axis < kAxes; ++axis) values[kAlong + axis] += mass * v[axis] * v[axis];
    values[kOfSpecies + species_.of(world.id(slot))] += mass * dot(v, v);
  });
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    values[kAlong + axis] /= box_.is_wall(axis) ? spheres_ : spheres_ - 1;
  }
  // Spheres share in the motion of the centre of mass by their mass: what they have beside it is less.
  const double total_mass = std::accumulate(masses_.begin(), masses_.end(), 0.0);
  for (std::size_t s = 0; s < species_.size(); ++s) {
    double freedom = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      freedom += static_cast<double>(species_.count(s)) - (box_.is_wall(axis) ? 0 : masses_[s] / total_mass);
    }
    values[kOfSpecies + s] /= freedom;
  }
  average_.add(values);
}

Measurement Temperature::result(const Scene& /*scene*/) const {
  Measurement found{
      .name = std::string(kName),
      .title = "Temperature",
      .formula =
          "kT = sum m v^2 / degrees of freedom, three for each sphere less one for each "
          "axis without walls",
      .source = "Equipartition; Allen and Tildesley, Computer Simulation of Liquids, section 2.4"};
  const double all = average_.mean(kAll);
  const auto add = [&](std::string name, std::size_t bin, double theory) {
    found.quantities.push_back(
        {std::move(name), kEnergyUnit, average_.mean(bin), average_.error(bin), theory});
  };
  add("temperature", kAll, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    add(std::string("temperature_along_") + kAxisNames[axis], kAlong + axis, all);
  }
  const bool is_mixture = species_.size() > 1;
  for (std::size_t s = 0; is_mixture && s < species_.size(); ++s) {
    add("temperature_of_species" + species_.suffix(s), kOfSpecies + s, all);
  }
  found.columns.push_back({"time", "T", ColumnRole::argument,
                           average_.history([&](auto means) { return begin_.value() + means[kTime]; })});
  for (std::size_t k = 0; k < found.quantities.size(); ++k) {
    found.columns.push_back({found.quantities[k].name, kEnergyUnit, ColumnRole::value,
                             average_.history([&](auto means) { return means[kAll + k]; })});
  }
  return found;
}

}  // namespace hardball
