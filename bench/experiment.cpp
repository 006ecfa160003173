// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "bench/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "bench/discrete_checks.hpp"
#include "bench/time_stepped.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/scenario/make_world.hpp"
#include "hardball/simulation/simulation.hpp"

namespace hardball::bench {
namespace {

template <class Work>
double seconds_of(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

// The next smaller number of the form digit * 10^k.
double rounded_down(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  return std::max(1.0, std::floor(value / power)) * power;
}

std::vector<double> step_durations() {
  std::vector<double> durations(kSteps.size());
  std::transform(kSteps.begin(), kSteps.end(), durations.begin(),
                 [](const StepSize& step) { return step.duration(); });
  return durations;
}

void run_collisions(Simulation& simulation, double per_sphere) {
  const double until = static_cast<double>(simulation.tally().collisions()) +
                       per_sphere * static_cast<double>(simulation.size()) / 2;
  while (static_cast<double>(simulation.tally().collisions()) < until) {
    simulation.run_contacts(simulation.size() / 10 + 1);
  }
}

// The paper's spheres in equilibrium. What steps would miss is counted during the second half of
// equilibration.
World settled_world(std::size_t spheres, double box_edge, MissedCounter& missed) {
  const bool is_random = spheres <= kMaxPlacedAtRandom || box_edge > kBoxEdge;
  Scenario scenario;
  scenario.box.fill({Boundary::wall, box_edge});
  SphereGroup group;
  group.count = spheres;
  group.radius = kRadius;
  group.placement = is_random ? Placement::random : Placement::fcc;
  group.velocity_rule = VelocityRule::temperature;
  group.velocity_scale = kSpread * kSpread;
  group.where = "figure1";
  scenario.spheres.push_back(group);
  Simulation simulation(make_world(scenario));
  const int collisions = is_random ? kCollisionsToSettle : kCollisionsToMelt;
  run_collisions(simulation, collisions / 2.0);
  simulation.on_contact([&](const Contact& contact) { missed.record(contact); });
  run_collisions(simulation, collisions / 2.0);
  return simulation.world();
}

// The simulated time [T] that a simulation covers in the given seconds. It takes a copy: the original is
// unchanged.
double span_of(Simulation simulation, double seconds) {
  const double start = simulation.time();
  double elapsed = 0;
  for (std::uint64_t contacts = 16; elapsed < seconds / 5; contacts *= 2) {
    elapsed += seconds_of([&] { simulation.run_contacts(contacts); });
  }
  return rounded_down((simulation.time() - start) * seconds / elapsed);
}

// An engine, run in windows of equal simulated time.
class EventDriven {
 public:
  EventDriven(Simulation simulation, double span) : simulation_(std::move(simulation)), span_(span) {
    // Untimed, so that memory is as disordered as in a long run.
    begin_ = simulation_.time() + span_ / 4;
    simulation_.run_until(begin_);
    counters_ = simulation_.counters();
  }

  void run_window() {
    seconds_.push_back(seconds_of([&] { simulation_.run_until(begin_ + span_ * (windows() + 1)); }));
  }

  std::uint64_t event_log_hash() const { return simulation_.event_log_hash(); }

  Row row(const std::string& method) const {
    Row row{.method = method, .spheres = simulation_.size(), .box_edge = simulation_.world().box().size().x};
    row.seconds = median(seconds_) / span_;
    row.seconds_minimum = *std::min_element(seconds_.begin(), seconds_.end()) / span_;
    row.seconds_maximum = *std::max_element(seconds_.begin(), seconds_.end()) / span_;
    row.repetitions = static_cast<int>(seconds_.size());
    row.span = span_;
    const Counters counters = simulation_.counters();
    const auto rate = [&](std::uint64_t Counters::*kind) {
      return static_cast<double>(counters.*kind - counters_.*kind) / (span_ * windows());
    };
    row.collisions = rate(&Counters::collision);
    row.walls = rate(&Counters::wall);
    row.enters = rate(&Counters::enter);
    row.leaves = rate(&Counters::leave);
    return row;
  }

 private:
  double windows() const { return static_cast<double>(seconds_.size()); }

  Simulation simulation_;
  double span_;
  double begin_ = 0;
  Counters counters_;
  std::vector<double> seconds_;
};

// The cost of a step does not depend on its length: it is measured with the shortest and scaled.
class Stepping {
 public:
  Stepping(const World& world, const Time& now, double seconds)
      : simulation_(world, now), spheres_(world.size()) {
    const double elapsed = seconds_of([&] { simulation_.step(kShortest.duration()); });
    steps_ = static_cast<int>(std::ceil(seconds / elapsed));
  }

  void run_window() {
    seconds_.push_back(seconds_of([&] {
                         for (int i = 0; i < steps_; ++i) simulation_.step(kShortest.duration());
                       }) /
                       steps_);
  }

  Row row(const StepSize& step, double missed_share) const {
    Row row{.method = "time_stepped", .spheres = spheres_};
    row.step_radii = step.radii;
    row.step = step.duration();
    row.seconds = median(seconds_) / row.step;
    row.seconds_minimum = *std::min_element(seconds_.begin(), seconds_.end()) / row.step;
    row.seconds_maximum = *std::max_element(seconds_.begin(), seconds_.end()) / row.step;
    row.repetitions = static_cast<int>(seconds_.size());
    row.span = steps_ * row.step;
    row.missed_share = missed_share;
    return row;
  }

 private:
  static constexpr StepSize kShortest = kSteps[kStepsTaken.back()];

  TimeStepped simulation_;
  std::size_t spheres_;
  int steps_ = 1;
  std::vector<double> seconds_;
};

// The rows for one number of spheres; the engines take turns.
std::vector<Row> rows_of(const Plan& plan, const World& world, const MissedCounter& missed) {
  const Simulation start(world, {.engine = EngineKind::cells});
  const double span = span_of(start, plan.seconds);
  EventDriven cells(start, span);
  EventDriven paper(Simulation(world, {.engine = EngineKind::paper}), span);
  std::optional<EventDriven> all_pairs;
  if (world.size() <= plan.most_all_pairs) {
    const Simulation simulation(world, {.engine = EngineKind::all_pairs});
    all_pairs.emplace(simulation, std::min(span, span_of(simulation, plan.slow_seconds)));
  }
  std::optional<Stepping> stepping;
  if (world.size() <= plan.most_stepped) stepping.emplace(world, start.now(), plan.slow_seconds);

  for (int i = 0; i < plan.repetitions; ++i) {
    cells.run_window();
    paper.run_window();
    if (all_pairs) all_pairs->run_window();
    if (stepping) stepping->run_window();
  }
  if (cells.event_log_hash() != paper.event_log_hash()) {
    throw RunFailure(fmt::format("cells and paper disagree for {} spheres", world.size()));
  }

  std::vector<Row> rows = {cells.row("cells"), paper.row("paper")};
  if (all_pairs) rows.push_back(all_pairs->row("all_pairs"));
  if (stepping) {
    for (const std::size_t i : kStepsTaken) rows.push_back(stepping->row(kSteps[i], missed.share(i)));
  }
  for (Row& row : rows) {
    if (row.packing_fraction() > kFreezing) row.on_contact = "above freezing, from a crystal";
  }
  return rows;
}

// Runs the exact and the time-stepped simulation from the same state, and counts the collisions of both.
void run_trial(const World& world, double span, std::vector<StepRow>& steps) {
  Simulation exact(world);
  const Time start = exact.now();
  exact.run_until(start.value() + span);
  for (const std::size_t i : kStepsTaken) {
    StepRow& row = steps[i];
    const auto count = static_cast<std::uint64_t>(std::llround(span / row.step.duration()));
    TimeStepped stepped(world, start);
    std::uint64_t resolved = 0;
    for (std::uint64_t k = 0; k < count; ++k) resolved += stepped.step(row.step.duration());
    row.spheres = world.size();
    row.span = span;
    row.exact = static_cast<double>(exact.tally().collisions());
    row.resolved = static_cast<double>(resolved);
  }
}

}  // namespace

double StepSize::duration() const {
  const double mean_speed = kSpread * std::sqrt(8 / std::numbers::pi);
  return radii * kRadius / mean_speed;
}

double Row::packing_fraction() const {
  const double volume = 4 * std::numbers::pi / 3 * kRadius * kRadius * kRadius;
  return static_cast<double>(spheres) * volume / (box_edge * box_edge * box_edge);
}

Plan full_plan() {
  return {.spheres = {1'000, 2'000, 5'000, 10'000, 20'000, 50'000, 100'000, 200'000, 300'000},
          .spheres_at_fixed_density = {1'000, 3'000, 10'000, 30'000, 100'000, 300'000},
          .most_all_pairs = 50'000,
          .most_stepped = 100'000,
          .trial_spheres = 5'000,
          .trial_span = 8};
}

Plan quick_plan() {
  return {.spheres = {1'000, 2'000, 5'000},
          .spheres_at_fixed_density = {1'000, 3'000},
          .repetitions = 1,
          .seconds = 0.2,
          .slow_seconds = 0.2,
          .most_all_pairs = 5'000,
          .most_stepped = 5'000,
          .trial_spheres = 2'000,
          .trial_span = 1};
}

Results measure(const Plan& plan) {
  Results results;
  MissedCounter all_missed(step_durations());
  for (const StepSize& step : kSteps) results.steps.push_back({.step = step});
  for (const std::size_t spheres : plan.spheres) {
    const double seconds = seconds_of([&] {
      MissedCounter missed(step_durations());
      const World world = settled_world(spheres, kBoxEdge, missed);
      const std::vector<Row> rows = rows_of(plan, world, missed);
      results.rows.insert(results.rows.end(), rows.begin(), rows.end());
      if (rows.front().packing_fraction() < kFreezing) all_missed.add(missed);
      if (spheres == plan.trial_spheres) run_trial(world, plan.trial_span, results.steps);
    });
    fmt::print(stderr, "figure1: {} spheres, {:.1f} s\n", spheres, seconds);
  }
  Plan events_only = plan;
  events_only.most_all_pairs = events_only.most_stepped = 0;
  for (const std::size_t spheres : plan.spheres_at_fixed_density) {
    const double seconds = seconds_of([&] {
      const double growth = static_cast<double>(spheres) / static_cast<double>(kSpheresAtFixedDensity);
      MissedCounter missed(step_durations());
      const World world = settled_world(spheres, kBoxEdge * std::cbrt(growth), missed);
      const std::vector<Row> rows = rows_of(events_only, world, missed);
      results.rows_at_fixed_density.insert(results.rows_at_fixed_density.end(), rows.begin(), rows.end());
    });
    fmt::print(stderr, "figure1: {} spheres at fixed density, {:.1f} s\n", spheres, seconds);
  }
  for (std::size_t i = 0; i < kSteps.size(); ++i) {
    StepRow& row = results.steps[i];
    row.contacts = all_missed.collisions();
    row.missed = all_missed.missed()[i];
    // The most probable relative speed is twice the spread of a component.
    row.expected_share = expected_missed_share(2 * kSpread * row.step.duration() / (2 * kRadius));
  }
  return results;
}

}  // namespace hardball::bench
