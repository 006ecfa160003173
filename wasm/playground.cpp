// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What the module of the playground has besides the C API: scenarios are checked without being started, and a
// run has the summary and the report of the program. playground/src/session.js calls these functions.
#include <string>
#include <vector>

#include "apps/cli/run_report.hpp"
#include "apps/cli/summary.hpp"
#include "apps/report/report.hpp"
#include "c/guard.hpp"
#include "c/handles.hpp"
#include "c/hardball.h"
#include "hardball/measures.hpp"
#include "hardball/scenario.hpp"

namespace {

using hardball::c::guarded;

// Texts that JavaScript reads before the next call.
std::string summary_text;
std::string report_text;

// As many spheres are placed while their scenario is edited.
constexpr std::size_t kMostPlaced = 5000;

std::size_t spheres_of(const hardball::Scenario& scenario) {
  std::size_t count = 0;
  for (const hardball::SphereGroup& group : scenario.spheres) count += group.count;
  return count;
}

}  // namespace

extern "C" {

/// Reads a scenario, and if it has few spheres, places them. `until` receives the end of the run, HUGE_VAL if
/// the scenario gives none [T]. Error: as for hb_start_scenario.
hb_status playground_check(const char* text, const char* name, double* until);
/// The summary in JSON and the report in HTML of a run that was to end at `until` [T], as `hardball run`
/// writes them; they are valid until the next call. `setup` and `run` are how long it took [seconds]. Error:
/// the simulation was not started by a scenario.
hb_status playground_results(const hb_simulation* simulation, double until, double setup, double run,
                             const char** summary, const char** report);
}

hb_status playground_check(const char* text, const char* name, double* until) {
  return guarded([&] {
    const hardball::Scenario scenario = hardball::parse_scenario(text, name);
    if (!scenario.start_file && spheres_of(scenario) <= kMostPlaced)
      static_cast<void>(hardball::make_world(scenario));
    *until = scenario.run.until.value_or(HUGE_VAL);
  });
}

hb_status playground_results(const hb_simulation* simulation, double until, double setup, double run,
                             const char** summary, const char** report) {
  return guarded([&] {
    hardball::c::check_given(simulation->scenario.get(), "scenario");
    hardball::Scenario scenario = *simulation->scenario;
    hardball::cli::ScenarioChoice choice{.path = scenario.name, .overrides = {}};
    if (scenario.run.until != until) choice.until = hardball::to_text(until);
    scenario.run.until = until;
    const hardball::Simulation& state = simulation->simulation;
    std::vector<hardball::Measurement> measurements;
    if (simulation->measures && simulation->measures->has_begun()) {
      hardball::Measures measures = *simulation->measures;
      measures.sample_the_rest(state.world(), state.now());
      measurements = measures.results(state.world(), state.now());
    }
    const std::vector<std::string> notes;
    const hardball::cli::Summary found{
        scenario, choice.overrides, hardball::cli::final_state(scenario, state), {setup, run}, notes};
    summary_text = found.json();
    report_text = to_html(hardball::cli::run_report(choice, scenario, state, found, measurements,
                                                    simulation->simulation.time() >= until));
    *summary = summary_text.c_str();
    *report = report_text.c_str();
  });
}
