// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/paper/paper_engine.hpp"
#include "hardball/simulation/engine_model.hpp"

namespace hardball {

std::unique_ptr<AnyEngine> make_paper(World world, const EngineOptions&, const PhaseSettings& settings,
                                      const Time& now, const Progress&) {
  return std::make_unique<EngineModel<PaperEngine>>(PaperEngine(std::move(world), settings, now), settings);
}

}  // namespace hardball
