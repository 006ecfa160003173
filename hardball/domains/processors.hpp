// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace hardball {

/// The available processors on which one of a team of threads is to run; no other thread of the team runs on
/// them. If there are more processors than threads, a thread gets several, so that the operating system can
/// choose one that other processes leave alone. Precondition: there are at least as many processors as
/// threads.
std::vector<int> processors_of_thread(const std::vector<int>& available, std::size_t threads,
                                      std::size_t number);

/// The number of processors that this process may use, as the quota of a container allows; at least one.
std::size_t allowed_processors();

/// The number of idle processors that this process may use, from the one-minute load average and the quota of
/// a container; at least one.
std::size_t free_processors();

/// The number of processors that a quota of Linux allows, from the text of its file cpu.max: microseconds in
/// each period and the length of the period, or "max". At least one; all processors if there is no quota, or
/// the text is not one.
std::size_t processors_by_quota(std::string_view text, std::size_t processors);

}  // namespace hardball
