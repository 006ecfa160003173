// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace hardball::platform {

/// The processors on which the calling thread may run, by number; empty where that cannot be found out.
std::vector<int> available_processors();

/// Lets the calling thread run on these processors alone, where the system can do that. Only for speed: it
/// may fail.
void run_on(const std::vector<int>& processors);

/// Processors that were busy in the last minute, on the average; zero where that cannot be found out.
double load_average();

/// Processor time of the calling thread [s]; where it is not known, as if the thread always ran.
double thread_seconds();

/// Asks for huge pages behind this memory: a hint, which the system may ignore.
void advise_huge_pages(void* memory, std::size_t bytes);

}  // namespace hardball::platform
