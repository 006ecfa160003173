// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/sheared_cells.hpp"
#include "hardball/simulation/engine_model.hpp"

namespace hardball {

std::unique_ptr<AnyEngine> make_sheared_cells(World world, const EngineOptions& options,
                                              const PhaseSettings& settings, const Time& now,
                                              const Progress& progress) {
  return make<ShearedCells>(std::move(world), options, settings, now, progress);
}

}  // namespace hardball
