// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/chart/chart.hpp"
#include "apps/cli/commands.hpp"
#include "apps/cli/edge_sweep.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/output_paths.hpp"
#include "apps/cli/parse_number.hpp"
#include "apps/cli/progress.hpp"
#include "apps/cli/results.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/cli/unit_costs.hpp"
#include "apps/cli/warnings.hpp"
#include "apps/cli/written.hpp"
#include "hardball/error.hpp"
#include "hardball/io/output_file.hpp"
#include "hardball/scenario.hpp"
#include "hardball/theory.hpp"

namespace hardball::cli {
namespace {

// A quantity both predicted and counted, for one size of cells.
struct Compared {
  double predicted;
  double counted;
};

double ratio(double a, double b) {
  return b > 0 ? a / b : 0;
}

// Events of a kind per sphere and unit of time.
double rate(const EdgeSweep& sweep, std::size_t spheres, std::uint64_t events) {
  return static_cast<double>(events) / (static_cast<double>(spheres) * sweep.span);
}

Compared candidates_after_contact(const EdgePoint& point) {
  const CellCounts& expected = point.expected;
  const double passes = static_cast<double>(2 * point.counted.collision + point.counted.wall);
  return {ratio(expected.collision * expected.candidates_after_collision +
                    expected.wall * expected.candidates_after_wall,
                expected.collision + expected.wall),
          ratio(static_cast<double>(point.counted.contact_predictions), passes)};
}

Compared candidates_after_enter(const EdgePoint& point) {
  return {point.expected.candidates_after_enter, ratio(static_cast<double>(point.counted.enter_predictions),
                                                       static_cast<double>(point.counted.enter))};
}

Compared stale_per_collision(const EdgePoint& point) {
  return {ratio(2 * point.expected.stale, point.expected.collision),
          ratio(static_cast<double>(point.counted.stale), static_cast<double>(point.counted.collision))};
}

std::string pair_of(const Compared& comparison) {
  return fmt::format("  {:>9.4g} {:>9.4g}", comparison.predicted, comparison.counted);
}

std::string marks_of(const EdgeSweep& sweep, const EdgePoint& point) {
  std::string marks;
  if (point.is_chosen) marks += " auto";
  if (point.is_paper) marks += " paper";
  if (&point == &sweep.best()) marks += " best";
  return marks;
}

std::string table(const EdgeSweep& sweep, const GasStatistics& statistics, const UnitCosts& costs) {
  const EdgePoint& chosen = sweep.chosen();
  const std::size_t spheres = statistics.spheres;
  const auto both = [&](double expected, std::uint64_t counted) {
    return fmt::format("{:.4g} predicted, {:.4g} counted", expected, rate(sweep, spheres, counted));
  };
  std::string text;
  text += table_line("spheres", fmt::format("{}", spheres));
  text += table_line(statistics.is_flat() ? "area fraction" : "packing fraction",
                     fmt::format("{:.4g}", statistics.packing_fraction()));
  text += table_line("mean free path [L]", fmt::format("{:.4g}", mean_free_path(statistics)));
  text += table_line("unit costs [ns]", to_option(costs));
  text += table_line("rounds", fmt::format("{}", chosen.seconds.size()));
  text += "for each sphere in a unit of time, [1/T]:\n";
  text += table_line("  collisions", both(chosen.expected.collision / 2, chosen.counted.collision));
  text += table_line("  wall contacts", both(chosen.expected.wall, chosen.counted.wall));
  text += fmt::format("\n{:>9}  {:^19}  {:^19}  {:^19}  {:^19}  {:^19}\n", "cell", "seconds per",
                      "enters per", "predictions", "predictions", "stale per");
  text += fmt::format("{:>9}  {:^19}  {:^19}  {:^19}  {:^19}  {:^19}\n", "edge", "unit of time",
                      "sphere and time", "after a contact", "after an enter", "collision");
  text += fmt::format("{:>9}  {:^19}  {:^19}  {:^19}  {:^19}  {:^19}\n", "[L]", "[s/T]", "[1/T]", "[1]",
                      "[1]", "[1]");
  text += fmt::format("{:>9}  {:>9} {:>9}", "", "predicted", "measured");
  for (int column = 0; column < 4; ++column) text += fmt::format("  {:>9} {:>9}", "predicted", "counted");
  text += "\n";
  for (const EdgePoint& point : sweep.points) {
    text += fmt::format("{:>9.4g}", point.edge);
    text += pair_of({point.predicted_seconds, point.median_seconds()});
    text += pair_of({point.expected.enter, rate(sweep, spheres, point.counted.enter)});
    text += pair_of(candidates_after_contact(point));
    text += pair_of(candidates_after_enter(point));
    text += pair_of(stale_per_collision(point)) + " " + marks_of(sweep, point) + "\n";
  }
  const double best = sweep.best().median_seconds();
  text += fmt::format(
      "\nauto chooses {:.4g}: {:+.1f}% against the best measured, {:.4g}; the paper {:.4g}: {:+.1f}%\n",
      chosen.edge, 100 * (chosen.median_seconds() / best - 1), sweep.best().edge, sweep.paper().edge,
      100 * (sweep.paper().median_seconds() / best - 1));
  return text;
}

std::string csv(const EdgeSweep& sweep, std::size_t spheres) {
  std::string text =
      "cell_edge [L],predicted [s/T],measured_median [s/T],measured_least [s/T],measured_most [s/T],"
      "predicted_enter [1/T],counted_enter [1/T],predicted_after_contact [1],counted_after_contact [1],"
      "predicted_after_enter [1],counted_after_enter [1],predicted_stale [1],counted_stale [1],marks\n";
  for (const EdgePoint& point : sweep.points) {
    const Compared contact = candidates_after_contact(point);
    const Compared enter = candidates_after_enter(point);
    const Compared stale = stale_per_collision(point);
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", point.edge, point.predicted_seconds,
                    point.median_seconds(), point.seconds.front(), point.seconds.back(), point.expected.enter,
                    rate(sweep, spheres, point.counted.enter), contact.predicted, contact.counted,
                    enter.predicted, enter.counted, stale.predicted, stale.counted, marks_of(sweep, point));
  }
  return text;
}

// The predicted curve and the measured points.
void add_series(chart::Chart& chart, const EdgeSweep& sweep, const std::string& name,
                const std::function<Compared(const EdgePoint&)>& what) {
  chart::Series theory{.name = name + ", predicted", .marks = false};
  chart::Series measured{.name = name + ", measured", .line = false, .like_previous = true};
  for (const EdgePoint& point : sweep.points) {
    const Compared comparison = what(point);
    theory.x.push_back(point.edge);
    theory.y.push_back(comparison.predicted);
    measured.x.push_back(point.edge);
    measured.y.push_back(comparison.counted);
  }
  chart.series.push_back(std::move(theory));
  chart.series.push_back(std::move(measured));
}

std::string figure(const EdgeSweep& sweep, const Scenario& scenario, std::size_t spheres) {
  chart::Chart cost;
  cost.title = scenario.name + ": cost";
  cost.x = {.label = "edge of the cells [L]", .logarithmic = true};
  cost.y = {.label = "seconds for a unit of simulated time [s/T]", .logarithmic = true};
  add_series(cost, sweep, "cost", [](const EdgePoint& point) {
    return Compared{point.predicted_seconds, point.median_seconds()};
  });
  cost.markers = {{sweep.chosen().edge, "auto"}};
  if (&sweep.paper() != &sweep.chosen()) cost.markers.push_back({sweep.paper().edge, "paper"});
  chart::Chart counts;
  counts.title = scenario.name + ": counts";
  counts.x = cost.x;
  counts.y = {.label = "number", .logarithmic = true};
  add_series(counts, sweep, "enters per sphere and time", [&](const EdgePoint& point) {
    return Compared{point.expected.enter, rate(sweep, spheres, point.counted.enter)};
  });
  add_series(counts, sweep, "predictions after a contact", candidates_after_contact);
  add_series(counts, sweep, "predictions after an enter", candidates_after_enter);
  return chart::to_svg({cost, counts});
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  OutputFile file(path);
  file.append(text);
  file.close();
}

double read_budget(const TuneOptions& options) {
  constexpr const char* kRemedy = "give seconds such as 10";
  constexpr double kUsual = 10;
  if (!options.budget) return kUsual;
  const double seconds = parse_number<double>(*options.budget, "--budget", kRemedy);
  if (seconds > 0 && std::isfinite(seconds)) return seconds;
  throw Error("the budget is " + to_text(seconds), "--budget", kRemedy);
}

Simulation start(const Scenario& scenario, const EngineOptions& options, bool is_shown) {
  constexpr double kWorldMade = 0.5;  // the fraction of the work that this takes
  SetUpProgress progress(is_shown);
  std::vector<std::string> notes;
  World world = make_world(scenario, progress.part(0, kWorldMade),
                           [&](const std::string& note) { notes.push_back(note); });
  write_notes(notes, !is_shown);
  return start_simulation(scenario, std::move(world), options, progress.part(kWorldMade, 1));
}

// Runs until each sphere has collided twice on average, to the end if that is earlier, or until a part of the
// budget is spent.
void settle(Simulation& simulation, const Scenario& scenario, Budget& budget) {
  constexpr double kShare = 0.25;
  const std::uint64_t enough = simulation.size();
  simulation.run({.until = Time(*scenario.run.until), .stop = [&] {
                    budget.show("settling");
                    return simulation.tally().collisions() >= enough || budget.spent() >= kShare;
                  }});
}

}  // namespace

Tuning tune_cells(const TuneOptions& options) {
  const Scenario scenario = read_scenario(options.scenario);
  EngineOptions engine_options;
  engine_options.engine = EngineKind::cells;
  engine_options.unit_costs = read_unit_costs(options.unit_costs == "auto" ? "measured" : options.unit_costs);
  const double seconds = read_budget(options);
  if (options.out) make_directory(*options.out);
  Simulation simulation = start(scenario, engine_options, !options.quiet);
  std::string notes;
  for (const std::string& warning :
       warnings_of(scenario, gas_statistics(simulation.world(), simulation.now()))) {
    notes += table_line("note", warning);
  }
  std::optional<Budget> budget(std::in_place, seconds, !options.quiet);
  settle(simulation, scenario, *budget);
  const GasStatistics statistics = gas_statistics(simulation.world(), simulation.now());
  EdgeSweep sweep = sweep_cell_edges(simulation, simulation.options(), *budget);
  budget.reset();
  std::string files;
  if (options.out) {
    const std::filesystem::path directory = *options.out;
    write_file(directory / "tune.csv", csv(sweep, statistics.spheres));
    write_file(directory / "tune.svg", figure(sweep, scenario, statistics.spheres));
    for (const char* name : {"tune.csv", "tune.svg"}) files += written_line(directory / name);
  }
  std::string text = table(sweep, statistics, engine_options.unit_costs) + notes + files;
  return {std::move(sweep), std::move(text)};
}

ExitCode tune(const TuneOptions& options) {
  catch_signals();
  write_output(tune_cells(options).text);
  return ExitCode::done;
}

}  // namespace hardball::cli
