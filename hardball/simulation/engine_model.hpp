// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hardball/engine/engine.hpp"
#include "hardball/events/calendar_queue.hpp"
#include "hardball/events/ordered_queue.hpp"
#include "hardball/parallel/parallel_engine.hpp"
#include "hardball/simulation/any_engine.hpp"
#include "hardball/simulation/engine_makers.hpp"

namespace hardball {

/// Gives any engine the common interface. The preferred ones take its place in worlds that they support.
template <class Wrapped, class... Preferred>
class EngineModel final : public AnyEngine {
 public:
  EngineModel(Wrapped engine, const PhaseSettings& settings)
      : engine_(std::move(engine)), settings_(settings) {}

  std::unique_ptr<AnyEngine> clone() const override { return std::make_unique<EngineModel>(*this); }
  const World& world() const override { return engine_.world(); }
  World& world_to_edit() override { return engine_.world_to_edit(); }
  std::size_t size() const override { return whole().size(); }
  const Interactions& interactions() const override { return whole().interactions(); }
  Time now() const override { return engine_.now(); }
  Counters counters() const override { return engine_.counters(); }
  std::size_t memory_bytes() const override { return engine_.memory_bytes(); }
  PhaseLengths lengths() const override { return engine_.lengths(); }
  std::vector<Block> blocks() const override {
    if constexpr (requires { engine_.partition(); }) {
      const std::span<const Block> blocks = engine_.partition().blocks();
      return {blocks.begin(), blocks.end()};
    } else {
      return {Block(world().box())};
    }
  }
  GasStatistics statistics(const Time& moment) const override {
    if constexpr (requires { engine_.template sum_over_spheres<GasSums>(moment); }) {
      if (fills_box(whole()))
        return gas_statistics(engine_.template sum_over_spheres<GasSums>(moment), whole());
    }
    return gas_statistics(world(), moment);
  }
  WindowCounters windows() const override {
    if constexpr (requires { engine_.window_counters(); }) {
      return engine_.window_counters();
    } else {
      return {};
    }
  }
  void for_each(std::size_t count, const Function<void(std::size_t)>& work) override {
    if constexpr (requires { engine_.for_each(count, work); }) {
      engine_.for_each(count, work);
    } else {
      one_by_one(count, work);
    }
  }
  RunStatus run(const RunLimits& limits, ContactSums& sums, const ContactObserver& observer) override {
    if constexpr (requires { engine_.run(limits, sums, observer); }) {
      return engine_.run(limits, sums, observer);
    } else {
      return engine_.run(limits, [&](const Contact& contact) {
        sums.note(contact);
        return !observer || observer.note(contact);
      });
    }
  }
  std::optional<Event> next_contact(const Time& until) override { return engine_.next_contact(until); }
  void change_velocities(const Time& moment, std::span<const NewVelocity> changes) override {
    engine_.change_velocities(moment, changes);
  }
  SphereId add(const Sphere& sphere, const Time& moment) override { return engine_.add(sphere, moment); }
  void remove(SphereId id, const Time& moment) override { engine_.remove(id, moment); }
  bool is_outdated() const override { return engine_.is_outdated(); }
  void begin_journal(const Time& moment) override { engine_.begin_journal(moment); }
  void end_journal() override { engine_.end_journal(); }
  void rewind(const Time& moment) override { engine_.rewind(moment); }
  void rewind_to_begin() override { engine_.rewind_to_begin(); }
  bool supports(double length) const override {
    return !(Preferred::supports(world(), length) || ...) && Wrapped::supports(world(), length);
  }
  void rebuild(const Time& now, double length) override {
    settings_.length = length;
    engine_.rebuild(now, settings_);
  }
  Aftermath aftermath() const override { return engine_.aftermath(); }
  void take_over(const Aftermath& aftermath) override { engine_.take_over(aftermath); }
  void validate() const override { engine_.validate(); }

 private:
  // The world, whose spheres need not be up to date.
  const World& whole() const {
    if constexpr (requires { engine_.world_as_gathered(); }) {
      return engine_.world_as_gathered();
    } else {
      return engine_.world();
    }
  }

  Wrapped engine_;
  PhaseSettings settings_;
};

template <EventQueue Queue, BroadPhase Phase, BroadPhase... Preferred>
std::unique_ptr<AnyEngine> make_queued(World world, const PhaseSettings& settings, const Time& now,
                                       const Progress& progress) {
  return std::make_unique<EngineModel<Engine<Queue, Phase>, Preferred...>>(
      Engine<Queue, Phase>(std::move(world), Phase(settings), now, settings.instructions, progress),
      settings);
}

/// An engine with candidates from a broad phase.
template <BroadPhase Phase, BroadPhase... Preferred>
std::unique_ptr<AnyEngine> make(World world, const EngineOptions& options, const PhaseSettings& settings,
                                const Time& now, const Progress& progress) {
  const auto make_it = options.queue == QueueKind::ordered ? make_queued<OrderedQueue, Phase, Preferred...>
                                                           : make_queued<CalendarQueue, Phase, Preferred...>;
  return make_it(std::move(world), settings, now, progress);
}

/// The same, in several domains where these pay.
template <BroadPhase Phase, BroadPhase... Preferred>
std::unique_ptr<AnyEngine> make_divided(World world, const EngineOptions& options,
                                        const PhaseSettings& settings, const Time& now,
                                        const Progress& progress) {
  const Division division = choose_division(world, options);
  if (division.domains == 1)
    return make<Phase, Preferred...>(std::move(world), options, settings, now, progress);
  using Divided = ParallelEngine<CalendarQueue, Phase, ContactSums>;
  return std::make_unique<EngineModel<Divided, Preferred...>>(
      Divided(std::move(world), settings, division, now), settings);
}

}  // namespace hardball
