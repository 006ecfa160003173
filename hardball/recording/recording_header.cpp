// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/recording/recording_header.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/step_levels.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace hardball {
namespace {

// Of all spheres that meet; none if it is not one number.
std::optional<double> restitution_of(const Simulation& simulation) {
  if (simulation.has_custom_response()) return {};
  return simulation.world().interactions().table().restitution();
}

// Whether contacts may turn spheres or merge them.
bool needs_bodies(const Simulation& simulation) {
  const ResponseTable& table = simulation.world().interactions().table();
  return simulation.has_custom_response() || table.has_merging() ||
         simulation.world().Setting::features().has(Feature::roughness);
}

}  // namespace

RecordingHeader recording_header(const Simulation& simulation) {
  RecordingHeader header;
  header.has_bodies = needs_bodies(simulation);
  header.has_growth = simulation.growth() || simulation.world().motion().has_growth();
  header.has_motions = ranges::any_of(simulation.motions(),
                                      [](const DrivenMotion& motion) { return !motion.surfaces().empty(); });
  header.begin = simulation.time();
  header.cell_edge = simulation.cell_edges();
  header.restitution = restitution_of(simulation).value_or(std::numeric_limits<double>::quiet_NaN());
  header.gravity = simulation.world().motion().gravity();
  const auto surfaces = simulation.world().surfaces();
  for (const Surface& surface : surfaces) {
    if (!std::holds_alternative<OwnShape>(surface.shape())) continue;
    throw Error("a recording cannot describe the " + std::string(surface.name()), "surface",
                "run without a recording, or write a trajectory");
  }
  header.surfaces.assign(surfaces.begin(), surfaces.end());
  for (const Bond& bond : bonds_of(simulation.world())) header.bonds.push_back({bond.first, bond.second});
  return header;
}

}  // namespace hardball
