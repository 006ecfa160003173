// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/packing_replay.hpp"

#include <utility>
#include <vector>

#include "apps/cli/temporary_file.hpp"
#include "apps/viewer/built_page.hpp"
#include "apps/viewer/replay.hpp"
#include "apps/viewer/shared_recording.hpp"
#include "hardball/packing.hpp"
#include "hardball/recording.hpp"
#include "hardball/simulation.hpp"

namespace hardball::cli {
namespace {

constexpr SpeciesId kHeld = 0;
constexpr SpeciesId kRattler = 1;

// The spheres at rest; which of them rattle is their species.
Simulation at_rest(const Packing& packing) {
  const PackedSpheres& spheres = packing.spheres;
  const std::vector<bool>& rattles = packing.network.rattles;
  World world(spheres.container.box(), {}, spheres.container.surfaces());
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    world.add({.position = spheres.positions[i],
               .radius = spheres.radii[i],
               .species = !rattles.empty() && rattles[i] ? kRattler : kHeld});
  }
  return Simulation(std::move(world));
}

std::vector<RecordedForce> forces_of(const Packing& packing) {
  std::vector<RecordedForce> forces;
  for (const PackingContact& contact : packing.network.contacts) {
    const auto second = static_cast<std::int32_t>(contact.bodies.second);
    forces.push_back({.first = contact.bodies.first,
                      .second = contact.bodies.is_wall ? -(second + 1) : second,
                      .separation = contact.separation,
                      .force = contact.force});
  }
  return forces;
}

}  // namespace

void write_replay(const Packing& packing, const std::string& name, const std::filesystem::path& path) {
  const Simulation simulation = at_rest(packing);
  RecordingHeader header = recording_header(simulation);
  header.name = name;
  header.until = 0;
  header.cell_edge = {};
  header.forces = forces_of(packing);
  if (!header.forces.empty()) header.species_names = {"held", "rattlers"};
  const TemporaryFile file;
  RecordingWriter(file.path(), header, simulation.world()).close(0);
  viewer::SharedRecording recording(file.path());
  viewer::RunProgress progress;
  progress.is_finished = true;
  recording.update(progress);
  viewer::Replay(recording, viewer::built_page()).write(path);
}

}  // namespace hardball::cli
