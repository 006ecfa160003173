// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/step_levels.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/exit_time.hpp"
#include "hardball/numbers/exact_sum.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/pair_event.hpp"
#include "hardball/world/sphere_edit.hpp"
#include "hardball/world/static_hash_grid.hpp"

namespace hardball {
namespace {

// How far spheres that are tied may start beyond the end of their tether, or within their core, through
// rounding alone, relative to it [1].
constexpr double kBondTolerance = 1e-9;

std::string name_of(const World& world, Slot a, Slot b) {
  const auto [low, high] = std::minmax({world.id(a), world.id(b)});
  return "spheres " + to_text(low) + " and " + to_text(high);
}

// From one center to the nearest image of another.
State relative_state(const World& world, Slot a, Slot b, const Time& moment) {
  const Image image = nearest_image(world, a, b, moment);
  return relative_state_at(world.motion(), world.path(a), world.path(b), world.box().shift(image), moment);
}

// Of spheres at the distance of a step those that approach each other are inside.
bool is_inside(const State& relative, double reach) {
  const double excess = squared_excess(relative.position, reach);
  return excess < 0 || (excess == 0 && approach_to_106_bits(relative.position, relative.velocity) < 0);
}

StepPotential::Level level_at(const StepPotential& potential, const State& relative, double radii) {
  std::size_t level = 0;
  while (level < potential.steps() &&
         is_inside(relative, potential.rules().steps[potential.steps() - level - 1].ratio * radii)) {
    ++level;
  }
  return static_cast<StepPotential::Level>(level);
}

// Of each pair only one image may be inside of a step.
void check_ranges(const World& world) {
  const double shortest = world.box().shortest_period();
  const auto check = [&](double reach) {
    constexpr double kRoom = 1 - 1e-9;
    if (reach < shortest / 2 * kRoom) return;
    throw Error("a step of a potential is at the distance " + to_text(reach) +
                    ", and half of the periodic box is " + to_text(shortest / 2),
                "potential", "enlarge the box, or give steps at smaller ratios");
  };
  if (!(shortest < std::numeric_limits<double>::infinity())) return;
  constexpr std::size_t kSpecies = std::numeric_limits<SpeciesId>::max() + std::size_t{1};
  std::array<double, kSpecies> largest{};
  for (Slot slot = 0; slot < world.size(); ++slot) {
    double& radius = largest[world.species(slot)];
    radius = std::max(radius, world.base_radius(slot));
  }
  const StepTable& steps = world.interactions().steps();
  for (std::size_t a = 0; a < kSpecies; ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      if (!(largest[a] > 0 && largest[b] > 0)) continue;
      const StepTable::Number number = steps.of(static_cast<SpeciesId>(a), static_cast<SpeciesId>(b));
      if (number != StepTable::kNone) check(steps[number].range() * (largest[a] + largest[b]));
    }
  }
  for (const auto& [slot, pair] : world.pair_levels().in_order())
    check(steps[pair.potential].range() * (world.base_radius(slot) + world.base_radius(pair.partner)));
}

// Finds the level of a pair from its distance.
void assign_level(World& world, Slot a, Slot b, const Time& moment) {
  const PairLevel* const pair = world.pair_levels().find(a, b);
  const StepTable::Number number = pair ? pair->potential : potential_of(world, a, b);
  if (number == StepTable::kNone) return;
  const StepPotential& potential = world.interactions().steps()[number];
  const double radii = world.base_radius(a) + world.base_radius(b);
  const State relative = relative_state(world, a, b, moment);
  StepPotential::Level level = level_at(potential, relative, radii);
  if (potential.is_tether()) {
    const double ratio = length(relative.position) / radii;
    const double core = potential.rules().core;
    if (ratio > potential.range() * (1 + kBondTolerance) || ratio < core * (1 - kBondTolerance)) {
      throw Error(name_of(world, a, b) + " are tied, and " + to_text(ratio) +
                      " of the sum of their radii apart, where " + to_text(core) + " to " +
                      to_text(potential.range()) + " is allowed",
                  "start state", "place them within their bond");
    }
    level = std::max<StepPotential::Level>(level, 1);
  }
  if (level != (pair ? pair->level : 0)) world.set_level(a, b, number, level, moment);
}

}  // namespace

void add_bond(World& world, SphereId a, SphereId b, StepTable::Number potential) {
  const std::string where = "bond of spheres " + to_text(a) + " and " + to_text(b);
  const StepTable& steps = world.interactions().steps();
  if (a == b) throw Error("a sphere is tied to itself", where, "give two spheres");
  if (potential >= steps.size() || !steps[potential].is_tether())
    throw Error("the potential is not a tether of the step table", where, "give a number of add_bond");
  const Slot first = world.slot_of(a);
  const Slot second = world.slot_of(b);
  if (world.is_kinematic(first) && world.is_kinematic(second))
    throw Error("both spheres are kinematic, of infinite mass", where, "give one a finite mass");
  if (world.pair_levels().find(first, second))
    throw Error("they are tied already", where, "give each bond once");
  world.set_level(first, second, potential, 1, Time(0));
}

std::vector<Bond> bonds_of(const World& world) {
  const StepTable& steps = world.interactions().steps();
  if (!steps.has_bonds()) return {};
  std::vector<Bond> bonds;
  for (const auto& [slot, pair] : world.pair_levels().in_order()) {
    if (!steps[pair.potential].is_tether()) continue;
    const auto [low, high] = std::minmax({world.id(slot), world.id(pair.partner)});
    bonds.push_back({low, high, pair.potential});
  }
  ranges::sort(bonds);
  return bonds;
}

std::vector<SphereId> partners_of(const World& world, SphereId id) {
  std::vector<SphereId> partners;
  for (const PairLevel& pair : world.pair_levels().of(world.slot_of(id)))
    partners.push_back(world.id(pair.partner));
  ranges::sort(partners);
  return partners;
}

void assign_levels(World& world, const Time& moment) {
  if (!world.has_steps()) return;
  check_ranges(world);
  for (const auto& [slot, pair] : world.pair_levels().in_order()) {
    if (world.interactions().steps()[pair.potential].is_tether()) {
      assign_level(world, slot, pair.partner, moment);
    } else {
      world.set_level(slot, pair.partner, pair.potential, 0, moment);
    }
  }
  StaticHashGrid near(world.box(), world.size(), world.largest_bounding_radius());
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const Vec3 center = world.position(slot, moment);
    near.for_each_near(center, world.bounding_radius(slot),
                       [&](std::uint32_t other, const Vec3& separation, double reach) {
                         // With a margin for rounding.
                         if (dot(separation, separation) <= 1.001 * (reach * reach))
                           assign_level(world, slot, static_cast<Slot>(other), moment);
                       });
    near.insert(center, world.bounding_radius(slot));
  }
}

void assign_levels(World& world, Slot added, std::span<const Slot> others, const Time& moment) {
  if (!world.has_steps()) return;
  check_ranges(world);
  for (const Slot other : others) {
    if (other != added) assign_level(world, added, other, moment);
  }
}

double core_ratio(const World& world, Slot a, Slot b) {
  if (pass(world, a, b)) return 0;
  if (!world.has_steps()) return 1;
  const PairLevel* const pair = world.pair_levels().find(a, b);
  const StepTable::Number number = pair ? pair->potential : potential_of(world, a, b);
  return number == StepTable::kNone ? 1 : world.interactions().steps()[number].rules().core;
}

double step_energy(const World& world, Slot slot) {
  ExactSum energy;
  for (const PairLevel& pair : world.pair_levels().of(slot))
    energy += world.interactions().steps()[pair.potential].energy(pair.level) / 2;
  return energy.value();
}

double step_energy(const World& world) {
  ExactSum energy;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    for (const PairLevel& pair : world.pair_levels().of(slot))
      energy += world.interactions().steps()[pair.potential].energy(pair.level) / 2;
  }
  return energy.value();
}

}  // namespace hardball
