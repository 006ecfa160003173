// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "python/bindings/run_output.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "apps/cli/run_report.hpp"
#include "apps/report/report.hpp"
#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/io/checkpoint_file.hpp"
#include "hardball/processes/in_all.hpp"
#include "hardball/simulation/simulation_checkpoint.hpp"

namespace hardball::python {
namespace {

constexpr const char* kNoScenario = "made in Python";

// A scenario of which nothing but [run] and [output] will be used.
constexpr const char* kAnyScenario = R"(
[box]
size = [1.0, 1.0, 1.0]
boundary = ["wall", "wall", "wall"]
[[spheres]]
count = 1
radius = 0.1
placement = "random"
mean_speed = 1.0
)";

bool is_described(const Origin& origin) {
  return !origin.scenario.text.empty();
}

// Results are written of the measures that are on.
Origin with_measures(Origin origin, const Measures& measures) {
  origin.scenario.measures.names.clear();
  if (measures.is_any_wanted()) origin.scenario.measures.names = {"all"};
  return origin;
}

std::filesystem::path directory_of(const Origin& origin) {
  if (origin.scenario.output.directory) return *origin.scenario.output.directory;
  throw Error("no directory is given", "output",
              "name one, as in output('out'), or in [output] of the scenario");
}

}  // namespace

Origin no_origin() {
  Origin origin;
  origin.scenario.name = kNoScenario;
  origin.choice.path = kNoScenario;
  return origin;
}

Origin with_overrides(const Origin& origin, const std::vector<std::string>& overrides) {
  Origin changed = origin;
  std::vector<std::string>& all = changed.choice.overrides;
  all.insert(all.end(), overrides.begin(), overrides.end());
  if (is_described(origin)) {
    changed.scenario = parse_scenario(origin.scenario.text, origin.scenario.name, all);
  } else {
    const Scenario parsed = parse_scenario(kAnyScenario, origin.scenario.name, all);
    changed.scenario.run = parsed.run;
    changed.scenario.output = parsed.output;
  }
  return changed;
}

RunEnd end_of(const Origin& origin, const Simulation& simulation, const Measures& measures,
              const cli::Seconds& seconds, bool is_complete) {
  Scenario scenario = origin.scenario;
  if (!scenario.run.until) scenario.run.until = simulation.time();
  // Those that were added to it may be of others.
  if (simulation.species_counts().size() > scenario.species.size()) scenario.species.clear();
  const std::vector<std::string> notes;
  const cli::Summary summary{scenario, origin.choice.overrides, cli::final_state(scenario, simulation),
                             seconds, notes};
  RunEnd end{.summary = summary.json()};
  Measures sampled = measures;
  sampled.sample_the_rest(simulation.world(), simulation.now());
  end.measurements = sampled.results(simulation.world(), simulation.now());
  end.face_forces = sampled.face_forces(simulation.world(), simulation.now());
  report::Report report =
      cli::run_report(origin.choice, scenario, simulation, summary, end.measurements, is_complete);
  if (!is_described(origin)) {
    report.scenario = std::string("# ") + kNoScenario + "\n";
    report.responses.clear();
    report.restitution = std::numeric_limits<double>::quiet_NaN();
  }
  end.report = to_html(report);
  return end;
}

RunOutput::RunOutput(Origin origin, const Simulation& simulation, const Measures& measures, bool overwrites)
    : origin_(with_measures(std::move(origin), measures)),
      directory_(directory_of(origin_)),
      schedule_(origin_.scenario.output, 0, simulation.time()) {
  schedule_.skip_snapshots(simulation.time(), simulation.counters().contacts());
  if (has_recording()) static_cast<void>(simulation.world());
  in_first(simulation.processes(),
           [&] { files_.emplace(directory_, origin_.scenario, simulation, overwrites); });
  write_checkpoint(simulation, measures);
}

RunOutput::RunOutput(Origin origin, const Simulation& simulation, const Measures& measures,
                     const cli::FilesState& files, const cli::RunState& state)
    : seconds(state.seconds),
      origin_(with_measures(std::move(origin), measures)),
      directory_(directory_of(origin_)),
      schedule_(origin_.scenario.output, state.next_snapshot, simulation.time()) {
  in_first(simulation.processes(), [&] { files_.emplace(directory_, origin_.scenario, files); });
}

Observer RunOutput::observer(const Simulation& simulation) {
  const OutputDescription& output = origin_.scenario.output;
  if (!(output.event_log || output.recording)) return {};
  const Observer observer = files_ ? files_->observer(simulation) : Observer();
  return {.contact = [this, observer](const Contact& contact) { write([&] { observer.contact(contact); }); },
          .change =
              [this, observer](const VelocityChange& change) {
                if (observer.change) write([&] { observer.change(change); });
              },
          .epoch =
              [this, observer](const Growth& epoch) {
                if (observer.epoch) write([&] { observer.epoch(epoch); });
              }};
}

// Writes to files in the midst of a run, which ends soon after a failure.
template <class Work>
void RunOutput::write(Work&& work) {
  if (!files_ || has_failed()) return;
  try {
    work();
  } catch (const RunFailure& failure) {
    failure_ = failure.what();
  }
}

void RunOutput::throw_if_failed() const {
  if (has_failed()) throw RunFailure(failure_);
}

double RunOutput::next_time(double until) const {
  return std::min(schedule_.snapshot_time(until), schedule_.kept_time());
}

void RunOutput::keep_current() {
  write([&] { files_->keep_current(); });
}

void RunOutput::flush_recording() {
  files_->flush_recording();
}

void RunOutput::write_due(const Simulation& simulation, const Measures& measures, double time, double until) {
  while (schedule_.snapshot_time(until) <= time) {
    write_snapshot(simulation, schedule_.snapshot_time(until));
    schedule_.note_snapshot();
  }
  if (schedule_.kept_time() <= time) {
    schedule_.note_kept(time);
    std::filesystem::path path;
    in_all(simulation.processes(), [&] { path = cli::kept_checkpoint(directory_, time); });
    write_checkpoint(simulation, measures, path);
    write_checkpoint(simulation, measures);
  }
}

void RunOutput::write_counted(const Simulation& simulation) {
  write_snapshot(simulation, simulation.time());
  schedule_.note_snapshot();
}

void RunOutput::write_snapshot(const Simulation& simulation, double time) {
  static_cast<void>(simulation.world());
  in_first(simulation.processes(), [&] { files_->write_snapshot(simulation, time); });
}

void RunOutput::write_checkpoint(const Simulation& simulation, const Measures& measures) {
  write_checkpoint(simulation, measures, directory_ / cli::kCheckpoint);
  schedule_.note_checkpoint();
}

void RunOutput::write_checkpoint(const Simulation& simulation, const Measures& measures,
                                 const std::filesystem::path& path) {
  std::vector<CheckpointSection> sections;
  in_first(simulation.processes(), [&] {
    sections = cli::sections_of(*files_, origin_.choice, origin_.scenario, schedule_.snapshot(), seconds, {},
                                measures);
    sections.push_back({"until", archived(origin_.scenario.run.until)});
  });
  hardball::write_checkpoint(simulation, path, sections);
}

void RunOutput::finish(const Simulation& simulation, const Measures& measures, bool is_complete) {
  throw_if_failed();
  write_checkpoint(simulation, measures);
  const RunEnd end = end_of(origin_, simulation, measures, seconds, is_complete);
  in_first(simulation.processes(), [&] {
    files_->finish(simulation.time(), end.measurements, end.face_forces, end.summary,
                   origin_.scenario.output.report ? end.report : "");
  });
}

}  // namespace hardball::python
