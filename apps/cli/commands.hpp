// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "apps/cli/options.hpp"
#include "hardball/processes.hpp"

namespace hardball::cli {

/// The exit status of the program.
enum class ExitCode : int {
  done = 0,
  failed = 1,     ///< A run or a packing did not reach its end, or runs differ.
  bad_input = 2,  ///< The scenario or the command line is wrong.
};

/// Each of the functions below executes a command. Error: bad input; RunFailure: the run failed.

/// Several processes call it with the same options; only the first one writes messages, and files but for
/// checkpoints. Error: in all processes.
ExitCode run(const RunOptions& options, Processes& processes);
/// Runs a scenario as `run` does, but leaves signals alone: for one of many runs in this process.
ExitCode run_in_process(const RunOptions& options, Processes& processes = one_process());
/// Resumes a run in several processes, which call it with the same options. Error: in all processes.
ExitCode resume(const ResumeOptions& options, Processes& processes);
ExitCode verify(const VerifyOptions& options);
ExitCode check(const CheckOptions& options);
ExitCode tune(const TuneOptions& options);
ExitCode pack(const PackOptions& options);
ExitCode convert(const ConvertOptions& options);
ExitCode info(const InfoOptions& options);
ExitCode view(const ViewOptions& options);
ExitCode replay(const ReplayOptions& options);
ExitCode film(const FilmOptions& options);
ExitCode sweep(const SweepOptions& options);

}  // namespace hardball::cli
