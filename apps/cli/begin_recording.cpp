// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/begin_recording.hpp"

#include "hardball/recording.hpp"

namespace hardball::cli {

RecordingWriter begin_recording(const std::filesystem::path& path, const Scenario& scenario,
                                const Simulation& simulation) {
  RecordingHeader header = recording_header(simulation);
  header.name = std::filesystem::path(scenario.name).stem().string();
  header.until = scenario.until;
  for (const SpeciesDescription& species : scenario.species) header.species_names.push_back(species.name);
  return {path, header, simulation.world()};
}

}  // namespace hardball::cli
