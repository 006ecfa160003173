// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "hardball/io/checkpoint_file.hpp"
#include "hardball/simulation/simulation.hpp"

namespace hardball {

/// Writes a checkpoint of a simulation, after other sections, which the first process gives. Several
/// processes, which share the file system, each add the spheres of their blocks: the same bytes for any
/// number of them. Error (RunFailure), in all processes: it cannot be written; the one before is kept.
void write_checkpoint(const Simulation& simulation, const std::filesystem::path& path,
                      std::span<const CheckpointSection> sections);

/// The simulation of a checkpoint, whatever number of processes wrote it; `where` names it in errors. Error,
/// in all processes: it is damaged; as for Simulation::from_parts.
Simulation read_simulation(CheckpointReader& checkpoint, const std::string& where, Processes& processes,
                           std::size_t threads);

}  // namespace hardball
