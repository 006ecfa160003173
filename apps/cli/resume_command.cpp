// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <filesystem>

#include "apps/cli/commands.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/started_run.hpp"

namespace hardball::cli {

ExitCode resume(const ResumeOptions& options, Processes& processes) {
  catch_signals();
  auto run = resumed_run(options, processes);
  return run ? carry_out(*run) : ExitCode::done;
}

}  // namespace hardball::cli
