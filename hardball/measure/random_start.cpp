// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/random_start.hpp"
#include "hardball/world/step_levels.hpp"
#include "hardball/world/totals.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hardball {
namespace {

// Of the energy in potentials of steps. A pair counts half with each of its spheres, so that the total of
// independent pairs varies twice as much as if the spheres were independent; where spheres exclude each
// other, it varies less.
double variance_of_pairs(const Scene& scene) {
  const World& world = scene.world();
  const SpeciesList& species = scene.species();
  std::vector<double> mean(species.size());
  world.for_each_by_id([&](Slot slot) {
    const std::size_t kind = species.of(world.id(slot));
    mean[kind] += step_energy(world, slot) / static_cast<double>(species.count(kind));
  });
  double squares = 0;
  world.for_each_by_id([&](Slot slot) {
    const double excess = step_energy(world, slot) - mean[species.of(world.id(slot))];
    squares += excess * excess;
  });
  return 2 * squares;
}

// The energy by which a sphere is higher at one wall than at the other.
double fall(const World& world, Slot slot, std::size_t axis) {
  if (!world.box().is_wall(axis) || world.is_kinematic(slot)) return 0;
  return world.mass(slot) * std::fabs(world.motion().gravity()[axis]) * world.box().size()[axis];
}

// Of heights between walls that are all equally likely.
double variance_of_heights(const World& world) {
  double sum = 0;
  world.for_each_by_id([&](Slot slot) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double energy = fall(world, slot, axis);
      sum += energy * energy / 12;
    }
  });
  return sum;
}

double axes_of_rotation(const World& world) {
  return world.box().is_flat() ? 1 : 3;
}

// By how much places depend on the temperature: the potential energy that decides on them over kT.
double sensitivity_of_places(const Scene& scene, double temperature) {
  const World& world = scene.world();
  double in_steps = 0;
  double falls = 0;
  world.for_each_by_id([&](Slot slot) {
    if (world.has_steps()) in_steps += std::fabs(step_energy(world, slot));
    for (std::size_t axis = 0; axis < kAxes; ++axis) falls += fall(world, slot, axis);
  });
  const auto spheres = static_cast<double>(world.size());
  double strongest = in_steps / spheres;
  const StepTable& steps = world.interactions().steps();
  for (std::size_t number = 0; number < steps.size(); ++number) {
    for (const Step& step : steps[static_cast<StepTable::Number>(number)].rules().steps)
      strongest = std::max(strongest, std::fabs(step.energy));
  }
  // The height of a tall heap is proportional to the temperature.
  return strongest / temperature + std::min(falls / spheres / temperature, 1.0);
}

}  // namespace

RandomStart::RandomStart(const Scene& scene)
    : energy_(energy(scene.world(), scene.now())), rotational_energy_(rotational_energy(scene.world())) {
  const World& world = scene.world();
  if (world.size() == 0) return;
  if (world.has_steps()) variance_of_places_ += variance_of_pairs(scene);
  if (!world.motion().is_straight()) variance_of_places_ += variance_of_heights(world);
  const auto spheres = static_cast<double>(world.size());
  variance_of_spins_ = 2 / axes_of_rotation(world) * rotational_energy_ * rotational_energy_ / spheres;
}

StartSpread RandomStart::spread(const Scene& scene) const {
  constexpr double kRounding = 1e-9;
  const World& world = scene.world();
  const ThermalMotion& motion = scene.thermal_motion();
  const double change = std::fabs(energy(world, scene.now()) - energy_);
  const bool is_conserved = change <= kRounding * (motion.energy + std::fabs(energy_));
  if (!is_conserved || !(motion.energy > 0)) return {};
  const double rotation = std::fabs(rotational_energy(world) - rotational_energy_);
  const bool do_spins_exchange = rotation > kRounding * rotational_energy_;
  double freedom = motion.degrees_of_freedom;
  double variance = variance_of_places_;
  if (do_spins_exchange) {
    freedom += axes_of_rotation(world) * static_cast<double>(world.size());
    variance += variance_of_spins_;
  }
  if (variance == 0) return {};
  const double temperature = motion.temperature();
  return {.temperature = 2 * std::sqrt(variance) / (freedom * temperature),
          .sensitivity_of_places = sensitivity_of_places(scene, temperature)};
}

}  // namespace hardball
