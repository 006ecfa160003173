// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/run/engine_options.hpp"

namespace hardball {

/// The options as they are saved, but for threads and instructions: where a simulation is loaded, others may
/// be available.
struct SavedOptions {
  EngineOptions options;

  static void persist(auto& archive, auto& self) {
    auto& options = self.options;
    archive(options.engine, options.cell_edge, options.unit_costs);
    archive.require(options.engine >= EngineKind::automatic && options.engine <= EngineKind::paper);
  }
};

}  // namespace hardball
