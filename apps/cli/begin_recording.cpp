// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/begin_recording.hpp"

#include "hardball/errors/error.hpp"
#include "hardball/recording/recording_header.hpp"

namespace hardball::cli {

RecordingWriter begin_recording(const std::filesystem::path& path, const Scenario& scenario,
                                const Simulation& simulation) {
  if (simulation.world().motion().has_growth()) {
    throw Error("spheres grow, and recordings show constant sizes", path.string(),
                "leave the recording out, or write a trajectory");
  }
  RecordingHeader header = recording_header(simulation);
  header.name = std::filesystem::path(scenario.name).stem().string();
  header.until = scenario.until;
  for (const SpeciesDescription& species : scenario.species) header.species_names.push_back(species.name);
  return {path, header, simulation.world()};
}

}  // namespace hardball::cli
