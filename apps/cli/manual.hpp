// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include "apps/cli/commands.hpp"

namespace hardball::cli {

/// Prints the manual page of the program, with all commands and options that it has. Error (RunFailure): it
/// cannot be written.
ExitCode print_manual(const CLI::App& program);

}  // namespace hardball::cli
