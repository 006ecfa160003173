// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/sweep/workers.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <ctime>
#include <deque>
#include <exception>
#include <fstream>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>
#include <tuple>
#include <utility>

#include "apps/cli/forecast.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/outlook.hpp"
#include "apps/cli/seconds_since.hpp"
#include "apps/cli/start.hpp"
#include "hardball/domains/processors.hpp"
#include "hardball/error.hpp"
#include "hardball/platform/program.hpp"

namespace hardball::sweep {
namespace {

using Clock = std::chrono::steady_clock;

// Calls work(i) for 0 <= i < count in several threads. Error: the first that a call has thrown, by its
// number.
template <class Work>
void for_each_in_threads(std::size_t count, std::size_t workers, const Work& work) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::exception_ptr> errors(count);
  const auto loop = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        errors[i] = std::current_exception();
      }
    }
  };
  std::vector<std::jthread> threads;
  for (std::size_t i = 1; i < std::min(workers, count); ++i) threads.emplace_back(loop);
  loop();
  threads.clear();
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

// Of all threads of this process [s].
double processor_time() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Cost {
  double seconds = 0;
  double bytes = 0;
};

Cost cost_of(const Study& study, const Member& member) {
  if (cli::is_interrupted()) throw RunFailure("interrupted");
  // A trial of half a second is worth its time where a run takes much longer.
  constexpr double kLong = 20;
  const cli::RunOptions options = study.run_of(member);
  try {
    const Scenario scenario = cli::read_scenario(options.scenario);
    const cli::Outlook outlook = cli::look_ahead({.unit_costs = "standard", .threads = "1"}, scenario, true);
    cli::Forecast forecast = cli::forecast_by_theory(scenario, outlook);
    if (forecast.seconds > kLong) forecast = cli::forecast_by_trial(scenario, outlook);
    return {forecast.seconds, cli::memory_bytes(outlook)};
  } catch (const Error& error) {
    throw Error(error.problem(),
                study.name + ": member " + member.name() + ", " + describe(member) + ": " + error.where(),
                error.remedy());
  }
}

// The memory of the machine or, if that is less, of the container, in bytes.
double memory_limit() {
  double bytes = std::numeric_limits<double>::infinity();
  if (const std::uint64_t all = platform::physical_memory(); all > 0) bytes = static_cast<double>(all);
  double quota = 0;
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> quota) bytes = std::min(bytes, quota);
  return bytes;
}

// Members that are yet to be run, for several workers.
class Queue {
 public:
  Queue(const std::vector<Task>& tasks) : waiting_(tasks.begin(), tasks.end()) {}

  // The next task for a worker; none if there is nothing left to do. Waits for memory, and for members that
  // other processes run.
  std::optional<Task> take() {
    std::unique_lock lock(mutex_);
    for (;;) {
      if (is_closed_ || cli::is_interrupted() || (waiting_.empty() && busy_.empty())) return std::nullopt;
      const auto fits = [&](const Task& task) { return running_ == 0 || bytes_ + task.bytes <= kMost_; };
      const auto found = std::ranges::find_if(waiting_, fits);
      if (found != waiting_.end()) {
        const Task task = *found;
        waiting_.erase(found);
        ++running_;
        bytes_ += task.bytes;
        return task;
      }
      // Those that others run are tried again after a while.
      changed_.wait_for(lock, std::chrono::milliseconds(200));
      waiting_.insert(waiting_.end(), busy_.begin(), busy_.end());
      busy_.clear();
    }
  }

  void end(const Task& task, bool is_busy) {
    const std::lock_guard lock(mutex_);
    --running_;
    bytes_ -= task.bytes;
    if (is_busy) busy_.push_back(task);
    changed_.notify_all();
  }

  void close() {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
    changed_.notify_all();
  }

 private:
  // The rest is for measures, files and other programs.
  static constexpr double kShare = 0.7;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Task> waiting_;
  std::vector<Task> busy_;
  std::size_t running_ = 0;
  double bytes_ = 0;
  const double kMost_ = kShare * memory_limit();
  bool is_closed_ = false;
};

// What has ended, from the workers to the thread that reports it.
struct Ended {
  Task task;
  Outcome outcome;
};

}  // namespace

std::size_t usual_workers(const std::vector<Task>& tasks) {
  constexpr double kShort = 1;
  double seconds = 0;
  for (const Task& task : tasks) seconds += task.seconds;
  const std::size_t cores = allowed_processors();
  return seconds < kShort * static_cast<double>(tasks.size()) ? 2 * cores : cores + 1;
}

std::vector<const Member*> unfinished(const std::vector<const Member*>& members) {
  std::vector<const Member*> found;
  for (const Member* member : members) {
    const State state = state_of(*member);
    if (state == State::fresh || state == State::interrupted) found.push_back(member);
  }
  return found;
}

std::vector<Task> check(const Study& study, const std::vector<const Member*>& members) {
  std::vector<const Member*> first;  // of each point
  for (const Member* member : members) {
    if (first.empty() || first.back()->point != member->point) first.push_back(member);
  }
  std::vector<Cost> costs(first.size());
  for_each_in_threads(first.size(), allowed_processors(),
                      [&](std::size_t i) { costs[i] = cost_of(study, *first[i]); });
  std::vector<Task> tasks;
  std::size_t at = 0;
  for (const Member* member : members) {
    if (member->point != first[at]->point) ++at;
    tasks.push_back({member, costs[at].seconds, costs[at].bytes});
  }
  std::ranges::sort(tasks, {},
                    [](const Task& task) { return std::tuple(-task.seconds, task.member->number); });
  return tasks;
}

Tally run(const Study& study, const std::vector<Task>& tasks, std::size_t workers,
          const Function<void(const Member&, const Outcome&)>& on_end,
          const Function<void(const Progress&)>& on_progress) {
  Queue queue(tasks);
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<Ended> ended;
  std::exception_ptr failure;
  std::size_t at_work = std::min(workers, tasks.size());
  const auto work = [&] {
    try {
      while (const std::optional<Task> task = queue.take()) {
        Outcome outcome = run_member(study, *task->member);
        const bool is_busy = outcome.ending == Ending::busy;
        queue.end(*task, is_busy);
        if (is_busy) continue;
        const std::lock_guard lock(mutex);
        ended.push_back({*task, std::move(outcome)});
        changed.notify_all();
      }
    } catch (...) {
      queue.close();
      const std::lock_guard lock(mutex);
      failure = std::current_exception();
    }
    const std::lock_guard lock(mutex);
    --at_work;
    changed.notify_all();
  };
  const auto begin = Clock::now();
  const double processor_seconds = processor_time();
  std::vector<std::jthread> threads;
  for (std::size_t i = 0; i < std::min(workers, tasks.size()); ++i) threads.emplace_back(work);
  double expected = 0;
  for (const Task& task : tasks) expected += task.seconds;
  Tally tally;
  Progress progress;
  std::unique_lock lock(mutex);
  for (bool is_over = false; !is_over;) {
    changed.wait_for(lock, std::chrono::milliseconds(100), [&] { return !ended.empty() || at_work == 0; });
    is_over = at_work == 0;
    const std::vector<Ended> now = std::exchange(ended, {});
    lock.unlock();
    for (const auto& [task, outcome] : now) {
      tally.finished += outcome.ending == Ending::finished ? 1U : 0U;
      tally.failed += outcome.ending == Ending::failed ? 1U : 0U;
      ++progress.ended;
      progress.share += expected > 0 ? task.seconds / expected : 0;
      on_end(*task.member, outcome);
    }
    on_progress(progress);
    lock.lock();
  }
  lock.unlock();
  threads.clear();
  if (failure) std::rethrow_exception(failure);
  tally.interrupted = tasks.size() - tally.finished - tally.failed;
  tally.seconds = cli::seconds_since(begin);
  const double cores = static_cast<double>(std::min({workers, tasks.size(), allowed_processors()}));
  tally.busy = (processor_time() - processor_seconds) / (tally.seconds * cores);
  return tally;
}

}  // namespace hardball::sweep
