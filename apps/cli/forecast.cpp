// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/forecast.hpp"

#include <cmath>

#include "apps/cli/trial.hpp"
#include "hardball/theory.hpp"
#include "hardball/tuning/cell_counts.hpp"
#include "hardball/tuning/cell_edge.hpp"
#include "hardball/tuning/neighbor_counts.hpp"

namespace hardball::cli {

double length_of(const Outlook& outlook) {
  const Simulation& simulation = outlook.simulation;
  const EngineOptions& options = outlook.options;
  if (!outlook.is_sample || simulation.engine() == EngineKind::all_pairs) {
    return simulation.engine() == EngineKind::neighbors ? simulation.skin() : simulation.cell_edge();
  }
  if (simulation.engine() == EngineKind::neighbors)
    return optimal_skin(outlook.statistics, options.unit_costs);
  return options.cell_edge.value_or(optimal_cell_edge(outlook.statistics, options.unit_costs));
}

double memory_bytes(const Outlook& outlook) {
  const Simulation& simulation = outlook.simulation;
  return static_cast<double>(simulation.memory_bytes()) / static_cast<double>(simulation.size()) *
         static_cast<double>(outlook.statistics.spheres);
}

Forecast forecast_by_theory(const Scenario& scenario, const Outlook& outlook) {
  const GasStatistics& statistics = outlook.statistics;
  const UnitCosts& costs = outlook.options.unit_costs;
  const bool has_lists = outlook.simulation.engine() == EngineKind::neighbors;
  double length = length_of(outlook);
  if (!(length > 0)) length = optimal_cell_edge(statistics, costs);
  const double rate =
      has_lists ? cost_rate(expected_neighbor_counts(statistics, length), costs)
                : cost_rate(expected_counts(statistics, length), costs_with_memory(statistics, costs));
  constexpr double kNanosecond = 1e-9;
  const double seconds = kNanosecond * static_cast<double>(statistics.spheres) * *scenario.run.until * rate;
  return {.seconds = std::isfinite(seconds) ? seconds : 0};
}

Forecast forecast_by_trial(const Scenario& scenario, const Outlook& outlook) {
  if (outlook.is_sample) return forecast_by_theory(scenario, outlook);
  const Trial trial = try_out(scenario, outlook);
  return {.seconds = expected_seconds(scenario, outlook, trial), .failure = trial.failure};
}

}  // namespace hardball::cli
