// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "hardball/distributed/distributed_simulation.hpp"
#include "hardball/io/checkpoint_file.hpp"

namespace hardball {

/// The section with what DistributedSimulation::save returns, by which such checkpoints are known.
inline constexpr const char* kDistributedSection = "distributed";

/// Writes a checkpoint to which each process adds the spheres of its blocks: the same bytes for any number of
/// processes, which share the file system. `sections`: others, given by the first process. Error
/// (RunFailure), in all processes: it cannot be written; the one before is kept.
void write_distributed_checkpoint(const DistributedSimulation& simulation, const std::filesystem::path& path,
                                  std::span<const CheckpointSection> sections);

/// The blocks among the sections of a checkpoint.
std::vector<std::string> blocks_of(const std::map<std::string, std::string>& sections);
/// The blocks that a process reads of a checkpoint: every so many-th. Error: as for CheckpointReader.
std::vector<std::string> read_blocks(CheckpointReader& checkpoint, std::size_t rank, std::size_t processes);

}  // namespace hardball
