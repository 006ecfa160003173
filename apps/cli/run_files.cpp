// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/run_files.hpp"

#include <array>
#include <system_error>
#include <vector>

#include "apps/cli/directory.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/io/extended_xyz.hpp"

namespace hardball::cli {
namespace {

constexpr const char* kTrajectory = "trajectory.xyz";
constexpr const char* kEvents = "events.npy";
constexpr const char* kSummary = "summary.json";
constexpr const char* kReport = "report.html";
constexpr const char* kUnfinishedReport = "report.html.part";

void remove_all(const std::vector<std::filesystem::path>& paths) {
  std::error_code ignored;
  for (const std::filesystem::path& path : paths) std::filesystem::remove(path, ignored);
}

}  // namespace

RunFiles::RunFiles(const std::filesystem::path& directory, const Scenario& scenario) : directory_(directory) {
  const std::filesystem::path trajectory = directory / kTrajectory;
  std::error_code missing;
  if (scenario.start_file && std::filesystem::equivalent(*scenario.start_file, trajectory, missing)) {
    throw Error("the run would overwrite the file it starts from", trajectory.string(),
                "name another directory for the output");
  }
  std::vector<std::filesystem::path> created = make_directory(directory);
  try {
    for (const char* name : {kTrajectory, kEvents, kSummary, kReport, kUnfinishedReport}) {
      const std::filesystem::path path = directory / name;
      if (std::filesystem::is_directory(path)) {
        throw Error("is a directory", path.string(), "name another directory for the output");
      }
    }
    if (scenario.snapshots_every) {
      if (!std::filesystem::exists(trajectory)) created.insert(created.begin(), trajectory);
      trajectory_.emplace(trajectory);
    } else {
      std::filesystem::remove(trajectory);
    }
    const std::filesystem::path events = directory / kEvents;
    if (scenario.event_log) {
      if (!std::filesystem::exists(events)) created.insert(created.begin(), events);
      events_.emplace(events);
    } else {
      std::filesystem::remove(events);
    }
    for (const char* name : {kSummary, kReport, kUnfinishedReport}) std::filesystem::remove(directory / name);
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

void RunFiles::note(const Contact& contact) {
  if (events_) events_->append(contact);
}

void RunFiles::finish(const std::string& summary, const std::string& report) {
  if (trajectory_) trajectory_->close();
  if (events_) events_->close();
  OutputFile file(directory_ / kSummary);
  file.append(summary);
  file.close();
  if (!report.empty()) write_report(report);
}

void RunFiles::write_report(const std::string& report) {
  // Under its own name it is never half written, not even if the machine stops.
  const std::filesystem::path unfinished = directory_ / kUnfinishedReport;
  std::error_code failure;
  try {
    OutputFile file(unfinished);
    file.append(report);
    file.close();
  } catch (...) {
    std::filesystem::remove(unfinished, failure);
    throw;
  }
  std::filesystem::rename(unfinished, directory_ / kReport, failure);
  if (failure) throw RunFailure("cannot write " + (directory_ / kReport).string() + ": " + failure.message());
}

}  // namespace hardball::cli
