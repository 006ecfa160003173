// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/neighbor_list.hpp"
#include "hardball/simulation/distributed_engine_model.hpp"
#include "hardball/simulation/engine_model.hpp"

namespace hardball {

std::unique_ptr<AnyEngine> make_neighbors(World world, const EngineOptions& options,
                                          const PhaseSettings& settings, const Time& now,
                                          const Progress& progress) {
  return make_divided<NeighborList>(std::move(world), options, settings, now, progress);
}

std::unique_ptr<AnyDistributedEngine> make_distributed_neighbors(DistributedStart start,
                                                                 const PhaseSettings& settings) {
  return make_distributed_of<NeighborList>(std::move(start), settings);
}

}  // namespace hardball
