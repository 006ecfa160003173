// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/settling_heap.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

// Whether it holds for the material of a face with properties of its own, or of a surface.
bool any_of_walls(const Scenario& scenario, const auto& holds) {
  return ranges::any_of(scenario.faces,
                        [&](const FaceDescription& face) { return holds(face.properties.material); }) ||
         ranges::any_of(scenario.surfaces,
                        [&](const SurfaceDescription& wall) { return holds(wall.surface.material()); });
}

}  // namespace

bool loses_energy(const BounceRules& rules) {
  const auto* constant = std::get_if<ConstantRestitution>(&rules.restitution);
  return !constant || constant->value < 1 || std::fabs(rules.tangential_restitution.value_or(-1)) < 1;
}

bool loses_energy(const Scenario& scenario) {
  const auto is_lossy = [](const SurfaceMaterial& material) {
    return material.restitution.value_or(1) < 1 || std::fabs(material.tangential_restitution.value_or(1)) < 1;
  };
  return loses_energy(scenario.bounce) || any_of_walls(scenario, is_lossy) ||
         ranges::any_of(scenario.pairs, [](const PairDescription& pair) {
           return pair.outcome == ContactOutcome::bounce && loses_energy(pair.bounce);
         });
}

bool are_kept_moving(const Scenario& scenario) {
  const auto is_warm = [](const SurfaceMaterial& material) { return material.temperature.value_or(0) > 0; };
  const auto face_moves = [](const FaceDescription& face) { return face.properties.velocity != Vec3{}; };
  const auto moves = [](const SurfaceDescription& wall) {
    return wall.surface.velocity() != Vec3{} ||
           std::holds_alternative<OscillatingPlane>(wall.surface.shape());
  };
  return scenario.thermostat || !scenario.motions.empty() || any_of_walls(scenario, is_warm) ||
         ranges::any_of(scenario.faces, face_moves) || ranges::any_of(scenario.surfaces, moves);
}

bool has_floor(const Scenario& scenario) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (scenario.gravity[axis] != 0 && scenario.box[axis].boundary == Boundary::wall) return true;
  }
  const auto bears = [&](const SurfaceDescription& wall) {
    const Vec3* const normal = wall.surface.normal();
    return normal ? dot(*normal, scenario.gravity) < 0 : is_round(wall);
  };
  return scenario.gravity != Vec3{} && ranges::any_of(scenario.surfaces, bears);
}

}  // namespace hardball
