// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/shown_run.hpp"

#include <filesystem>
#include <string>
#include <utility>

#include "apps/cli/run_files.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/temporary_file.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/viewer/recorded_progress.hpp"
#include "hardball/error.hpp"

namespace hardball::cli {

ShownRun::ShownRun(const ShownRunChoice& choice, std::uint64_t most_bytes) {
  if (std::filesystem::is_directory(choice.scenario.path)) {
    open_directory(choice);
  } else {
    start_scenario(choice, most_bytes);
  }
}

void ShownRun::open_directory(const ShownRunChoice& choice) {
  const ScenarioChoice& scenario = choice.scenario;
  const std::filesystem::path directory = scenario.path;
  const std::filesystem::path path = directory / "recording.hbr";
  if (scenario.until || scenario.seed || !scenario.overrides.empty() || choice.threads != "auto") {
    throw Error("is the directory of a run, which --until, --set, --seed and --threads cannot change",
                scenario.path, "leave them out, or name a scenario");
  }
  if (!std::filesystem::exists(path)) {
    throw Error("it has no recording.hbr", scenario.path,
                "run the scenario with recording = true in [output], or name the scenario itself");
  }
  recording_ = std::make_unique<viewer::SharedRecording>(path, OnDamage::keep_what_comes_before);
  recording_->update(viewer::recorded_progress(*recording_, directory / "summary.json"));
}

void ShownRun::start_scenario(const ShownRunChoice& choice, std::uint64_t most_bytes) {
  const Scenario scenario = read_scenario(choice.scenario);
  Start start = set_up({.threads = choice.threads}, scenario, choice.quiet);
  write_notes(start.notes, choice.quiet);
  Simulation& simulation = start.simulation;
  RestWatch rest(scenario, simulation.totals(), simulation.size());
  const TemporaryFile file;
  RecordingWriter writer = begin_recording(file.path(), scenario, simulation);
  recording_ = std::make_unique<viewer::SharedRecording>(file.path());
  run_ = std::make_unique<viewer::LiveRun>(std::move(simulation), std::move(writer), *recording_,
                                           *scenario.run.until, most_bytes, std::move(rest));
}

}  // namespace hardball::cli
