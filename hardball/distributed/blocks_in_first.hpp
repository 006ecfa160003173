// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "hardball/distributed/distributed_simulation.hpp"

namespace hardball {

/// The spheres of a distributed simulation on their way to the first process, one block after the other, so
/// that it never holds all.
class BlocksInFirst {
 public:
  /// Begins to take blocks from what own_blocks has returned, which outlives it.
  BlocksInFirst(const DistributedSimulation& simulation, const std::vector<std::vector<Traveler>>& own)
      : processes_(simulation.processes()), own_(own), blocks_(simulation.blocks()) {}

  /// In the first process, the next block in the order of ids; nothing at the end.
  std::optional<std::vector<Traveler>> next();
  /// In the first process takes all that are left, in others sends theirs. To be called in all.
  void complete();

 private:
  Processes& processes_;
  const std::vector<std::vector<Traveler>>& own_;
  std::size_t blocks_;
  std::size_t taken_ = 0;
};

}  // namespace hardball
