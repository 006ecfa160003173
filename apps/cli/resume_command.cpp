// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <filesystem>

#include "apps/cli/commands.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/started_run.hpp"

namespace hardball::cli {

ExitCode resume(const ResumeOptions& options) {
  catch_signals();
  const std::filesystem::path directory = options.directory;
  auto run = resumed_run(directory, directory / options.checkpoint.value_or(kCheckpoint), options);
  return run ? carry_out(*run) : ExitCode::done;
}

}  // namespace hardball::cli
