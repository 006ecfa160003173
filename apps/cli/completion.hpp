// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "apps/cli/command_line.hpp"

namespace hardball::cli {

/// Prints the script by which a shell completes commands, options and words to choose from
/// of the program. Error: an unknown shell; RunFailure: the script cannot be written.
ExitCode print_completion(const std::string& shell, const Command& program);

}  // namespace hardball::cli
