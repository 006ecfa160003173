// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/memory/function.hpp"

namespace hardball::cli {

/// From now on the first SIGINT or SIGTERM only sets a flag; a second one ends the program. Exceeding a file
/// size limit becomes an error instead of a signal.
void catch_signals();

/// Whether such a signal has been received, or who was to be asked says so.
bool is_interrupted();

/// Asks `whether` from now on, too: for a program that catches signals by itself, as Python does.
void ask_for_interruption(Function<bool()> whether);

}  // namespace hardball::cli
