// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <chrono>
#include <string>
#include <thread>

#include "apps/cli/commands.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/output_paths.hpp"
#include "apps/cli/shown_run.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/cli/written.hpp"
#include "apps/viewer/built_page.hpp"
#include "apps/viewer/replay.hpp"
#include "hardball/error.hpp"

namespace hardball::cli {

ExitCode replay(const ReplayOptions& options) {
  using namespace std::chrono_literals;
  if (!options.out) {
    throw Error("no output file is given", "--out", "give one, such as --out replay.html");
  }
  refuse_to_overwrite(*options.out, options.overwrite);
  catch_signals();
  const ShownRun shown(options.run, viewer::kMaxReplayedBytes);
  while (!shown.recording().progress().is_finished) {
    if (is_interrupted()) throw RunFailure("interrupted; no replay has been written");
    std::this_thread::sleep_for(20ms);
  }
  viewer::Replay(shown.recording(), viewer::built_page()).write(*options.out);
  const viewer::RunProgress progress = shown.recording().progress();
  const std::string contents = count_of(shown.recording().header().spheres, "sphere") + ", " +
                               count_of(progress.collisions, "collision");
  if (!options.run.quiet) write_output(written_line(*options.out, contents));
  if (progress.failure) write_message(*progress.failure + "; " + *options.out + " shows it up to there");
  if (progress.damage) write_message(*progress.damage);
  return progress.failure || progress.damage ? ExitCode::failed : ExitCode::done;
}

}  // namespace hardball::cli
