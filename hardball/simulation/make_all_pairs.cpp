// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/all_pairs.hpp"
#include "hardball/simulation/engine_model.hpp"

namespace hardball {

std::unique_ptr<AnyEngine> make_all_pairs(World world, const EngineOptions& options,
                                          const PhaseSettings& settings, const Time& now,
                                          const Progress& progress) {
  return make<AllPairs>(std::move(world), options, settings, now, progress);
}

}  // namespace hardball
