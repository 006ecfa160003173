// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <type_traits>

#include "hardball/engine/run.hpp"
#include "hardball/execution/collapse_guard.hpp"
#include "hardball/interaction/response_table.hpp"
#include "hardball/measure/contact_sums.hpp"
#include "hardball/run/engine_options.hpp"
#include "hardball/thermostats/thermostat.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The options as they are saved, but for threads and instructions: where a simulation is loaded, others may
/// be available.
struct SavedOptions {
  EngineOptions options;
  std::optional<ResponseTable> responses = {};  ///< Of archives before version 3.

  static void persist(auto& archive, auto& self) {
    auto& options = self.options;
    archive(options.engine, options.queue, options.cell_edge);
    if constexpr (std::remove_cvref_t<decltype(archive)>::kIsReading) {
      if (archive.version() < 3) {
        double coefficient = 1;
        double elastic_below = 0;
        archive(coefficient, elastic_below, self.responses);
        const Bounce plain(Restitution(coefficient, elastic_below));
        if (!self.responses) self.responses = ResponseTable(plain, plain);
      }
    }
    archive(options.unit_costs);
    archive.require(options.engine >= EngineKind::automatic && options.engine <= EngineKind::paper &&
                    options.queue >= QueueKind::calendar && options.queue <= QueueKind::ordered);
  }
};

}  // namespace hardball
