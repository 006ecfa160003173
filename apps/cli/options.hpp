// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hardball/packing.hpp"

namespace hardball::cli {

class Arguments;

// --- What several commands ask for, as written on the command line. ---

/// A scenario, and how the command line changes it.
struct ScenarioChoice {
  std::string path;                       ///< A file; for commands that show runs, also a run's directory.
  std::vector<std::string> overrides;     ///< Changes of the form key=value.
  std::optional<std::string> until = {};  ///< The end of the run [T].
  std::optional<std::string> seed = {};
  std::optional<std::string> text = {};  ///< The scenario itself, where `path` is only its name.

  static void persist(auto& archive, auto& self) {
    archive(self.path, self.overrides, self.until, self.seed);
  }
};

/// The engine, and what else affects only the speed.
struct EngineChoice {
  std::string engine = "auto";
  std::string cell_edge = "auto";
  std::string unit_costs = "auto";
  std::string instructions = "auto";
  std::string threads = "auto";
};

/// How a command reports to the terminal.
struct OutputStyle {
  bool json = false;
  bool quiet = false;
  bool silent = false;  ///< Prints nothing, for one of many runs in this process.
};

/// A run to be shown by the viewer.
struct ShownRunChoice {
  ScenarioChoice scenario;
  std::string threads = "auto";
  bool quiet = false;
};

// --- The options of each command. ---

/// The options of hardball run.
struct RunOptions {
  ScenarioChoice scenario;
  EngineChoice engine;
  std::optional<std::string> out;
  OutputStyle output;
  bool overwrite = false;
  bool resume = false;
};

/// The options of hardball resume.
struct ResumeOptions {
  std::string directory;
  std::optional<std::string> until = {};
  std::optional<std::string> checkpoint = {};  ///< A path relative to the directory.
  std::optional<ScenarioChoice> started = {};  ///< How the run must have been started, if that matters.
  std::string threads = "auto";
  OutputStyle output;
};

/// The options of hardball verify.
struct VerifyOptions {
  ScenarioChoice scenario;
  bool quiet = false;
};

/// The options of hardball check.
struct CheckOptions {
  ScenarioChoice scenario;
  EngineChoice engine;
  OutputStyle output;
};

/// The options of hardball tune.
struct TuneOptions {
  ScenarioChoice scenario;
  std::string unit_costs = "auto";
  std::optional<std::string> budget;  ///< Seconds.
  std::optional<std::string> out;
  bool quiet = false;
};

/// The options of hardball pack.
struct PackOptions {
  PackingText packing;
  std::vector<std::string> outs;      ///< Files for the spheres.
  std::optional<std::string> report;  ///< A file for the page about the packing.
  std::optional<std::string> replay;  ///< A file for the page that shows the packing.
  std::optional<std::string> limit;   ///< Seconds.
  std::optional<std::string> checkpoint;
  std::string threads = "auto";
  OutputStyle output;
  bool polish = false;
  bool dry_run = false;
  bool overwrite = false;
};

/// The options of hardball convert.
struct ConvertOptions {
  std::string in;
  std::string out;
  std::optional<std::string> frame;
  bool quiet = false;
  bool overwrite = false;
};

/// The options of hardball info.
struct InfoOptions {
  std::vector<std::string> files;  ///< Files and directories.
};

/// The options of hardball view.
struct ViewOptions {
  ShownRunChoice run;
  std::optional<std::string> port;
  std::optional<std::string> recording_limit;  ///< Bytes.
  bool no_open = false;
};

/// The options of hardball replay.
struct ReplayOptions {
  ShownRunChoice run;
  std::optional<std::string> out;
  std::optional<std::string> most;  ///< A size, as in 5MB.
  std::string thin = "motion";
  bool overwrite = false;
};

/// The options of hardball film.
struct FilmOptions {
  std::string out;
  ShownRunChoice run;
  std::optional<std::string> from;   ///< A time.
  std::optional<std::string> to;     ///< A time.
  std::optional<std::string> speed;  ///< Simulated time in a second.
  std::string fps = "30";
  std::string spin = "0";  ///< Degrees.
  std::string size = "1280x720";
  std::string quality = "full";
  std::string view;                   ///< A link, or what is after its #.
  std::optional<std::string> frames;  ///< A directory for pictures.
  bool overwrite = false;
};

/// The options of hardball sweep.
struct SweepOptions {
  std::string study;
  std::optional<std::string> out;
  std::optional<std::string> workers;
  std::optional<std::string> member;  ///< The number of a part, from 1 on, of as many as `of` says.
  std::optional<std::string> of;
  OutputStyle output;
  bool retry = false;
  bool table = false;
  bool prepare = false;
  bool dry_run = false;
};

/// The options of hardball completion.
struct CompletionOptions {
  std::string shell;
};

/// Declares the arguments of a command, in the order of its help text; parsing the command line sets
/// `options`.
void declare(Arguments arguments, RunOptions& options);
void declare(Arguments arguments, ResumeOptions& options);
void declare(Arguments arguments, VerifyOptions& options);
void declare(Arguments arguments, CheckOptions& options);
void declare(Arguments arguments, TuneOptions& options);
void declare(Arguments arguments, PackOptions& options);
void declare(Arguments arguments, ConvertOptions& options);
void declare(Arguments arguments, InfoOptions& options);
void declare(Arguments arguments, ViewOptions& options);
void declare(Arguments arguments, ReplayOptions& options);
void declare(Arguments arguments, FilmOptions& options);
void declare(Arguments arguments, SweepOptions& options);
void declare(Arguments arguments, CompletionOptions& options);

}  // namespace hardball::cli
