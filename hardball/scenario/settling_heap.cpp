// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/settling_heap.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace hardball {

bool loses_energy(const BounceRules& rules) {
  const auto* constant = std::get_if<ConstantRestitution>(&rules.restitution);
  return !constant || constant->value < 1 || std::fabs(rules.tangential_restitution.value_or(-1)) < 1;
}

bool loses_energy(const Scenario& scenario) {
  const auto any_lossy = [](const auto& walls) {
    return std::ranges::any_of(walls, [](const auto& wall) { return wall.restitution.value_or(1) < 1; });
  };
  return loses_energy(scenario.bounce) || any_lossy(scenario.faces) || any_lossy(scenario.walls) ||
         any_lossy(scenario.obstacles) ||
         std::ranges::any_of(scenario.pairs, [](const PairDescription& pair) {
           return pair.outcome == ContactOutcome::bounce && loses_energy(pair.bounce);
         });
}

bool are_kept_moving(const Scenario& scenario) {
  const auto is_warm = [](const auto& wall) { return wall.temperature.value_or(0) > 0; };
  const auto moves = [](const auto& wall) { return wall.velocity != Vec3{}; };
  const auto oscillates = [](const WallDescription& wall) { return wall.amplitude > 0; };
  const auto any = [](const auto& walls, const auto&... drive) {
    return std::ranges::any_of(walls, [&](const auto& wall) { return (drive(wall) || ...); });
  };
  return scenario.thermostat || any(scenario.faces, is_warm, moves) ||
         any(scenario.walls, is_warm, moves, oscillates) || any(scenario.obstacles, is_warm);
}

bool has_floor(const Scenario& scenario) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (scenario.gravity[axis] != 0 && scenario.box[axis].boundary == Boundary::wall) return true;
  }
  return scenario.gravity != Vec3{} && std::ranges::any_of(scenario.walls, [&](const WallDescription& wall) {
           return is_round(wall) || dot(wall.direction, scenario.gravity) < 0;
         });
}

}  // namespace hardball
