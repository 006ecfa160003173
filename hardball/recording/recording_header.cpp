// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/recording/recording_header.hpp"
#include "hardball/world/step_levels.hpp"

#include <limits>
#include <optional>
#include <variant>

namespace hardball {
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
  } else if (const auto* cone = std::get_if<Cone>(&surface.shape())) {
    recorded.shape = Shape::cone;
    recorded.direction = cone->axis();
    recorded.slope = cone->slope();
  } else {
    recorded.shape = Shape::obstacle;
    recorded.radius = std::get<Obstacle>(surface.shape()).radius();
  }
  return recorded;
}

// Of all spheres that meet; none if it is not one number.
std::optional<double> restitution_of(const Simulation& simulation) {
  if (simulation.has_custom_response()) return {};
  return simulation.world().interactions().table().restitution();
}

// Whether contacts may turn spheres or merge them.
bool needs_bodies(const Simulation& simulation) {
  const ResponseTable& table = simulation.world().interactions().table();
  return simulation.has_custom_response() || table.has_merging() || table.is_rough();
}

}  // namespace

RecordingHeader recording_header(const Simulation& simulation) {
  RecordingHeader header;
  header.has_bodies = needs_bodies(simulation);
  header.has_growth = simulation.growth() || simulation.world().motion().has_growth();
  header.begin = simulation.time();
  header.cell_edge = simulation.cell_edges();
  header.restitution = restitution_of(simulation).value_or(std::numeric_limits<double>::quiet_NaN());
  header.gravity = simulation.world().motion().gravity();
  for (const Surface& surface : simulation.world().surfaces()) {
    header.surfaces.push_back(recorded(surface, header.restitution));
  }
  for (const Bond& bond : bonds_of(simulation.world())) header.bonds.push_back({bond.first, bond.second});
  return header;
}

}  // namespace hardball
