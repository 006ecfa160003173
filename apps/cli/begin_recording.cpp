// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/begin_recording.hpp"

namespace hardball::cli {

RecordingWriter begin_recording(const std::filesystem::path& path, const Scenario& scenario,
                                const Simulation& simulation) {
  RecordingHeader header;
  header.begin = simulation.time();
  header.until = scenario.until;
  header.cell_edge = simulation.cell_edges();
  header.name = std::filesystem::path(scenario.name).stem().string();
  header.restitution = scenario.restitution;
  return {path, header, simulation.world()};
}

}  // namespace hardball::cli
