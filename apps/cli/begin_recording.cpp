// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/begin_recording.hpp"

#include <algorithm>
#include <variant>

namespace hardball::cli {
namespace {

RecordedSurface recorded(const Surface& surface, double restitution) {
  RecordedSurface recorded;
  recorded.point = surface.point();
  recorded.velocity = surface.velocity();
  recorded.temperature = surface.material().temperature;
  recorded.restitution = surface.material().restitution.value_or(restitution);
  using Shape = RecordedSurface::Shape;
  if (const auto* plane = std::get_if<Plane>(&surface.shape())) {
    recorded.shape = Shape::plane;
    recorded.direction = plane->normal();
  } else if (const auto* moving = std::get_if<OscillatingPlane>(&surface.shape())) {
    recorded.shape = Shape::plane;
    recorded.direction = moving->normal();
    recorded.amplitude = moving->amplitude();
    recorded.frequency = moving->frequency();
  } else if (const auto* cylinder = std::get_if<Cylinder>(&surface.shape())) {
    recorded.shape = Shape::cylinder;
    recorded.direction = cylinder->axis();
    recorded.radius = cylinder->radius();
  } else if (const auto* sphere = std::get_if<HollowSphere>(&surface.shape())) {
    recorded.shape = Shape::sphere;
    recorded.radius = sphere->radius();
  } else {
    recorded.shape = Shape::obstacle;
    recorded.radius = std::get<Obstacle>(surface.shape()).radius();
  }
  return recorded;
}

// Whether contacts may turn spheres or merge them.
bool needs_bodies(const Scenario& scenario) {
  const auto is_rough = [](const BounceRules& rules) { return rules.tangential_restitution.has_value(); };
  return scenario.has_merging() || is_rough(scenario.bounce) ||
         std::ranges::any_of(scenario.pairs,
                             [&](const PairDescription& pair) { return is_rough(pair.bounce); });
}

}  // namespace

RecordingWriter begin_recording(const std::filesystem::path& path, const Scenario& scenario,
                                const Simulation& simulation) {
  RecordingHeader header;
  header.version = needs_bodies(scenario) ? 2 : 1;
  header.begin = simulation.time();
  header.until = scenario.until;
  header.cell_edge = simulation.cell_edges();
  header.name = std::filesystem::path(scenario.name).stem().string();
  header.restitution = scenario.restitution();
  header.gravity = scenario.gravity;
  for (const SpeciesDescription& species : scenario.species) header.species_names.push_back(species.name);
  for (const Surface& surface : simulation.world().surfaces()) {
    header.surfaces.push_back(recorded(surface, scenario.restitution()));
  }
  return {path, header, simulation.world()};
}

}  // namespace hardball::cli
