// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "python/bindings/run_output.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "apps/cli/run_report.hpp"
#include "apps/cli/seconds_since.hpp"
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
    : origin_(std::move(origin)) {
  begin(simulation, measures);
  const SnapshotSchedule snapshots = origin_.scenario.output.snapshots();
  if (!snapshots.is_never()) {
    while (snapshots.time(next_snapshot_) < simulation.time() ||
           snapshots.contacts(next_snapshot_) < simulation.counters().contacts())
      ++next_snapshot_;
  }
  if (has_recording()) static_cast<void>(simulation.world());
  in_first(simulation.processes(),
           [&] { files_.emplace(directory_, origin_.scenario, simulation, overwrites); });
  write_checkpoint(simulation, measures);
}

RunOutput::RunOutput(Origin origin, const Simulation& simulation, const Measures& measures,
                     const cli::FilesState& files, const cli::RunState& state)
    : seconds(state.seconds), origin_(std::move(origin)), next_snapshot_(state.next_snapshot) {
  begin(simulation, measures);
  in_first(simulation.processes(), [&] { files_.emplace(directory_, origin_.scenario, files); });
}

// What both constructors do first.
void RunOutput::begin(const Simulation& simulation, const Measures& measures) {
  OutputDescription& output = origin_.scenario.output;
  if (!output.directory) {
    throw Error("no directory is given", "output",
                "name one, as in output('out'), or in [output] of the scenario");
  }
  directory_ = *output.directory;
  kept_ = simulation.time();
  std::ranges::sort(output.checkpoint_at);
  origin_.scenario.measures.names.clear();
  if (measures.is_any_wanted()) origin_.scenario.measures.names = {"all"};
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

double RunOutput::next_snapshot(double until) const {
  return origin_.scenario.output.snapshots().time(next_snapshot_, until);
}

double RunOutput::next_kept() const {
  const std::vector<double>& times = origin_.scenario.output.checkpoint_at;
  const auto next = std::ranges::upper_bound(times, kept_);
  return next == times.end() ? SnapshotSchedule::kNoTime : *next;
}

double RunOutput::next_time(double until) const {
  return std::min(next_snapshot(until), next_kept());
}

std::uint64_t RunOutput::next_contacts() const {
  return origin_.scenario.output.snapshots().contacts(next_snapshot_);
}

bool RunOutput::is_checkpoint_due() const {
  return cli::seconds_since(last_checkpoint_) >= origin_.scenario.output.checkpoint_every;
}

void RunOutput::keep_current() {
  write([&] { files_->keep_current(); });
}

void RunOutput::write_due(const Simulation& simulation, const Measures& measures, double time, double until) {
  while (next_snapshot(until) <= time) {
    write_snapshot(simulation, next_snapshot(until));
    ++next_snapshot_;
  }
  if (next_kept() <= time) {
    kept_ = time;
    std::filesystem::path path;
    in_all(simulation.processes(), [&] { path = cli::kept_checkpoint(directory_, time); });
    write_checkpoint(simulation, measures, path);
    write_checkpoint(simulation, measures);
  }
}

void RunOutput::write_counted(const Simulation& simulation) {
  write_snapshot(simulation, simulation.time());
  ++next_snapshot_;
}

void RunOutput::write_snapshot(const Simulation& simulation, double time) {
  static_cast<void>(simulation.world());
  in_first(simulation.processes(), [&] { files_->write_snapshot(simulation, time); });
}

void RunOutput::write_checkpoint(const Simulation& simulation, const Measures& measures) {
  write_checkpoint(simulation, measures, directory_ / cli::kCheckpoint);
  last_checkpoint_ = std::chrono::steady_clock::now();
}

void RunOutput::write_checkpoint(const Simulation& simulation, const Measures& measures,
                                 const std::filesystem::path& path) {
  std::vector<CheckpointSection> sections;
  in_first(simulation.processes(), [&] {
    sections =
        cli::sections_of(*files_, origin_.choice, origin_.scenario, next_snapshot_, seconds, {}, measures);
    sections.push_back({"until", archived(origin_.scenario.run.until)});
  });
  hardball::write_checkpoint(simulation, path, sections);
}

void RunOutput::finish(const Simulation& simulation, const Measures& measures, bool is_complete) {
  throw_if_failed();
  write_checkpoint(simulation, measures);
  const RunEnd end = end_of(origin_, simulation, measures, seconds, is_complete);
  in_first(simulation.processes(), [&] {
    files_->finish(simulation.time(), end.measurements, end.summary,
                   origin_.scenario.output.report ? end.report : "");
  });
}

}  // namespace hardball::python
