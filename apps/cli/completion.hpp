// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include "apps/cli/commands.hpp"
#include "apps/cli/options.hpp"

namespace hardball::cli {

/// Prints the script by which the shell `options.shell` completes commands, options and words to choose from
/// of the program. Error: an unknown shell; RunFailure: the script cannot be written.
ExitCode print_completion(const Options& options, const CLI::App& program);

}  // namespace hardball::cli
