// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "apps/cli/started_run.hpp"

namespace hardball::cli {

/// Appends the present frame of a run to its trajectories, with this time [T], if it has any. Where several
/// processes share the run and none has requested the world, spheres come block by block to the first of
/// them, which never holds all, if all formats allow that. Error (RunFailure), in all processes: it cannot be
/// written.
void write_snapshot(StartedRun& run, double time);

}  // namespace hardball::cli
