// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A run in several processes.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/cli/commands.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/progress.hpp"
#include "apps/cli/run_files.hpp"
#include "apps/cli/run_report.hpp"
#include "apps/cli/seconds_since.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/started_run.hpp"
#include "apps/cli/summary.hpp"
#include "apps/cli/terminal.hpp"
#include "hardball/archive/archive.hpp"
#include "hardball/distributed/blocks_in_first.hpp"
#include "hardball/distributed/distributed_checkpoint.hpp"
#include "hardball/distributed/distributed_simulation.hpp"
#include "hardball/distributed/in_all.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/io/read_file.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/scenario/make_world.hpp"
#include "hardball/scenario/rest_watch.hpp"

namespace hardball::cli {
namespace {

using Clock = std::chrono::steady_clock;

// Error: the scenario asks for what processes cannot share.
void check_can_be_shared(const Scenario& scenario) {
  constexpr const char* kRemedy = "leave it out, or run it in one process";
  if (scenario.growth) throw Error("processes cannot share a growth", scenario.name, kRemedy);
  if (scenario.shear.is_present())
    throw Error("processes cannot share a sheared box", scenario.name, kRemedy);
  if (scenario.has_steps())
    throw Error("processes cannot share spheres with potentials of steps", scenario.name, kRemedy);
  if (scenario.has_merging())
    throw Error("processes cannot share spheres that merge", scenario.name, kRemedy);
}

// Whether spheres can be written to such a file block by block.
bool takes_parts(SnapshotFormat format) {
  return format == SnapshotFormat::extended_xyz || format == SnapshotFormat::extended_xyz_zst ||
         format == SnapshotFormat::lammps;
}

// Without measures there is no report, either.
void leave_out_measures(Scenario& scenario) {
  scenario.measures.names.clear();
  scenario.report = false;
}

void tell_of_left_out_measures(const OutputStyle& output, const Processes& processes) {
  if (!processes.is_first() || output.quiet) return;
  fmt::print(stderr,
             "hardball: several processes leave out measures and report, which need all spheres in one of "
             "them; name measures to have them\n");
}

std::size_t threads_of(const std::string& threads) {
  if (threads != "auto") return read_threads(threads);
  return 1;
}

// The same in all processes.
EngineOptions shared_engine_options(const EngineChoice& options, const Scenario& scenario,
                                    const World& empty) {
  if (options.cell_edge == "paper")
    throw Error("the paper's cell edge needs all spheres in one process", "--cell-edge",
                "give auto or a length");
  if (options.unit_costs == "measured")
    throw Error("processes would measure different costs", "--unit-costs",
                "give standard, or all four costs");
  if (options.queue != "calendar")
    throw Error("several processes have no other queue than the calendar", "--queue", "leave it out");
  EngineOptions engine_options = read_engine_options(options, scenario, empty);
  engine_options.threads = threads_of(options.threads);
  return engine_options;
}

// What a checkpoint holds, of one process or of several.
DistributedSimulation loaded(CheckpointReader& checkpoint, const std::filesystem::path& path,
                             std::size_t threads, Processes& processes) {
  if (std::ranges::count(checkpoint.names(), kDistributedSection) == 0) {
    std::optional<Simulation> whole;
    in_all(processes, [&] { whole = Simulation::load(checkpoint.section("simulation"), path.string()); });
    return DistributedSimulation::of(processes, *whole, threads);
  }
  std::string state;
  std::vector<std::string> blocks;
  in_all(processes, [&] {
    state = checkpoint.section(kDistributedSection);
    blocks = read_blocks(checkpoint, processes.rank(), processes.size());
  });
  return DistributedSimulation::load(processes, state, blocks, threads, path.string());
}

// The contents of the files that a scenario names.
std::string named_files(const Scenario& scenario) {
  std::string contents;
  const auto add = [&](const std::filesystem::path& file) { contents += archived(read_file(file)); };
  if (scenario.start_file) add(*scenario.start_file);
  for (const SphereGroup& group : scenario.spheres) {
    if (group.distribution && !group.distribution->file.empty()) add(group.distribution->file);
  }
  for (const auto& bond : scenario.bonds) {
    if (bond.file) add(*bond.file);
  }
  return contents;
}

// The scenario, which each process reads by itself: perhaps from the disk of another machine.
Scenario shared_scenario(Processes& processes, const ScenarioChoice& options) {
  Scenario scenario;
  std::string files;
  in_all(processes, [&] { scenario = read_scenario(options); });
  require_same(processes, scenario.text, "scenario");
  in_all(processes, [&] { files = named_files(scenario); });
  require_same(processes, files, "start file, or other file that the scenario names,");
  return scenario;
}

// A run between its start, or a checkpoint, and its end. Files are in the first process alone.
class DistributedRun {
 public:
  // `notes`: of the start, see Start.
  DistributedRun(ScenarioChoice choice, const OutputStyle& output, Scenario scenario,
                 DistributedSimulation simulation, std::vector<std::string> notes)
      : choice_(std::move(choice)),
        output_(output),
        scenario_(std::move(scenario)),
        simulation_(std::move(simulation)),
        notes_(std::move(notes)),
        processes_(simulation_.processes()),
        rest_(scenario_, simulation_.totals(), simulation_.size()) {
    std::ranges::sort(scenario_.checkpoint_at);
    std::ranges::sort(scenario_.trajectories);  // as files have them
  }

  // Opens the files of a new run, in this directory if there is one.
  void begin_files(const std::optional<std::filesystem::path>& directory, bool may_replace) {
    if (!directory) return;
    directory_ = *directory;
    const std::optional<Simulation> whole = scenario_.recording ? whole_simulation() : std::nullopt;
    in_first(processes_,
             [&] { files_.emplace(*directory_, scenario_, whole ? &*whole : nullptr, may_replace); });
    measures_ = Measures(scenario_.measures);
    follow_if_needed();
  }
  // Continues the files of a checkpoint, and the measures.
  void continue_files(const std::filesystem::path& directory, const FilesState& state, Measures measures,
                      std::uint64_t next_snapshot) {
    directory_ = directory;
    next_snapshot_ = next_snapshot;
    in_first(processes_, [&] { files_.emplace(*directory_, scenario_, state); });
    measures_ = std::move(measures);
    follow_if_needed();
  }

  // To the end. `seconds`: those so far.
  ExitCode carry_out(const Seconds& seconds) {
    seconds_ = seconds;
    seconds_before_ = seconds.run;
    kept_ = simulation_.time();
    begin_ = last_checkpoint_ = Clock::now();
    progress_.emplace(processes_.is_first() && !output_.quiet, *scenario_.until);
    if (directory_ && !has_checkpoint()) write_checkpoint(*directory_ / kCheckpoint);
    const bool is_complete = run_to_end();
    seconds_.run = seconds_before_ + seconds_since(begin_);
    if (directory_) write_checkpoint(*directory_ / kCheckpoint);
    progress_.reset();
    finish(is_complete);
    return is_complete ? ExitCode::done : ExitCode::failed;
  }

 private:
  bool run_to_end() {
    const double until = *scenario_.until;
    for (;;) {
      const double now = simulation_.time();
      rest_.look(now, [&] { return simulation_.totals(); });
      const double snapshot =
          has_snapshots() ? scenario_.snapshots.time(next_snapshot_, until) : SnapshotSchedule::kNoTime;
      const double checkpoint = next_kept_checkpoint();
      const double next = std::min({snapshot, checkpoint, until, rest_.next_look(now)});
      const std::uint64_t contacts =
          has_snapshots() ? scenario_.snapshots.contacts(next_snapshot_) : SnapshotSchedule::kNoContacts;
      const RunStatus status = rest_.since() ? RunStatus::time_reached : run_to(next, contacts);
      if (status == RunStatus::stopped) return false;
      const bool has_counted = status == RunStatus::contacts_reached;
      if (snapshot <= next || has_counted) {
        write_snapshot(has_counted ? simulation_.time() : snapshot);
        ++next_snapshot_;
      }
      if (has_counted) continue;
      if (checkpoint <= next) keep_checkpoint(next);
      const bool is_over = !has_snapshots() || !(scenario_.snapshots.time(next_snapshot_, until) <= until);
      if (next == until && is_over) return true;
    }
  }

  // Until `time`, samples at that time included, or until there have been `contacts` in all, or a signal
  // stops it.
  RunStatus run_to(double time, std::uint64_t contacts) {
    for (;;) {
      const Time sample = later(processes_.gather(measures_.next_sample()).front(), simulation_.now());
      const bool is_due = is_measured() && sample <= Time(time);
      const RunStatus status = run_without_samples(is_due ? sample : Time(time), contacts);
      if (status != RunStatus::time_reached || !is_due) return status;
      in_first(processes_,
               [&] { measures_.sample(*simulation_.whole(), later(sample, simulation_.last_change())); });
    }
  }

  RunStatus run_without_samples(const Time& until, std::uint64_t contacts) {
    for (;;) {
      if (says_first(is_checkpoint_due())) write_checkpoint(*directory_ / kCheckpoint);
      bool has_advanced = false;
      // Of what the first process sees, the others learn from the status.
      const auto stop = [&] {
        write([&] { files_->keep_current(); });
        progress_->show(std::max(simulation_.time(), reached_), collisions_);
        return !failure_.empty() || is_interrupted() ||
               (std::exchange(has_advanced, true) && is_checkpoint_due());
      };
      const RunLimits limits{
          .until = until, .contacts = contacts - simulation_.counters().contacts(), .stop = stop};
      const RunStatus status = simulation_.run(limits, is_observed(), [&](const Contact& contact) {
        reached_ = contact.time.value();
        measures_.note(contact);
        write([&] { files_->note(contact); });
      });
      collisions_ = simulation_.counters().collision;
      in_first(processes_, [&] {
        if (!failure_.empty()) throw RunFailure(failure_);
      });
      if (status != RunStatus::stopped || says_first(is_interrupted())) return status;
    }
  }

  // Writes to files in the midst of a run, of which the others hear of a failure when it has stopped.
  template <class Work>
  void write(Work&& work) {
    if (!files_ || !failure_.empty()) return;
    try {
      work();
    } catch (const RunFailure& failure) {
      failure_ = failure.what();
    }
  }

  bool is_measured() const { return directory_ && !scenario_.measures.names.empty(); }
  bool is_observed() const {
    return is_measured() || (directory_ && (scenario_.event_log || scenario_.recording));
  }

  // Measures need all spheres, and so do some files.
  void follow_if_needed() {
    if (is_measured() || scenario_.recording || !std::ranges::all_of(scenario_.trajectories, takes_parts))
      simulation_.follow_in_first();
    simulation_.on_velocity_change([this](const VelocityChange& change) {
      measures_.note(change);
      write([&] { files_->note(change, *simulation_.whole()); });
    });
  }

  bool has_snapshots() const { return directory_ && !scenario_.trajectories.empty(); }
  bool is_checkpoint_due() const {
    return files_ && seconds_since(last_checkpoint_) >= scenario_.checkpoint_every;
  }
  bool says_first(bool own) { return processes_.gather(own ? 1 : 0).front() == 1; }
  bool has_checkpoint() { return says_first(std::filesystem::exists(*directory_ / kCheckpoint)); }

  double next_kept_checkpoint() const {
    const std::vector<double>& times = scenario_.checkpoint_at;
    const auto next = std::ranges::upper_bound(times, kept_);
    return directory_ && next != times.end() ? *next : std::numeric_limits<double>::infinity();
  }

  void keep_checkpoint(double time) {
    kept_ = time;
    std::filesystem::path path;
    in_all(processes_, [&] { path = kept_checkpoint(*directory_, time); });
    write_checkpoint(path);
    write_checkpoint(*directory_ / kCheckpoint);
  }

  void write_checkpoint(const std::filesystem::path& path) {
    seconds_.run = seconds_before_ + seconds_since(begin_);
    std::vector<CheckpointSection> sections;
    // Files first: what they lack when the machine stops, no checkpoint refers to.
    in_first(processes_, [&] {
      const FilesState files = files_->save();
      sections = {{"run", archived(RunState{choice_, scenario_.text, scenario_.name, next_snapshot_, seconds_,
                                            notes_})},
                  {"files", archived(files)},
                  {"measures", archived(measures_)}};
    });
    write_distributed_checkpoint(simulation_, path, sections);
    last_checkpoint_ = Clock::now();
  }

  // The first process writes what it gets from the others block by block.
  void write_snapshot(double time) {
    Snapshot head = head_of_snapshot();
    head.time = time;
    const std::vector<std::vector<Traveler>> own = simulation_.own_blocks();
    const SphereTypes types = types_of_all(own);
    for (std::size_t k = 0; k < scenario_.trajectories.size(); ++k) {
      if (!takes_parts(scenario_.trajectories[k])) {
        in_first(processes_, [&] {
          Snapshot whole = snapshot_of(*simulation_.whole(), simulation_.now());
          whole.time = time;
          files_->write_snapshot(k, whole);
        });
        continue;
      }
      BlocksInFirst blocks(simulation_, own);
      const auto next = [&]() -> std::optional<Snapshot> {
        const std::optional<std::vector<Traveler>> block = blocks.next();
        if (!block) return std::nullopt;
        World world = simulation_.empty_world();
        for (const Traveler& traveler : *block) world.insert(traveler.state);
        Snapshot part = snapshot_of(world, simulation_.now());
        part.has_spins = head.has_spins;
        part.time = time;
        return part;
      };
      in_all(processes_, [&] {
        try {
          if (files_) files_->write_snapshot(k, {head, simulation_.size(), types, next});
        } catch (const RunFailure&) {
          blocks.complete();
          throw;
        }
        blocks.complete();
      });
    }
  }

  SphereTypes types_of_all(const std::vector<std::vector<Traveler>>& own) {
    SphereTypes types;
    for (const std::vector<Traveler>& block : own) {
      for (const auto& [state, contacts] : block) types.add(state.species, state.radius, state.mass);
    }
    SphereTypes all;
    for (const std::string& bytes : processes_.gather(archived(types))) {
      SphereTypes of_process;
      restore(bytes, "types of spheres", of_process);
      all.add(of_process);
    }
    return all;
  }

  // All but the spheres.
  Snapshot head_of_snapshot() {
    Snapshot head = snapshot_of(simulation_.empty_world(), simulation_.now());
    head.has_spins = simulation_.has_spins();
    const Extent extent = simulation_.extent();
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (simulation_.box().is_bounded(axis)) continue;
      head.box->low[axis] = extent.low[axis];
      head.box->size[axis] = extent.high[axis] - extent.low[axis];
    }
    return head;
  }

  void finish(bool is_complete) {
    const Totals totals = simulation_.totals();
    std::vector<std::size_t> species_counts = simulation_.species_counts();
    species_counts.resize(scenario_.species.size());
    const FinalState state{.world = simulation_.empty_world(),
                           .spheres = simulation_.size(),
                           .now = simulation_.now(),
                           .counters = simulation_.counters(),
                           .domains = simulation_.domains(),
                           .windows = simulation_.window_counters(),
                           .at_rest_since = rest_.since(),
                           .sums = simulation_.sums(),
                           .totals = totals,
                           .step_energy = 0,
                           .has_spins = simulation_.has_spins(),
                           .audit = simulation_.audit(),
                           .species_counts = species_counts,
                           .thermostat = simulation_.thermostat(),
                           .growth = {},
                           .engine = simulation_.engine(),
                           .cell_edge = simulation_.cell_edge(),
                           .memory_bytes = simulation_.memory_bytes()};
    const std::optional<Simulation> whole =
        is_measured() && scenario_.report ? whole_simulation() : std::nullopt;
    in_first(processes_, [&] {
      const Summary summary(scenario_, choice_.overrides, state, seconds_, notes_);
      const std::string json = summary.json();
      std::vector<Measurement> measurements;
      if (is_measured()) {
        measures_.sample_the_rest(*simulation_.whole(), simulation_.now());
        measurements = measures_.results(*simulation_.whole(), simulation_.now());
      }
      std::string html;
      if (whole) {
        html = to_html(run_report(choice_, scenario_, *whole, summary, measurements, is_complete));
      }
      if (files_) files_->finish(simulation_.time(), measurements, json, html);
      write_output(output_.json ? json : summary.table());
      if (is_complete) return;
      write_message("interrupted at time " + to_text(simulation_.time()) + " of " +
                    to_text(*scenario_.until) +
                    (files_ ? "; 'hardball resume " + directory_->string() + "' resumes it" : ""));
    });
  }

  // The same as a simulation of one process, in the first.
  std::optional<Simulation> whole_simulation() {
    const std::string saved = simulation_.save();
    const std::vector<std::vector<Traveler>> own = simulation_.own_blocks();
    BlocksInFirst blocks(simulation_, own);
    std::optional<Simulation> whole;
    if (processes_.is_first()) {
      std::vector<std::string> all;
      while (const std::optional<std::vector<Traveler>> block = blocks.next())
        all.push_back(DistributedSimulation::saved_block(*block));
      whole = DistributedSimulation::load_whole(saved, all, scenario_.name);
    }
    blocks.complete();
    return whole;
  }

  ScenarioChoice choice_;
  OutputStyle output_;
  Scenario scenario_;
  DistributedSimulation simulation_;
  std::vector<std::string> notes_;
  Processes& processes_;
  RestWatch rest_;
  std::optional<std::filesystem::path> directory_;
  std::optional<RunFiles> files_;
  std::uint64_t next_snapshot_ = 0;
  Seconds seconds_;
  double seconds_before_ = 0;
  double kept_ = 0;
  Measures measures_ = Measures({.names = {}});  // sampled in the first process
  double reached_ = 0;                           // by the contacts observed [T]
  std::uint64_t collisions_ = 0;
  std::string failure_;  // of files, in the midst of a run
  std::optional<Progress> progress_;
  Clock::time_point begin_;
  Clock::time_point last_checkpoint_;
};

}  // namespace

ExitCode run_distributed(const RunOptions& options, Processes& processes) {
  const Clock::time_point begin = Clock::now();
  catch_signals();
  Scenario scenario = shared_scenario(processes, options.scenario);
  check_can_be_shared(scenario);
  // Those that a run has by default: with measures the first process has to hold all spheres.
  const std::vector<std::string>& names = scenario.measures.names;
  const bool leaves_out = scenario.report || !names.empty();
  const bool are_named = !names.empty() && names != MeasureSettings().names;
  if (!are_named) leave_out_measures(scenario);
  std::optional<DistributedRun> run;
  {
    SetUpProgress progress(processes.is_first() && !options.output.quiet);
    Travelers brought;
    std::vector<std::string> notes;
    World empty = make_part(
        scenario, [&](SphereId id) { return id % processes.size() == processes.rank(); },
        [&](const SphereState& state) { brought.push_back({state}); }, progress.part(0, 1),
        [&](const std::string& note) { notes.push_back(note); });
    if (processes.is_first()) write_notes(notes, options.output.quiet);
    const EngineOptions engine_options = shared_engine_options(options.engine, scenario, empty);
    DistributedSimulation simulation(processes, std::move(empty), std::move(brought), engine_options);
    if (scenario.thermostat) simulation.set_thermostat(Thermostat(*scenario.thermostat, scenario.seed));
    run.emplace(options.scenario, options.output, scenario, std::move(simulation), std::move(notes));
  }
  std::optional<std::filesystem::path> directory = scenario.output_directory;
  if (options.out) directory = *options.out;
  if (directory && leaves_out && !are_named) tell_of_left_out_measures(options.output, processes);
  run->begin_files(directory, options.overwrite);
  return run->carry_out({.setup = seconds_since(begin)});
}

ExitCode resume_distributed(const ResumeOptions& options, Processes& processes) {
  const Clock::time_point begin = Clock::now();
  catch_signals();
  const std::filesystem::path directory = options.directory;
  const std::filesystem::path path = directory / options.checkpoint.value_or(kCheckpoint);
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
  });
  require_same(processes,
               checkpoint->section("run") + checkpoint->section("files") + checkpoint->section("measures"),
               "checkpoint");
  if (options.until) state.choice.until = options.until;
  Scenario scenario =
      changed_by(state.choice, parse_scenario(state.text, state.name, state.choice.overrides));
  check_can_be_shared(scenario);
  if (!measures.is_any_wanted()) {
    if (!scenario.measures.names.empty()) tell_of_left_out_measures(options.output, processes);
    leave_out_measures(scenario);
  }
  DistributedSimulation simulation = loaded(*checkpoint, path, threads_of(options.threads), processes);
  const double time = simulation.time();
  if (is_whole(directory, time, *scenario.until)) {
    if (processes.is_first()) tell_of_whole_run(directory, time, options.output);
    return ExitCode::done;
  }
  DistributedRun run(state.choice, options.output, scenario, std::move(simulation), std::move(state.notes));
  run.continue_files(directory, files, std::move(measures), state.next_snapshot);
  state.seconds.setup += seconds_since(begin);
  return run.carry_out(state.seconds);
}

}  // namespace hardball::cli
