// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/memory/function.hpp"

namespace hardball::cli {

/// From now on the first SIGINT or SIGTERM only sets a flag; a second one ends the program. Exceeding a file
/// size limit becomes an error instead of a signal.
void catch_signals();

/// Whether such a signal has been received, interruption was requested, or who was to be asked says so. May
/// be called in any thread.
bool is_interrupted();

/// From now on runs are interrupted as by a signal, or no longer.
void request_interruption(bool is_wanted);

/// Asks `whether` from now on, too: for a program that catches signals by itself, as Python does.
void ask_for_interruption(Function<bool()> whether);

}  // namespace hardball::cli
