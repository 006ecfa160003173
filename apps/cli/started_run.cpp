// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/started_run.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "apps/cli/interruption.hpp"
#include "apps/cli/output_schedule.hpp"
#include "apps/cli/progress.hpp"
#include "apps/cli/run_report.hpp"
#include "apps/cli/run_snapshot.hpp"
#include "apps/cli/seconds_since.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/terminal.hpp"
#include "hardball/archive/archive.hpp"
#include "hardball/checkpoint.hpp"
#include "hardball/error.hpp"
#include "hardball/io/read_file.hpp"
#include "hardball/io/replace_file.hpp"
#include "hardball/processes.hpp"
#include "hardball/scenario/error_watch.hpp"
#include "hardball/scenario/rest_watch.hpp"
#include "hardball/simulation/simulation_checkpoint.hpp"

namespace hardball::cli {
namespace {

using Clock = std::chrono::steady_clock;

// Writes a checkpoint of a run that has files. Error (RunFailure): it cannot be written; the one before is
// kept.
void write_checkpoint(StartedRun& run, const std::filesystem::path& path) {
  std::vector<CheckpointSection> sections;
  in_first(run.processes(), [&] {
    sections = sections_of(*run.files, run.choice, run.scenario, run.next_snapshot, run.seconds, run.notes,
                           run.measures);
  });
  write_checkpoint(run.simulation, path, sections);
}

// The work of a run from where it is to its end.
class Course {
 public:
  explicit Course(StartedRun& run)
      : run_(run),
        processes_(run.processes()),
        progress_(processes_.is_first() && !run.output.quiet, *run.scenario.run.until),
        seconds_before_(run.seconds.run),
        rest_(run.scenario, run.simulation.totals(), run.simulation.size()),
        errors_(run.measures.is_any_wanted() ? ErrorWatch(run.scenario) : ErrorWatch()),
        schedule_(run.directory ? run.scenario.output : OutputDescription(), run.next_snapshot,
                  run.simulation.time()) {
    observe_files();
  }

  /// Since when all spheres are at rest [T].
  const std::optional<double>& at_rest_since() const { return rest_.since(); }
  /// What says when errors were as small as wanted.
  const ErrorWatch& errors() const { return errors_; }

  // False if interrupted by a signal.
  bool complete() {
    try {
      // So that a run can be resumed whenever it fails.
      if (run_.directory && !processes_.of_first(std::filesystem::exists(current()))) write_current();
      const bool is_complete = run_to_end();
      note_seconds();
      if (run_.directory) write_checkpoint(run_, current());
      return is_complete;
    } catch (const RunFailure& failure) {
      throw RunFailure(std::string(failure.what()) + "; the run reached time " +
                       to_text(run_.simulation.time()));
    }
  }

 private:
  bool run_to_end() {
    const double until = *run_.scenario.run.until;
    for (;;) {
      const double now = run_.simulation.time();
      rest_.look(now, [&] { return run_.simulation.totals(); });
      if (errors_.is_time_to_look(now))
        errors_.look(now, run_.measures.results(run_.simulation.world(), run_.simulation.now()));
      if (errors_.reached()) return true;
      const double snapshot = schedule_.snapshot_time(until);
      const double checkpoint = schedule_.kept_time();
      const double next =
          std::min({snapshot, checkpoint, until, rest_.next_look(now), errors_.next_look(now)});
      const RunStatus status =
          rest_.since() ? RunStatus::time_reached : run_to(next, schedule_.snapshot_contacts());
      if (status == RunStatus::stopped) return false;
      const bool has_counted = status == RunStatus::contacts_reached;
      if (snapshot <= next || has_counted) {
        write_snapshot(run_, has_counted ? run_.simulation.time() : snapshot);
        schedule_.note_snapshot();
        run_.next_snapshot = schedule_.snapshot();
      }
      if (has_counted) continue;
      if (checkpoint <= next) keep_checkpoint(next);
      if (next == until && !(schedule_.snapshot_time(until) <= until)) return true;
    }
  }

  // Until `time`, or until there have been `contacts` in all, or a signal stops it.
  RunStatus run_to(double time, std::uint64_t contacts) {
    for (;;) {
      if (processes_.of_first(is_checkpoint_due())) write_current();
      bool has_advanced = false;  // however often checkpoints are wanted
      // Asked of the first process.
      const auto stop = [&] {
        write([&] { run_.files->keep_current(); });
        progress_.show(std::max(run_.simulation.time(), observed_), run_.simulation.tally().collisions());
        return !failure_.empty() || is_interrupted() ||
               (std::exchange(has_advanced, true) && is_checkpoint_due());
      };
      const RunLimits limits{
          .until = Time(time), .contacts = contacts - run_.simulation.counters().contacts(), .stop = stop};
      const RunStatus status = run_.simulation.run(limits, run_.measures);
      in_first(processes_, [&] {
        if (!failure_.empty()) throw RunFailure(failure_);
      });
      if (status != RunStatus::stopped || processes_.of_first(is_interrupted())) return status;
    }
  }

  // Writes contacts and changes to files. All processes observe the run, or none does.
  void observe_files() {
    if (!run_.directory || !(run_.scenario.output.event_log || run_.scenario.output.recording)) return;
    const Observer observer = run_.files ? run_.files->observer(run_.simulation) : Observer();
    run_.simulation.observe({.contact =
                                 [this, observer](const Contact& contact) {
                                   observed_ = contact.time.value();
                                   write([&] { observer.contact(contact); });
                                 },
                             .change =
                                 [this, observer](const VelocityChange& change) {
                                   if (observer.change) write([&] { observer.change(change); });
                                 },
                             .epoch =
                                 [this, observer](const Growth& epoch) {
                                   if (observer.epoch) write([&] { observer.epoch(epoch); });
                                 },
                             .surface =
                                 [this, observer](std::uint32_t number, const Surface& surface) {
                                   if (observer.surface) write([&] { observer.surface(number, surface); });
                                 }});
  }

  // Writes to files in the midst of a run. It ends soon after a failure, of which other processes hear then.
  template <class Work>
  void write(Work&& work) {
    if (!run_.files || !failure_.empty()) return;
    try {
      work();
    } catch (const RunFailure& failure) {
      failure_ = failure.what();
    }
  }

  std::filesystem::path current() const { return *run_.directory / kCheckpoint; }

  bool is_checkpoint_due() const { return run_.directory && schedule_.is_checkpoint_due(); }

  void keep_checkpoint(double time) {
    schedule_.note_kept(time);
    note_seconds();
    std::filesystem::path path;
    in_all(processes_, [&] { path = kept_checkpoint(*run_.directory, time); });
    write_checkpoint(run_, path);
    write_current();
  }

  void write_current() {
    note_seconds();
    write_checkpoint(run_, current());
    schedule_.note_checkpoint();
  }

  void note_seconds() { run_.seconds.run = seconds_before_ + seconds_since(begin_); }

  StartedRun& run_;
  Processes& processes_;
  Progress progress_;
  double seconds_before_;
  RestWatch rest_;
  ErrorWatch errors_;
  OutputSchedule schedule_;                   // without files, of nothing
  double observed_ = run_.simulation.time();  // the time of the last contact observed
  std::string failure_;                       // of files, in the midst of a run
  Clock::time_point begin_ = Clock::now();
};

// Whether a run that has reached `time` [T] and is to end at `until` [T] is whole, files included. Error: it
// has gone further.
bool is_whole(const std::filesystem::path& directory, double time, double until) {
  if (time > until) {
    throw Error("the run has reached time " + to_text(time) + ", later than its end at " + to_text(until),
                directory.string(), "give a later end with --until");
  }
  return time == until && is_finished(directory);
}

// Error: the run in a directory was started in another way.
void require_same_start(const RunState& state, const ScenarioChoice& choice,
                        const std::filesystem::path& directory) {
  const auto require = [&](bool is_same, const char* what) {
    if (is_same) return;
    throw Error(std::string("holds a run that was started with another ") + what, directory.string(),
                "name another directory, resume that run with 'hardball resume', or replace its files with "
                "--overwrite instead of --resume");
  };
  require(state.text == read_scenario(choice).text, "scenario");
  require(state.choice.overrides == choice.overrides, "--set");
  require(state.choice.until == choice.until, "--until");
  require(state.choice.seed == choice.seed, "--seed");
}

// Says that the run in a directory is whole; with --json, writes its summary to the standard output.
void tell_of_whole_run(const std::filesystem::path& directory, double time, const OutputStyle& output) {
  if (output.silent) return;
  if (output.json) write_output(read_file(directory / kSummary));
  if (output.quiet) return;
  write_message(directory.string() + ": the run is whole: it has reached its end at time " + to_text(time) +
                "; --until gives a later one");
}

}  // namespace

std::filesystem::path kept_checkpoint(const std::filesystem::path& directory, double time) {
  const std::filesystem::path folder = directory / kKeptCheckpoints;
  std::error_code failure;
  std::filesystem::create_directory(folder, failure);
  if (failure) throw RunFailure("cannot create " + folder.string() + ": " + failure.message());
  return folder / (to_text(time) + kCheckpointEnding);
}

std::vector<CheckpointSection> sections_of(RunFiles& files, const ScenarioChoice& choice,
                                           const Scenario& scenario, std::uint64_t next_snapshot,
                                           const Seconds& seconds, const std::vector<std::string>& notes,
                                           const Measures& measures) {
  // Files first: what they lack when the machine stops, no checkpoint refers to.
  const FilesState state = files.save();
  return {{"run", archived(RunState{choice, scenario.text, scenario.name, next_snapshot, seconds, notes})},
          {"files", archived(state)},
          {"measures", archived(measures)}};
}

void open_files(StartedRun& run, bool overwrites) {
  if (!run.directory) return;
  if (run.scenario.output.recording) static_cast<void>(run.simulation.world());
  // In the first process, which now knows all spheres that it writes.
  in_first(run.processes(),
           [&] { run.files.emplace(*run.directory, run.scenario, run.simulation, overwrites); });
}

ExitCode carry_out(StartedRun& run) {
  Simulation& simulation = run.simulation;
  Course course(run);
  const bool is_complete = course.complete();
  std::vector<Measurement> measurements;
  std::vector<FaceForces> forces;
  if (run.measures.is_any_wanted() || (run.directory && run.scenario.output.report)) {
    run.measures.sample_the_rest(simulation.world(), simulation.now());
    measurements = run.measures.results(simulation.world(), simulation.now());
    forces = run.measures.face_forces(simulation.world(), simulation.now());
  }
  if (is_complete && !course.errors().reached()) {
    for (std::string& failure : course.errors().failures(measurements))
      run.notes.push_back(std::move(failure));
  }
  Summary summary{run.scenario, run.choice.overrides, final_state(run.scenario, simulation), run.seconds,
                  run.notes};
  summary.state.at_rest_since = course.at_rest_since();
  summary.state.errors_reached_at = course.errors().reached();
  const std::string json = summary.json();
  std::string html;
  if (run.directory && run.scenario.output.report)
    html = to_html(run_report(run.choice, run.scenario, simulation, summary, measurements, is_complete));
  in_first(run.processes(), [&] {
    if (run.files) run.files->finish(simulation.time(), measurements, forces, json, html);
    if (run.output.silent) return;
    write_output(run.output.json ? json : summary.table());
    if (is_complete) return;
    write_message("interrupted at time " + to_text(simulation.time()) + " of " +
                  to_text(*run.scenario.run.until) +
                  (run.directory ? "; 'hardball resume " + run.directory->string() + "' resumes it" : ""));
  });
  return is_complete ? ExitCode::done : ExitCode::failed;
}

std::optional<StartedRun> resumed_run(const ResumeOptions& options, Processes& processes) {
  const std::filesystem::path directory = options.directory;
  const std::filesystem::path path = directory / options.checkpoint.value_or(kCheckpoint);
  const auto begin = Clock::now();
  std::optional<CheckpointReader> checkpoint;
  RunState state;
  FilesState files;
  Measures measures;
  in_all(processes, [&] {
    require_checkpoint(path);
    checkpoint.emplace(path);
    restore(checkpoint->section("run"), path.string(), state);
    restore(checkpoint->section("files"), path.string(), files);
    restore(checkpoint->section("measures"), path.string(), measures);
    if (options.started) require_same_start(state, *options.started, directory);
  });
  if (processes.size() > 1) {
    require_same(processes,
                 checkpoint->section("run") + checkpoint->section("files") + checkpoint->section("measures"),
                 "checkpoint");
  }
  ScenarioChoice& started = state.choice;
  if (options.until) started.until = options.until;
  Scenario scenario = changed_by(started, parse_scenario(state.text, state.name, started.overrides));
  const std::size_t threads = read_threads(options.threads);
  std::optional<Simulation> simulation;
  try {
    simulation.emplace(read_simulation(*checkpoint, path.string(), processes, threads));
  } catch (const Error& error) {
    throw_as_of_command_line(error);
  }
  state.seconds.setup += seconds_since(begin);
  const double time = simulation->time();
  if (is_whole(directory, time, *scenario.run.until)) {
    if (processes.is_first()) tell_of_whole_run(directory, time, options.output);
    return std::nullopt;
  }
  // It may have been begun without those that one would have by default.
  if (!measures.is_any_wanted()) scenario.measures.names.clear();
  StartedRun run{std::move(started),     options.output,      std::move(scenario),
                 std::move(*simulation), std::move(measures), directory,
                 std::nullopt,           state.next_snapshot, state.seconds,
                 std::move(state.notes)};
  in_first(processes, [&] {
    run.files.emplace(directory, run.scenario, files);
    // The current one may be later than what the files will hold.
    const std::filesystem::path current = directory / kCheckpoint;
    if (path != current) replace_file(current, read_file(path));
  });
  return run;
}

}  // namespace hardball::cli
