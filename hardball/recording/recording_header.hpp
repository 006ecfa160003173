// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/errors/export.hpp"
#include "hardball/recording/recording.hpp"
#include "hardball/simulation/simulation.hpp"

namespace hardball {

/// The header of a recording of a simulation that begins now, for RecordingWriter: all but the name, the end,
/// and the names of species.
HARDBALL_EXPORT RecordingHeader recording_header(const Simulation& simulation);

}  // namespace hardball
