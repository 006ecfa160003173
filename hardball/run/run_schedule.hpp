// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <exception>

#include "hardball/engine/engine_base.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/processes/processes.hpp"

namespace hardball {

class EngineManager;

/// What comes next in a run: an actor acts, a sample is due, the run ends. The engine runs in stretches
/// from one to the next.
///
/// At times with the same double contacts come first, then actions, then samples. A stretch takes no longer
/// than about 10 ms, so that the run can be stopped, and the tuning be reviewed, wherever nothing else comes.
class RunSchedule {
 public:
  /// What is to be done after a stretch: the action of an actor, or a sample of the measures.
  enum class Item { nothing, action, sample };

  /// Begins a run at `now`.
  RunSchedule(const RunLimits& limits, const Time& now) : left_(limits), begin_(now), reached_(now) {}

  /// Runs the engine to what comes next, when there is an action at `action` and a sample is due at
  /// `sample`; kNever for neither; or by `most` contacts. A sample that was due before the run is taken when
  /// it begins.
  Item advance(EngineManager& manager, const Time& action, const Time& sample, std::uint64_t most,
               ContactSums& sums, const ContactObserver& observer);
  /// Counts the steps of what was done after a stretch.
  void spend(std::uint64_t steps);

  /// The time of the item that `advance` has returned; otherwise one that the run has reached.
  const Time& reached() const { return reached_; }
  bool is_over() const {
    const bool is_broken = status_ == RunStatus::observer_stopped || status_ == RunStatus::outdated;
    return !is_broken && (status_ != RunStatus::steps_reached || left_.steps == 0);
  }
  /// Why the run is over. Throws what RunLimits::stop has thrown.
  RunStatus status() const {
    if (failure_) std::rethrow_exception(failure_);
    return status_;
  }

 private:
  bool is_told_to_stop(std::uint64_t slice, Processes& processes);

  RunLimits left_;
  Time begin_;
  Time reached_;
  std::uint64_t steps_to_question_ = 0;  // whether to stop
  RunStatus status_ = RunStatus::steps_reached;
  std::exception_ptr failure_;  // of RunLimits::stop
};

}  // namespace hardball
