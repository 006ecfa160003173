// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "hardball/recording.hpp"
#include "hardball/scenario.hpp"
#include "hardball/simulation.hpp"

namespace hardball::cli {

/// Starts recording a scenario's simulation, which is at its start. Error: the file cannot be written.
RecordingWriter begin_recording(const std::filesystem::path& path, const Scenario& scenario,
                                const Simulation& simulation);

}  // namespace hardball::cli
