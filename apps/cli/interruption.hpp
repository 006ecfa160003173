// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

namespace hardball::cli {

/// From now on the first SIGINT or SIGTERM only sets a flag; a second one ends the program. Exceeding a file
/// size limit becomes an error instead of a signal.
void catch_signals();

/// Whether such a signal has been received.
bool is_interrupted();

}  // namespace hardball::cli
