// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "apps/sweep/member_run.hpp"
#include "apps/sweep/study.hpp"
#include "hardball/memory/function.hpp"

namespace hardball::sweep {

/// A member to be run, and what that is expected to take.
struct Task {
  const Member* member = nullptr;
  double seconds = 0;  ///< On one core.
  double bytes = 0;
};

/// As many workers for tasks as there are cores, and one more, so that all cores compute while a member waits
/// for the disk; twice as many as cores for runs of less than a second, which wait more often.
std::size_t usual_workers(const std::vector<Task>& tasks);

/// The members among these that are new or interrupted.
std::vector<const Member*> unfinished(const std::vector<const Member*>& members);

/// Checks members, one of each point, on all cores, and returns them as tasks, the longest first, in
/// the order of their numbers where they are equally long. Error: that of the first point whose scenario is
/// refused, with the member as its place. RunFailure: interrupted by a signal.
std::vector<Task> check(const Study& study, const std::vector<const Member*>& members);

/// The progress of tasks.
struct Progress {
  std::size_t ended = 0;
  double share = 0;  ///< The share of the work that is done [1].
};

/// What became of tasks.
struct Tally {
  std::size_t finished = 0;
  std::size_t failed = 0;
  std::size_t interrupted = 0;
  double seconds = 0;  ///< Wall time.
  double busy = 0;     ///< Processor time over that of the cores that the workers may use [1].
};

/// Runs tasks in as many threads as there are workers, in their order, but no more at once than memory holds;
/// waits for those that other processes run. `on_end` is called, never twice at once, when a member ends, and
/// `on_progress` ten times a second, both in this thread. Error (RunFailure): a directory cannot be written
/// to.
Tally run(const Study& study, const std::vector<Task>& tasks, std::size_t workers,
          const Function<void(const Member&, const Outcome&)>& on_end,
          const Function<void(const Progress&)>& on_progress);

}  // namespace hardball::sweep
