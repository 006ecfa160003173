// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "hardball/interaction/passing.hpp"
#include "hardball/interaction/step_potential.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/world/step_levels.hpp"
#include "support/random_world.hpp"

namespace hardball::support {

/// Gives the spheres of a random world potentials of steps, and ties some of them together.
class StepMaker {
 public:
  StepMaker(RandomWorld& made, std::uint64_t seed) : made_(made), random_(seed ^ 0x57e95) {
    double shortest = 1e300;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (made.world.box().is_periodic(axis)) shortest = std::min(shortest, made.world.box().size()[axis]);
    }
    largest_reach_ = 0.49 * shortest;
    double speeds = 0;
    for (Slot slot = 0; slot < made.world.size(); ++slot) {
      const Vec3 velocity = made.world.velocity(slot, Time(0));
      speeds += dot(velocity, velocity);
      mass_ = made.world.mass(slot);
    }
    energy_ = mass_ * speeds / static_cast<double>(std::max<std::size_t>(made.world.size(), 1));
    if (!(energy_ > 0) || !(energy_ < 1e50)) energy_ = 1;
  }

  void give_steps() {
    Interactions interactions = made_.world.interactions();
    StepTable table;
    const double most = largest_reach_ / (2 * made_.world.largest_radius());
    if (most > 1.01) {
      if (chance(0.8)) table.set_for_all(random_potential(1, most));
      for (SpeciesId a = 0; a < kMaxRandomSpecies; ++a) {
        for (SpeciesId b = 0; b <= a; ++b) {
          if (chance(0.3)) table.set(a, b, random_potential(1, most));
        }
      }
    } else if (most > 0.2) {
      table.set_for_all(random_potential(0, std::min(most, 0.99)));
    }
    std::vector<std::pair<std::pair<SphereId, SphereId>, StepTable::Number>> ties;
    if (chance(0.5)) {
      for (SphereId id = 1; id < made_.world.size(); ++id) {
        if (chance(0.3)) continue;
        const Slot a = made_.world.slot_of(id - 1);
        const Slot b = made_.world.slot_of(id);
        if (made_.world.is_kinematic(a) && made_.world.is_kinematic(b)) continue;
        const double radii = made_.world.base_radius(a) + made_.world.base_radius(b);
        const double ratio = distance(a, b) / radii;
        const double longest = std::min(ratio * (1 + random_.uniform()), largest_reach_ / radii);
        if (longest < ratio * 1.0001 || ratio > 20) continue;
        StepRules rules =
            random_rules(chance(0.2) ? 0 : std::min(ratio, 1.0) * (1 - 0.3 * random_.uniform()), longest);
        rules.steps.back().ratio = longest;
        rules.is_tether = true;
        ties.push_back({{id - 1, id}, table.add_bond(StepPotential(rules))});
      }
    }
    interactions.set_steps(table);
    made_.world.set_interactions(interactions);
    for (const auto& [ids, potential] : ties) add_bond(made_.world, ids.first, ids.second, potential);
    made_.name += ", " + to_text(table.size()) + " potentials and " + to_text(ties.size()) + " bonds";
  }

 private:
  bool chance(double probability) { return random_.uniform() < probability; }

  double distance(Slot a, Slot b) const {
    Vec3 apart = made_.world.position(b, Time(0)) - made_.world.position(a, Time(0));
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!made_.world.box().is_periodic(axis)) continue;
      const double size = made_.world.box().size()[axis];
      apart[axis] -= size * std::round(apart[axis] / size);
    }
    return length(apart);
  }

  StepPotential random_potential(double core, double most) {
    if (core > 0 && chance(0.2)) core = 0;
    return StepPotential(random_rules(core, std::min(most, chance(0.3) ? 1.02 : 3.0)));
  }

  // Wells and shoulders, deep and shallow, wide and sticky; flat ones now and then.
  StepRules random_rules(double core, double most) {
    const std::size_t count = 1 + static_cast<std::size_t>(3 * random_.uniform());
    std::vector<double> ratios;
    for (std::size_t k = 0; k < count; ++k)
      ratios.push_back(core + (most - core) * (0.001 + 0.999 * random_.uniform()));
    std::ranges::sort(ratios);
    StepRules rules{.core = core};
    double last = core;
    for (const double ratio : ratios) {
      if (!(ratio > last * (1 + 1e-6) + 1e-6)) continue;
      const double energy =
          chance(0.1) ? 0 : energy_ * (2 * random_.uniform() - 1) * std::pow(10, -2 * random_.uniform());
      rules.steps.push_back({ratio, energy});
      last = ratio;
    }
    if (rules.steps.empty()) rules.steps.push_back({most, -energy_});
    return rules;
  }

  RandomWorld& made_;
  Random random_;
  double largest_reach_ = 0;
  double mass_ = 1;
  double energy_ = 1;
};

/// A world with potentials of steps and bonds: in two or three dimensions, with walls, surfaces and species.
inline RandomWorld make_stepped_world(std::uint64_t seed) {
  for (std::uint64_t attempt = 0;; ++attempt) {
    const std::uint64_t of_world = seed + 1000003 * attempt;
    RandomWorld made = seed % 4 == 0   ? make_flat_world(of_world)
                       : seed % 4 == 1 ? make_responsive_world(of_world)
                       : seed % 4 == 2 ? make_furnished_world(of_world)
                                       : make_random_world(of_world);
    const Interactions& interactions = made.world.interactions();
    if (!made.world.motion().is_straight() || interactions.table().has_merging() ||
        interactions.has_passing())
      continue;
    StepMaker(made, seed).give_steps();
    made.name += ", steps of seed " + to_text(seed);
    return made;
  }
}

}  // namespace hardball::support
