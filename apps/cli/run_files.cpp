// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/run_files.hpp"

#include <array>
#include <system_error>
#include <vector>

#include "apps/cli/begin_recording.hpp"
#include "apps/cli/directory.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/io/extended_xyz.hpp"
#include "hardball/measure/csv.hpp"

namespace hardball::cli {
namespace {

constexpr const char* kTrajectory = "trajectory.xyz";
constexpr const char* kEvents = "events.npy";
constexpr const char* kRecording = "recording.hbr";
constexpr const char* kSummary = "summary.json";
constexpr const char* kReport = "report.html";
constexpr const char* kMeasures = "measures";
constexpr const char* kQuantities = "quantities.csv";

std::filesystem::path table_of(std::string_view measure) {
  return std::string(measure) + ".csv";
}

// Removes the measures of an earlier run, and the folder if it is then empty.
void remove_measures(const std::filesystem::path& folder) {
  std::filesystem::remove(folder / kQuantities);
  for (const std::string_view name : measure_names()) std::filesystem::remove(folder / table_of(name));
  std::error_code not_empty;
  std::filesystem::remove(folder, not_empty);
}

void remove_all(const std::vector<std::filesystem::path>& paths) {
  std::error_code ignored;
  for (const std::filesystem::path& path : paths) std::filesystem::remove(path, ignored);
}

}  // namespace

RunFiles::RunFiles(const std::filesystem::path& directory, const Scenario& scenario,
                   const Simulation& simulation)
    : directory_(directory), has_measures_(!scenario.measures.names.empty()) {
  const std::filesystem::path trajectory = directory / kTrajectory;
  std::error_code missing;
  if (scenario.start_file && std::filesystem::equivalent(*scenario.start_file, trajectory, missing)) {
    throw Error("the run would overwrite the file it starts from", trajectory.string(),
                "name another directory for the output");
  }
  std::vector<std::filesystem::path> created = make_directory(directory);
  try {
    for (const char* name : {kTrajectory, kEvents, kRecording, kSummary, kReport}) {
      const std::filesystem::path path = directory / name;
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
    begin(kTrajectory, scenario.snapshots_every.has_value(),
          [&](const Path& path) { trajectory_.emplace(path); });
    begin(kEvents, scenario.event_log, [&](const Path& path) { events_.emplace(path); });
    begin(kRecording, scenario.recording,
          [&](const Path& path) { recording_.emplace(begin_recording(path, scenario, simulation)); });
    for (const char* name : {kSummary, kReport}) std::filesystem::remove(directory / name);
    remove_measures(directory / kMeasures);
    if (has_measures_) {
      const std::vector<std::filesystem::path> made = make_directory(directory / kMeasures);
      created.insert(created.begin(), made.begin(), made.end());
    }
  } catch (const std::filesystem::filesystem_error& error) {
    remove_all(created);
    throw Error(error.code().message(), directory.string(), "name another directory for the output");
  } catch (...) {
    remove_all(created);
    throw;
  }
}

void RunFiles::write_snapshot(const Simulation& simulation) {
  if (trajectory_) append_snapshot(*trajectory_, simulation.world(), simulation.now());
}

void RunFiles::note(const Contact& contact, const World& world) {
  if (events_) events_->append(contact);
  if (recording_) recording_->note(contact, world);
}

void RunFiles::note(const VelocityChange& change, const World& world) {
  if (recording_) recording_->note(change, world);
}

void RunFiles::keep_current() {
  const auto now = std::chrono::steady_clock::now();
  if (!events_ || now < next_flush_) return;
  next_flush_ = now + std::chrono::seconds(1);
  events_->flush();
}

void RunFiles::finish(const Simulation& simulation, std::span<const Measurement> measurements,
                      const std::string& summary, const std::string& report) {
  if (trajectory_) trajectory_->close();
  if (events_) events_->close();
  if (recording_) recording_->close(simulation.time());
  if (has_measures_) {
    const std::filesystem::path folder = kMeasures;
    for (const Measurement& measurement : measurements) {
      if (!measurement.columns.empty()) write(folder / table_of(measurement.name), columns_csv(measurement));
    }
    write(folder / kQuantities, quantities_csv(measurements));
  }
  write(kSummary, summary);
  if (!report.empty()) write(kReport, report);
}

void RunFiles::write(const std::filesystem::path& name, const std::string& text) const {
  const std::filesystem::path path = directory_ / name;
  const std::filesystem::path unfinished = path.string() + ".part";
  std::error_code failure;
  try {
    OutputFile file(unfinished);
    file.append(text);
    file.close();
  } catch (...) {
    std::filesystem::remove(unfinished, failure);
    throw;
  }
  std::filesystem::rename(unfinished, path, failure);
  if (failure) throw RunFailure("cannot write " + path.string() + ": " + failure.message());
}

}  // namespace hardball::cli
