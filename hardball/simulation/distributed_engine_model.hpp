// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <utility>

#include "hardball/events/calendar_queue.hpp"
#include "hardball/parallel/distributed_engine.hpp"
#include "hardball/simulation/any_distributed_engine.hpp"

namespace hardball {

/// Gives any distributed engine the common interface.
template <class Wrapped>
class DistributedEngineModel final : public AnyDistributedEngine {
 public:
  explicit DistributedEngineModel(Wrapped engine) : engine_(std::move(engine)) {}

  RunStatus run(const RunLimits& limits, ContactSums& sums, bool is_observed,
                const Observe& observe) override {
    return engine_.run(limits, sums, is_observed, observe);
  }
  void change_velocities(const Time& moment, std::span<const VelocityEdit> edits) override {
    engine_.change_velocities(moment, edits);
  }
  Time now() const override { return engine_.now(); }
  Counters counters() const override { return engine_.counters(); }
  WindowCounters window_counters() const override { return engine_.window_counters(); }
  const Event& last_passage() const override { return engine_.last_passage(); }
  PhaseLengths lengths() const override { return engine_.lengths(); }
  std::size_t memory_bytes() const override { return engine_.memory_bytes(); }
  void for_each_own(const Function<void(const World&, Slot, std::uint32_t)>& visit) const override {
    engine_.for_each_own(visit);
  }
  void for_each_domain(const Function<void(const World&)>& visit) const override {
    engine_.for_each_domain(visit);
  }
  void validate() const override { engine_.validate(); }

 private:
  Wrapped engine_;
};

template <BroadPhase Phase>
std::unique_ptr<AnyDistributedEngine> make_distributed_of(DistributedStart start,
                                                          const PhaseSettings& settings) {
  using Distributed = DistributedEngine<CalendarQueue, Phase, ContactSums>;
  return std::make_unique<DistributedEngineModel<Distributed>>(
      Distributed(std::move(start.empty), std::move(start.brought), settings, start.division, start.now,
                  *start.processes));
}

}  // namespace hardball
