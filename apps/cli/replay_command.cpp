// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

#include "apps/cli/commands.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/output_paths.hpp"
#include "apps/cli/parse_number.hpp"
#include "apps/cli/shown_run.hpp"
#include "apps/cli/temporary_file.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/cli/written.hpp"
#include "apps/viewer/built_page.hpp"
#include "apps/viewer/replay.hpp"
#include "apps/viewer/thinned.hpp"
#include "hardball/error.hpp"

namespace hardball::cli {
namespace {

// A number of bytes, with a unit if it is followed by one. Error: it is none.
std::uint64_t read_bytes(const std::string& text, const std::string& option) {
  const std::string remedy = "give a size such as 5MB, 800kB or 5e6";
  double unit = 1;
  std::string number = text;
  for (const auto& [name, size] : {std::pair("kB", 1e3), std::pair("MB", 1e6), std::pair("GB", 1e9)}) {
    if (!number.ends_with(name)) continue;
    number.erase(number.size() - 2);
    unit = size;
    break;
  }
  const double bytes = unit * parse_number<double>(number, option, remedy);
  constexpr double kMost = 1e15;
  if (!(bytes >= 1 && bytes <= kMost)) throw Error("the size is " + shortened(text), option, remedy);
  return static_cast<std::uint64_t>(bytes);
}

viewer::Thinning read_thinning(const std::string& name) {
  if (name == "motion") return viewer::Thinning::motion;
  if (name == "end") return viewer::Thinning::end;
  throw Error("there is no '" + shortened(name) + "'", "--thin", "give motion or end");
}

// How the recording was thinned, in words.
std::string described(const viewer::Thinned& thinned) {
  if (thinned.moments == 0) return "thinned: ends at " + to_text(thinned.until);
  return "thinned: " + to_text(thinned.moments) + " moments, " + to_text(thinned.step) + " apart";
}

}  // namespace

ExitCode replay(const ReplayOptions& options) {
  using namespace std::chrono_literals;
  if (!options.out) {
    throw Error("no output file is given", "--out", "give one, such as --out replay.html");
  }
  const std::uint64_t most = options.most ? read_bytes(*options.most, "--most") : 0;  // none
  const viewer::Thinning thinning = read_thinning(options.thin);
  refuse_to_overwrite(*options.out, options.overwrite);
  catch_signals();
  // What is thinned may be long.
  constexpr std::uint64_t kMostThinned = 4'000'000'000;
  const ShownRun shown(options.run, most ? kMostThinned : viewer::kMaxReplayedBytes);
  while (!shown.recording().progress().is_finished) {
    if (is_interrupted()) throw RunFailure("interrupted; no replay has been written");
    std::this_thread::sleep_for(20ms);
  }
  const viewer::RunProgress progress = shown.recording().progress();
  std::string how;
  const std::uint64_t room =
      std::min(viewer::Replay::recorded_bytes(most, viewer::built_page()), viewer::kMaxReplayedBytes);
  if (most > 0 && shown.recording().length() > room) {
    const TemporaryFile file;
    how = ", " + described(viewer::write_thinned(shown.recording(), thinning, room, file.path()));
    viewer::SharedRecording thinned(file.path());
    thinned.update(progress);
    viewer::Replay(thinned, viewer::built_page()).write(*options.out);
  } else {
    viewer::Replay(shown.recording(), viewer::built_page()).write(*options.out);
  }
  const std::string contents = count_of(shown.recording().header().spheres, "sphere") + ", " +
                               count_of(progress.collisions, "collision") + how;
  if (!options.run.quiet) write_output(written_line(*options.out, contents));
  if (progress.failure) write_message(*progress.failure + "; " + *options.out + " shows it up to there");
  if (progress.damage) write_message(*progress.damage);
  return progress.failure || progress.damage ? ExitCode::failed : ExitCode::done;
}

}  // namespace hardball::cli
