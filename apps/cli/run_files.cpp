// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/run_files.hpp"

#include <algorithm>
#include <array>
#include <system_error>
#include <vector>

#include "apps/cli/output_paths.hpp"
#include "hardball/error.hpp"
#include "hardball/io/open_output.hpp"
#include "hardball/io/replace_file.hpp"
#include "hardball/measures.hpp"

namespace hardball::cli {
namespace {

// In the order of SnapshotFormat.
constexpr std::array<const char*, 5> kTrajectories{"trajectory.xyz", "trajectory.xyz.zst", "trajectory.gsd",
                                                   "trajectory.lammpstrj", "trajectory.pvd"};
constexpr const char* kFrames = "trajectory";  // those of trajectory.pvd
constexpr const char* kEvents = "events.npy";
constexpr const char* kRecording = "recording.hbr";
constexpr const char* kReport = "report.html";
constexpr const char* kMeasures = "measures";
constexpr const char* kQuantities = "quantities.csv";
constexpr const char* kFaceForces = "_face_forces.vtp";  // after the name of a wall

std::filesystem::path table_of(std::string_view measure) {
  return std::string(measure) + ".csv";
}

// Removes a folder if it is empty.
void remove_empty(const std::filesystem::path& folder) {
  std::error_code not_empty;
  std::filesystem::remove(folder, not_empty);
}

// Removes the measures of an earlier run.
void remove_measures(const std::filesystem::path& folder) {
  std::filesystem::remove(folder / kQuantities);
  for (const std::string_view name : measure_names()) std::filesystem::remove(folder / table_of(name));
  if (!std::filesystem::is_directory(folder)) return;
  std::vector<std::filesystem::path> of_faces;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().filename().string().ends_with(kFaceForces)) of_faces.push_back(entry.path());
  }
  for (const std::filesystem::path& path : of_faces) std::filesystem::remove(path);
  remove_empty(folder);
}

// Removes the checkpoints that an earlier run has kept.
void remove_checkpoints(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder)) return;
  std::vector<std::filesystem::path> kept;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == kCheckpointEnding) kept.push_back(entry.path());
  }
  for (const std::filesystem::path& path : kept) std::filesystem::remove(path);
  remove_empty(folder);
}

// Error: the directory holds files of a run.
void refuse_files_of_a_run(const std::filesystem::path& directory) {
  const auto holds = [&](const std::filesystem::path& name) {
    return std::filesystem::is_regular_file(directory / name);
  };
  std::vector<std::filesystem::path> names(kTrajectories.begin(), kTrajectories.end());
  names.insert(names.end(), {kEvents, kRecording, kSummary, kReport, kCheckpoint,
                             std::filesystem::path(kMeasures) / kQuantities});
  for (const std::filesystem::path& name : names) {
    if (!holds(name)) continue;
    throw Error("holds " + name.string() + " of another run", directory.string(),
                "name another directory, resume that run with 'hardball resume', or replace its files with "
                "--overwrite");
  }
}

// Error: the checkpoint does not have the position of each trajectory of the run.
void check_trajectories(const std::filesystem::path& directory, const Scenario& scenario,
                        const FilesState& state) {
  for (const SnapshotFormat format : scenario.output.trajectory) {
    const char* const name = kTrajectories[static_cast<std::size_t>(format)];
    if (std::ranges::count(state.trajectories, name, [](const auto& each) { return each.first; }) == 1)
      continue;
    throw Error(std::string("the checkpoint does not say how far ") + name + " was written",
                directory.string(), "start the run again in another directory");
  }
}

// A file that a run continues. Error: it is gone.
std::filesystem::path continued(const std::filesystem::path& directory, const std::filesystem::path& name) {
  std::filesystem::path path = directory / name;
  if (!std::filesystem::exists(path)) {
    throw Error("the file that the run continues is gone", path.string(),
                "put it back, or start the run again in another directory");
  }
  return path;
}

void remove_all(const std::vector<std::filesystem::path>& paths) {
  std::error_code ignored;
  for (const std::filesystem::path& path : paths) std::filesystem::remove(path, ignored);
}

}  // namespace

void require_checkpoint(const std::filesystem::path& checkpoint) {
  if (std::filesystem::exists(checkpoint)) return;
  throw Error("there is no checkpoint", checkpoint.string(),
              "name the output directory of a run that has written one");
}

bool is_finished(const std::filesystem::path& directory) {
  return std::filesystem::exists(directory / kSummary);
}

std::vector<std::filesystem::path> files_of_run(const std::filesystem::path& directory) {
  std::vector<std::filesystem::path> names{kSummary, kCheckpoint};
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(directory / kKeptCheckpoints, missing)) {
    if (entry.path().extension() == kCheckpointEnding)
      names.push_back(std::filesystem::path(kKeptCheckpoints) / entry.path().filename());
  }
  std::sort(names.begin() + 2, names.end());
  names.insert(names.end(), kTrajectories.begin(), kTrajectories.end());
  names.insert(names.end(), {kEvents, kRecording});
  std::erase_if(names, [&](const auto& name) { return !std::filesystem::is_regular_file(directory / name); });
  return names;
}

RecordingWriter begin_recording(const std::filesystem::path& path, const Scenario& scenario,
                                const Simulation& simulation) {
  RecordingHeader header = recording_header(simulation);
  header.name = std::filesystem::path(scenario.name).stem().string();
  header.until = scenario.run.until;
  for (const SpeciesDescription& species : scenario.species) header.species_names.push_back(species.name);
  return {path, header, simulation.world()};
}

RunFiles::RunFiles(const std::filesystem::path& directory, const Scenario& scenario,
                   const Simulation& simulation, bool overwrites)
    : directory_(directory), has_measures_(!scenario.measures.names.empty()) {
  for (const char* name : kTrajectories) {
    const std::filesystem::path trajectory = directory / name;
    std::error_code missing;
    if (scenario.start_file && std::filesystem::equivalent(*scenario.start_file, trajectory, missing)) {
      throw Error("the run would overwrite the file it starts from", trajectory.string(),
                  "name another directory for the output");
    }
  }
  std::vector<std::filesystem::path> created = make_directory(directory);
  const auto undo = [&] {
    lock_.reset();
    remove_all(created);
  };
  try {
    lock_.emplace(directory);
    if (!overwrites) refuse_files_of_a_run(directory);
    std::vector<const char*> names(kTrajectories.begin(), kTrajectories.end());
    names.insert(names.end(), {kEvents, kRecording, kSummary, kReport, kCheckpoint});
    for (const char* name : {kMeasures, kKeptCheckpoints, kFrames}) refuse_link(directory / name);
    for (const char* name : names) {
      const std::filesystem::path path = directory / name;
      refuse_link(path);
      if (std::filesystem::is_directory(path)) {
        throw Error("is a directory", path.string(), "name another directory for the output");
      }
    }
    const auto begin = [&](const char* name, bool is_wanted, const auto& create) {
      const std::filesystem::path path = directory / name;
      if (is_wanted) {
        if (!std::filesystem::exists(path)) created.insert(created.begin(), path);
        create(path);
      } else {
        std::filesystem::remove(path);
      }
    };
    using Path = std::filesystem::path;
    for (std::size_t i = 0; i < kTrajectories.size(); ++i) {
      const auto format = static_cast<SnapshotFormat>(i);
      if (std::ranges::find(scenario.output.trajectory, format) == scenario.output.trajectory.end()) {
        Trajectory::remove(directory / kTrajectories[i]);
      } else {
        begin(kTrajectories[i], true,
              [&](const Path& path) { trajectories_.emplace_back(kTrajectories[i], Trajectory(path)); });
      }
    }
    begin(kEvents, scenario.output.event_log, [&](const Path& path) { events_.emplace(path); });
    begin(kRecording, scenario.output.recording,
          [&](const Path& path) { recording_.emplace(begin_recording(path, scenario, simulation)); });
    for (const char* name : {kSummary, kReport, kCheckpoint}) std::filesystem::remove(directory / name);
    remove_measures(directory / kMeasures);
    remove_checkpoints(directory / kKeptCheckpoints);
    if (has_measures_) {
      const std::vector<std::filesystem::path> made = make_directory(directory / kMeasures);
      created.insert(created.begin(), made.begin(), made.end());
    }
  } catch (const std::filesystem::filesystem_error& error) {
    undo();
    throw Error(error.code().message(), directory.string(), "name another directory for the output");
  } catch (...) {
    undo();
    throw;
  }
}

RunFiles::RunFiles(const std::filesystem::path& directory, const Scenario& scenario, const FilesState& state)
    : directory_(directory), lock_(directory), has_measures_(!scenario.measures.names.empty()) {
  check_trajectories(directory, scenario, state);
  for (const auto& [name, position] : state.trajectories) {
    trajectories_.emplace_back(name, Trajectory(continued(directory, name), position));
  }
  if (state.events) events_.emplace(continued(directory, kEvents), *state.events);
  if (state.recording) recording_.emplace(continued(directory, kRecording), *state.recording);
  if (has_measures_) make_directory(directory / kMeasures);
  // Those of the end before.
  for (const char* name : {kSummary, kReport}) std::filesystem::remove(directory / name);
}

FilesState RunFiles::save() {
  FilesState state;
  for (auto& [name, trajectory] : trajectories_) {
    state.trajectories.emplace_back(name, trajectory.position());
  }
  if (events_) state.events = events_->position();
  if (recording_) state.recording = recording_->save();
  return state;
}

void RunFiles::write_snapshot(const Simulation& simulation, double time) {
  if (trajectories_.empty()) return;
  Snapshot snapshot = snapshot_of(simulation.world(), simulation.now());
  snapshot.time = time;
  for (auto& [name, trajectory] : trajectories_) trajectory.append(snapshot);
}

void RunFiles::write_snapshot(std::size_t trajectory, const Snapshot& snapshot) {
  trajectories_[trajectory].second.append(snapshot);
}

void RunFiles::write_snapshot(std::size_t trajectory, const FrameParts& frame) {
  trajectories_[trajectory].second.append(frame);
}

Observer RunFiles::observer(const Simulation& simulation) {
  Observer observer;
  if (recording_) observer = recording_observer(*recording_, simulation);
  if (!events_) return observer;
  observer.contact = [this, record = observer.contact](const Contact& contact) {
    events_->append(contact);
    if (record) record(contact);
  };
  return observer;
}

void RunFiles::keep_current() {
  const auto now = std::chrono::steady_clock::now();
  if (now < next_flush_) return;
  next_flush_ = now + std::chrono::seconds(1);
  if (events_) events_->flush();
  for (auto& [name, trajectory] : trajectories_) trajectory.flush();
}

void RunFiles::flush_recording() {
  if (recording_) recording_->flush();
}

void RunFiles::finish(double time, std::span<const Measurement> measurements,
                      std::span<const FaceForces> forces, const std::string& summary,
                      const std::string& report) {
  for (auto& [name, trajectory] : trajectories_) trajectory.close();
  if (events_) events_->close();
  if (recording_) recording_->close(time);
  if (has_measures_) {
    const std::filesystem::path folder = directory_ / kMeasures;
    for (const Measurement& measurement : measurements) {
      if (!measurement.columns.empty())
        replace_file(folder / table_of(measurement.name), columns_csv(measurement));
    }
    for (const FaceForces& of_mesh : forces)
      replace_file(folder / (of_mesh.wall + kFaceForces), vtp_text(of_mesh));
    replace_file(folder / kQuantities, quantities_csv(measurements));
  }
  if (!report.empty()) replace_file(directory_ / kReport, report);
  // Last, because it marks the end of the run; see is_finished.
  replace_file(directory_ / kSummary, summary);
}

}  // namespace hardball::cli
