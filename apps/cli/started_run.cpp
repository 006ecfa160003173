// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/started_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "apps/cli/interruption.hpp"
#include "apps/cli/progress.hpp"
#include "apps/cli/run_report.hpp"
#include "apps/cli/seconds_since.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/terminal.hpp"
#include "hardball/archive/archive.hpp"
#include "hardball/distributed/distributed_checkpoint.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/io/checkpoint_file.hpp"
#include "hardball/io/read_file.hpp"
#include "hardball/io/replace_file.hpp"
#include "hardball/scenario/rest_watch.hpp"

namespace hardball::cli {
namespace {

using Clock = std::chrono::steady_clock;

// When the next snapshot is due [T]; infinity if that depends on contacts, or none is.
double next_snapshot_time(const StartedRun& run) {
  if (!run.files) return SnapshotSchedule::kNoTime;
  return run.scenario.snapshots.time(run.next_snapshot, *run.scenario.until);
}

// At how many contacts it is due.
std::uint64_t next_snapshot_contacts(const StartedRun& run) {
  if (!run.files) return SnapshotSchedule::kNoContacts;
  return run.scenario.snapshots.contacts(run.next_snapshot);
}

// The simulation of a checkpoint, written by one process or by several.
Simulation loaded(const std::map<std::string, std::string>& sections,
                  const std::filesystem::path& checkpoint) {
  const auto distributed = sections.find(kDistributedSection);
  if (distributed == sections.end()) {
    const auto whole = sections.find("simulation");
    return Simulation::load(whole == sections.end() ? "" : whole->second, checkpoint.string());
  }
  return DistributedSimulation::load_whole(distributed->second, blocks_of(sections), checkpoint.string());
}

// The work of a run from where it is to its end.
class Course {
 public:
  explicit Course(StartedRun& run)
      : run_(run),
        progress_(!run.output.quiet, *run.scenario.until),
        seconds_before_(run.seconds.run),
        rest_(run.scenario, totals_of(run.simulation.world(), run.simulation.now()), run.simulation.size()) {
    std::ranges::sort(run_.scenario.checkpoint_at);
  }

  /// Since when all spheres are at rest [T].
  const std::optional<double>& at_rest_since() const { return rest_.since(); }

  // False if interrupted by a signal.
  bool complete() {
    try {
      // So that a run can be resumed whenever it fails.
      if (run_.files && !std::filesystem::exists(run_.files->directory() / kCheckpoint)) write_current();
      const bool is_complete = run_to_end();
      note_seconds();
      if (run_.files) write_checkpoint(run_, run_.files->directory() / kCheckpoint);
      return is_complete;
    } catch (const RunFailure& failure) {
      throw RunFailure(std::string(failure.what()) + "; the run reached time " +
                       to_text(run_.simulation.time()));
    }
  }

 private:
  bool run_to_end() {
    const double until = *run_.scenario.until;
    for (;;) {
      const double now = run_.simulation.time();
      rest_.look(now, [&] { return totals_of(run_.simulation.world(), run_.simulation.now()); });
      const double snapshot = next_snapshot_time(run_);
      const double checkpoint = next_kept_checkpoint();
      const double next = std::min({snapshot, checkpoint, until, rest_.next_look(now)});
      const RunStatus status =
          rest_.since() ? RunStatus::time_reached : run_to(next, next_snapshot_contacts(run_));
      if (status == RunStatus::stopped) return false;
      const bool has_counted = status == RunStatus::contacts_reached;
      if (snapshot <= next || has_counted) {
        run_.files->write_snapshot(run_.simulation, has_counted ? run_.simulation.time() : snapshot);
        ++run_.next_snapshot;
      }
      if (has_counted) continue;
      if (checkpoint <= next) keep_checkpoint(next);
      if (next == until && !(next_snapshot_time(run_) <= until)) return true;
    }
  }

  // Until `time`, or until there have been `contacts` in all, or a signal stops it.
  RunStatus run_to(double time, std::uint64_t contacts) {
    for (;;) {
      if (is_checkpoint_due()) write_current();
      bool has_advanced = false;  // however often checkpoints are wanted
      const auto stop = [&] {
        if (run_.files) run_.files->keep_current();
        progress_.show(run_.simulation.time(), run_.simulation.counters().collision);
        return is_interrupted() || (std::exchange(has_advanced, true) && is_checkpoint_due());
      };
      const RunLimits limits{
          .until = Time(time), .contacts = contacts - run_.simulation.counters().contacts(), .stop = stop};
      const RunStatus status = run_.simulation.run(limits, run_.measures);
      if (status != RunStatus::stopped || is_interrupted()) return status;
    }
  }

  bool is_checkpoint_due() const {
    return run_.files && seconds_since(last_checkpoint_) >= run_.scenario.checkpoint_every;
  }

  // The first time after the present one at which a checkpoint is to be kept; infinity if there is none.
  double next_kept_checkpoint() const {
    const std::vector<double>& times = run_.scenario.checkpoint_at;
    const auto next = std::ranges::upper_bound(times, kept_);
    return run_.files && next != times.end() ? *next : std::numeric_limits<double>::infinity();
  }

  void keep_checkpoint(double time) {
    kept_ = time;
    note_seconds();
    write_checkpoint(run_, kept_checkpoint(run_.files->directory(), time));
    write_current();
  }

  void write_current() {
    note_seconds();
    write_checkpoint(run_, run_.files->directory() / kCheckpoint);
    last_checkpoint_ = Clock::now();
  }

  void note_seconds() { run_.seconds.run = seconds_before_ + seconds_since(begin_); }

  StartedRun& run_;
  Progress progress_;
  double seconds_before_;
  RestWatch rest_;
  double kept_ = run_.simulation.time();  // the last time at which a checkpoint was kept, or the run began
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_checkpoint_ = begin_;
};

}  // namespace

std::filesystem::path kept_checkpoint(const std::filesystem::path& directory, double time) {
  const std::filesystem::path folder = directory / kKeptCheckpoints;
  std::error_code failure;
  std::filesystem::create_directory(folder, failure);
  if (failure) throw RunFailure("cannot create " + folder.string() + ": " + failure.message());
  return folder / (to_text(time) + kCheckpointEnding);
}

ExitCode carry_out(StartedRun& run) {
  Simulation& simulation = run.simulation;
  if (run.files && run.files->has_contacts()) {
    simulation.log_contacts([&](const Contact& contact) { run.files->note(contact, &run.simulation); });
    simulation.on_velocity_change(
        [&](const VelocityChange& change) { run.files->note(change, run.simulation.world()); });
    simulation.on_epoch([&](const Growth& epoch) { run.files->note(epoch); });
  }
  Course course(run);
  const bool is_complete = course.complete();
  run.measures.sample_the_rest(simulation.world(), simulation.now());
  FinalState state = final_state(run.scenario, simulation);
  state.at_rest_since = course.at_rest_since();
  const Summary summary(run.scenario, run.choice.overrides, state, run.seconds, run.notes);
  const std::string json = summary.json();
  if (run.files) {
    const std::vector<Measurement> measurements = run.measures.results(simulation.world(), simulation.now());
    std::string html;
    if (run.scenario.report) {
      html = to_html(run_report(run.choice, run.scenario, simulation, summary, measurements, is_complete));
    }
    run.files->finish(simulation.time(), measurements, json, html);
  }
  write_output(run.output.json ? json : summary.table());
  if (is_complete) return ExitCode::done;
  write_message("interrupted at time " + to_text(simulation.time()) + " of " + to_text(*run.scenario.until) +
                (run.files ? "; 'hardball resume " + run.files->directory().string() + "' resumes it" : ""));
  return ExitCode::failed;
}

void write_checkpoint(StartedRun& run, const std::filesystem::path& path) {
  // Files first: what they lack when the machine stops, no checkpoint refers to.
  const FilesState files = run.files->save();
  const std::vector<CheckpointSection> sections{
      {"run", archived(RunState{run.choice, run.scenario.text, run.scenario.name, run.next_snapshot,
                                run.seconds, run.notes})},
      {"files", archived(files)},
      {"simulation", run.simulation.save()},
      {"measures", archived(run.measures)}};
  write_checkpoint_file(path, sections);
}

bool is_whole(const std::filesystem::path& directory, double time, double until) {
  if (time > until) {
    throw Error("the run has reached time " + to_text(time) + ", later than its end at " + to_text(until),
                directory.string(), "give a later end with --until");
  }
  return time == until && is_finished(directory);
}

void tell_of_whole_run(const std::filesystem::path& directory, double time, const OutputStyle& output) {
  if (output.json) write_output(read_file(directory / kSummary));
  if (output.quiet) return;
  write_message(directory.string() + ": the run is whole: it has reached its end at time " + to_text(time) +
                "; --until gives a later one");
}

std::optional<StartedRun> resumed_run(const std::filesystem::path& directory,
                                      const std::filesystem::path& checkpoint, const ResumeOptions& options) {
  require_checkpoint(checkpoint);
  std::map<std::string, std::string> sections = read_checkpoint_file(checkpoint);
  const auto restored = [&](const std::string& section, auto&... objects) {
    restore(sections[section], checkpoint.string(), objects...);
  };
  RunState state;
  restored("run", state);
  ScenarioChoice& started = state.choice;
  if (options.until) started.until = options.until;
  Scenario scenario = changed_by(started, parse_scenario(state.text, state.name, started.overrides));
  const auto begin = Clock::now();
  Simulation simulation = loaded(sections, checkpoint);
  set_threads(simulation, options.threads);
  state.seconds.setup += seconds_since(begin);
  const double time = simulation.time();
  if (is_whole(directory, time, *scenario.until)) {
    tell_of_whole_run(directory, time, options.output);
    return std::nullopt;
  }
  Measures measures;
  FilesState files;
  restored("measures", measures);
  restored("files", files);
  // Several processes may have begun it without those that one would have by default.
  if (!measures.is_any_wanted()) scenario.measures.names.clear();
  StartedRun run{std::move(started),    options.output,      std::move(scenario),
                 std::move(simulation), std::move(measures), std::nullopt,
                 state.next_snapshot,   state.seconds,       std::move(state.notes)};
  run.files.emplace(directory, run.scenario, files);
  // The current one may be later than what the files will hold.
  const std::filesystem::path current = directory / kCheckpoint;
  if (checkpoint != current) replace_file(current, read_file(checkpoint));
  return run;
}

}  // namespace hardball::cli
