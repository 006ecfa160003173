// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/make_simulation.hpp"

#include <cmath>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/scenario/make_responses.hpp"

namespace hardball {
namespace {

// The options with the response of a scenario, unless they have their own.
EngineOptions completed(EngineOptions options, const Scenario& scenario) {
  if (options.have_response()) return options;
  if (scenario.bounce.contact_duration > 0 || std::isnan(scenario.restitution())) {
    options.responses = make_responses(scenario);
  } else {
    options.restitution = scenario.restitution();
    options.elastic_below = scenario.bounce.elastic_below;
  }
  return options;
}

}  // namespace

Simulation make_simulation(const Scenario& scenario, World start, const EngineOptions& options,
                           const OnProgress& on_progress) {
  try {
    Simulation simulation(std::move(start), completed(options, scenario), on_progress);
    if (scenario.thermostat) simulation.set_thermostat(Thermostat(*scenario.thermostat, scenario.seed));
    return simulation;
  } catch (const Error& error) {
    if (options.cell_edge && error.where() == "cell edge") throw;
    throw Error(error.problem(), scenario.name + ": " + error.where(), error.remedy());
  }
}

}  // namespace hardball
