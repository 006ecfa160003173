// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "apps/cli/options.hpp"

namespace hardball::cli {

/// How the program ends.
enum ExitCode : int {
  kDone = 0,
  kFailed = 1,    ///< A run did not reach its end, or runs differ.
  kBadInput = 2,  ///< The scenario or the command line is wrong.
};

/// Each carries out a command. Error: bad input; RunFailure: the run failed.
ExitCode run(const Options& options);
ExitCode verify(const Options& options);
ExitCode check(const Options& options);

}  // namespace hardball::cli
