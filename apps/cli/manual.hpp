// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "apps/cli/command_line.hpp"

namespace hardball::cli {

/// Prints the manual page of the program, with all commands and options that it has. Error (RunFailure): it
/// cannot be written.
ExitCode print_manual(const Command& program);

}  // namespace hardball::cli
