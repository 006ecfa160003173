// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/start.hpp"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "apps/cli/parse_number.hpp"
#include "apps/cli/progress.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/cli/unit_costs.hpp"
#include "hardball/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/processes.hpp"
#include "hardball/run/make_engine.hpp"
#include "hardball/scenario.hpp"
#include "hardball/scenario/nearest_name.hpp"
#include "hardball/theory.hpp"
#include "hardball/tuning/cell_counts.hpp"
#include "hardball/tuning/cell_edge.hpp"

namespace hardball::cli {
namespace {

// None for those that the program chooses.
std::optional<InstructionSet> read_instructions(const std::string& choice) {
  const std::optional<InstructionSet> found = find_named<InstructionSet>(choice);
  if (found || choice == "auto") return found;
  throw Error("unknown value '" + shortened(choice) + "'", "--instructions",
              "choose one of auto, " + all_names<InstructionSet>());
}

// Whether the run will be so long that measuring takes less than a hundredth of it.
bool is_worth_measuring(const World& start, const Scenario& scenario) {
  constexpr double kLong = 10e9;  // nanoseconds
  if (start.size() == 0) return false;
  const GasStatistics statistics = gas_statistics(start, Time(0));
  const double rate = cost_rate(expected_counts(statistics, optimal_cell_edge(statistics)), UnitCosts{});
  return rate * static_cast<double>(start.size()) * *scenario.run.until > kLong;
}

// Those of the first process: each would measure others.
UnitCosts shared_unit_costs(const std::string& choice, Processes& processes) {
  UnitCosts costs;
  in_first(processes, [&] { costs = read_unit_costs(choice); });
  return processes.of_first(costs);
}

}  // namespace

void throw_as_of_command_line(const Error& error) {
  for (const auto& [option, argument] :
       {std::pair("cell edge", "--cell-edge"), std::pair("threads", "--threads")}) {
    if (error.where() == option) throw Error(error.problem(), argument, error.remedy());
  }
  throw error;
}

Scenario read_scenario(const ScenarioChoice& choice) {
  return changed_by(choice, choice.text ? parse_scenario(*choice.text, choice.path, choice.overrides)
                                        : load_scenario(choice.path, choice.overrides));
}

Scenario changed_by(const ScenarioChoice& choice, Scenario scenario) {
  if (choice.until) {
    const double until = parse_number<double>(*choice.until, "--until", "give a time such as 10");
    check_finite(until, "the time", "--until");
    if (until < 0)
      throw Error("the time is " + to_text(until), "--until", "runs start at 0; give a later time");
    scenario.run.until = until;
  }
  if (!scenario.run.until) {
    throw Error("key 'until' is missing in [run]", scenario.name,
                "add it, or give --until on the command line");
  }
  if (choice.seed) {
    scenario.run.seed =
        parse_number<std::uint64_t>(*choice.seed, "--seed", "give an integer from 0 to 18446744073709551615");
    fit_box(scenario);
  }
  return scenario;
}

Scenario read_shared_scenario(const ScenarioChoice& choice, Processes& processes) {
  Scenario scenario;
  in_all(processes, [&] { scenario = read_scenario(choice); });
  require_same_scenario(scenario, processes);
  return scenario;
}

EngineOptions read_engine_options(const EngineChoice& choice, const Scenario& scenario, const World& start,
                                  Processes& processes) {
  EngineOptions engine_options;
  engine_options.engine = value_named<EngineKind>(choice.engine, "--engine");
  engine_options.threads = read_threads(choice.threads);
  engine_options.instructions = read_instructions(choice.instructions);
  const bool has_cells = engine_options.engine != EngineKind::all_pairs;
  if (choice.unit_costs != "auto") {
    engine_options.unit_costs = shared_unit_costs(choice.unit_costs, processes);
  } else if (choice.cell_edge == "auto" && has_cells &&
             processes.of_first(is_worth_measuring(start, scenario))) {
    engine_options.unit_costs = shared_unit_costs("measured", processes);
  }
  if (choice.cell_edge == "paper") {
    if (processes.size() > 1)
      throw Error("the paper's cell edge needs all spheres in one process", "--cell-edge",
                  "give auto or a length");
    const double edge = paper_cell_edge(gas_statistics(start, Time(0)), engine_options.unit_costs);
    engine_options.cell_edge = allowed_cell_edge(start, engine_options.engine, edge);
  } else if (choice.cell_edge != "auto") {
    const double edge = parse_number<double>(choice.cell_edge, "--cell-edge", "give auto, paper or a length");
    check_positive(edge, "the edge", "--cell-edge");
    engine_options.cell_edge = edge;
  }
  return engine_options;
}

std::size_t read_threads(const std::string& threads) {
  if (threads == "auto") return 0;
  constexpr const char* kRemedy = "give auto or a positive number";
  const auto number = parse_number<std::size_t>(threads, "--threads", kRemedy);
  if (number == 0) throw Error("'0' is not accepted", "--threads", kRemedy);
  return number;
}

Simulation start_simulation(const Scenario& scenario, World world, const EngineOptions& options,
                            const OnProgress& on_progress, Processes& processes) {
  try {
    return make_simulation(scenario, std::move(world), options, on_progress, processes);
  } catch (const Error& error) {
    throw_as_of_command_line(error);
  }
}

Start set_up(const EngineChoice& choice, const Scenario& scenario, bool is_quiet, Processes& processes) {
  constexpr double kWorldMade = 0.5;  // the fraction of the work that this takes
  SetUpProgress progress(processes.is_first() && !is_quiet);
  std::vector<std::string> notes;
  World world = make_share(scenario, processes, progress.part(0, kWorldMade),
                           [&](const std::string& note) { notes.push_back(note); });
  const EngineOptions engine_options = read_engine_options(choice, scenario, world, processes);
  return {
      engine_options,
      start_simulation(scenario, std::move(world), engine_options, progress.part(kWorldMade, 1), processes),
      notes};
}

}  // namespace hardball::cli
