// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <optional>
#include <string>

#include "apps/cli/commands.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/progress.hpp"
#include "apps/cli/run_files.hpp"
#include "apps/cli/run_report.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/summary.hpp"
#include "apps/cli/terminal.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/measure/measures.hpp"

namespace hardball::cli {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double>(end - begin).count();
}

// Few enough that signals are checked and the progress line is updated several times a second.
std::uint64_t steps_per_slice(const Simulation& simulation) {
  constexpr std::uint64_t kSteps = 1 << 14;
  constexpr std::uint64_t kPairs = 1 << 23;
  if (simulation.engine() != EngineKind::all_pairs) return kSteps;
  return std::clamp<std::uint64_t>(kPairs / std::max<std::size_t>(simulation.size(), 1), 1, kSteps);
}

// Runs to `until`; false if interrupted by a signal.
bool run_to(Simulation& simulation, double until, std::optional<RunFiles>& files, Measures& measures,
            Progress& progress) {
  while (!is_interrupted()) {
    const RunLimits slice{.until = Time(until), .steps = steps_per_slice(simulation)};
    const RunStatus status = simulation.run(slice, measures);
    if (files) files->keep_current();
    progress.show(simulation);
    if (status == RunStatus::time_reached) return true;
  }
  return false;
}

// The time of snapshot k, k * interval; one that is past the end only because of rounding is at the end.
double snapshot_time(std::uint64_t k, double interval, double until) {
  constexpr double kRounding = 1e-14;
  const double time = static_cast<double>(k) * interval;
  return time > until && time <= until * (1 + kRounding) ? until : time;
}

// Runs to the end, writing snapshots; false if interrupted by a signal.
bool run_with_snapshots(Simulation& simulation, const Scenario& scenario, std::optional<RunFiles>& files,
                        Measures& measures, Progress& progress) {
  const double until = *scenario.until;
  if (files && scenario.snapshots_every) {
    for (std::uint64_t k = 0;; ++k) {
      const double time = snapshot_time(k, *scenario.snapshots_every, until);
      if (time > until) break;
      if (!run_to(simulation, time, files, measures, progress)) return false;
      files->write_snapshot(simulation);
      if (time == until) return true;
    }
  }
  return run_to(simulation, until, files, measures, progress);
}

bool run_to_end(Simulation& simulation, const Scenario& scenario, std::optional<RunFiles>& files,
                Measures& measures, bool quiet) {
  Progress progress(!quiet, *scenario.until);
  try {
    return run_with_snapshots(simulation, scenario, files, measures, progress);
  } catch (const RunFailure& failure) {
    throw RunFailure(std::string(failure.what()) + "; the run reached time " + to_text(simulation.time()));
  }
}

}  // namespace

ExitCode run(const Options& options) {
  const Clock::time_point begin = Clock::now();
  catch_signals();
  const Scenario scenario = read_scenario(options);
  auto [engine_options, simulation] = set_up(options, scenario);
  std::optional<RunFiles> files;
  if (options.out) {
    files.emplace(*options.out, scenario, simulation);
  } else if (scenario.output_directory) {
    files.emplace(*scenario.output_directory, scenario, simulation);
  }
  if (files && files->has_contacts()) {
    const Simulation& observed = simulation;
    simulation.on_contact([&](const Contact& contact) { files->note(contact, observed.world()); });
    simulation.on_velocity_change(
        [&](const VelocityChange& change) { files->note(change, observed.world()); });
  }
  // Measures are written to files.
  Measures measures(files ? scenario.measures : MeasureSettings{.names = {}});
  const Clock::time_point set_up = Clock::now();
  const bool is_complete = run_to_end(simulation, scenario, files, measures, options.quiet);
  measures.sample_the_rest(simulation.world(), simulation.now());
  const Seconds seconds{seconds_between(begin, set_up), seconds_between(set_up, Clock::now())};
  const Summary summary(scenario, simulation, seconds);
  const std::string json = summary.json();
  if (files) {
    const std::vector<Measurement> measurements = measures.results(simulation.world(), simulation.now());
    std::string html;
    if (scenario.report) {
      report::Report report = run_report(options, scenario, engine_options, simulation, summary);
      report.is_complete = is_complete;
      report.measurements = measurements;
      html = to_html(report);
    }
    files->finish(simulation, measurements, json, html);
  }
  write_output(options.json ? json : summary.table());
  if (is_complete) return ExitCode::done;
  write_message("interrupted at time " + to_text(simulation.time()) + " of " + to_text(*scenario.until));
  return ExitCode::failed;
}

}  // namespace hardball::cli
