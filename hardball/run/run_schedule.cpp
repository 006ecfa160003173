// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/run/run_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>

#include "hardball/run/engine_manager.hpp"

namespace hardball {
namespace {

// The most steps of a stretch: some milliseconds, and few for each sphere.
std::uint64_t steps_of_slice(const EngineManager& manager) {
  constexpr std::uint64_t kMin = 1 << 10;
  constexpr std::uint64_t kMax = 1 << 14;
  constexpr std::uint64_t kPairs = 1 << 23;
  const std::uint64_t spheres = std::max<std::size_t>(manager.engine().size(), 1);
  if (manager.kind() == EngineKind::all_pairs) return std::clamp<std::uint64_t>(kPairs / spheres, 1, kMax);
  return std::clamp(spheres, kMin, kMax);
}

std::uint64_t steps_of(const Counters& done) {
  return done.contacts() + done.enter + done.leave + done.stale;
}

}  // namespace

RunSchedule::Item RunSchedule::advance(EngineManager& manager, const Time& action, const Time& sample,
                                       std::uint64_t most, ContactSums& sums,
                                       const ContactObserver& observer) {
  const std::uint64_t slice = steps_of_slice(manager);
  if (is_told_to_stop(slice, manager.processes())) return Item::nothing;
  const Time due = later(sample, begin_);
  const bool is_due = due <= left_.until && due < kNever;
  const Time end = is_due ? due : left_.until;
  const bool acts = action.high <= end.high && action < kNever;
  const RunLimits stretch{.until = acts ? action : end,
                          .contacts = std::min(left_.contacts, most),
                          .steps = std::min(left_.steps, slice)};
  EngineBase& engine = manager.engine();
  const Counters before = engine.counters();
  status_ = engine.run(stretch, sums, observer);
  const Counters done = engine.counters() - before;
  left_.contacts -= done.contacts();
  const bool is_slice = status_ == RunStatus::steps_reached;
  spend(is_slice ? stretch.steps : steps_of(done));
  // Only here may the time reached depend on the engine.
  if (is_slice && (left_.steps == 0 || left_.stop)) reached_ = engine.now();
  if (status_ == RunStatus::contacts_reached && left_.contacts > 0) status_ = RunStatus::steps_reached;
  if (status_ != RunStatus::time_reached) return Item::nothing;
  if (std::isfinite(stretch.until.high)) reached_ = stretch.until;
  if (!acts && !is_due) return Item::nothing;
  status_ = RunStatus::steps_reached;
  if (acts) return Item::action;
  // A sample looks at all spheres.
  steps_to_question_ -= std::min<std::uint64_t>(steps_to_question_, engine.size());
  return Item::sample;
}

void RunSchedule::spend(std::uint64_t steps) {
  left_.steps -= std::min(left_.steps, steps);
  steps_to_question_ -= std::min(steps_to_question_, steps);
}

bool RunSchedule::is_told_to_stop(std::uint64_t slice, Processes& processes) {
  if (!left_.stop || steps_to_question_ > 0) return false;
  steps_to_question_ = slice;
  bool stops = false;
  if (processes.is_first()) {
    try {
      stops = left_.stop();
    } catch (...) {
      failure_ = std::current_exception();
      stops = true;
    }
  }
  if (!processes.of_first(stops)) return false;
  status_ = RunStatus::stopped;
  return true;
}

}  // namespace hardball
