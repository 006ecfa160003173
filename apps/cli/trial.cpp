// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/trial.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "apps/cli/interruption.hpp"
#include "apps/cli/seconds_since.hpp"
#include "hardball/error.hpp"
#include "hardball/measures.hpp"
#include "hardball/scenario/rest_watch.hpp"
#include "hardball/scenario/settling_heap.hpp"

namespace hardball::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kTrialSeconds = 0.5;

// Of a gas that loses energy at all collisions and gets none: how many collisions each sphere has in `time`
// from now on, if it has `rate` of them in each unit now [1/T]. Source: Haff, J. Fluid Mech. 134 (1983) 401.
double collisions_while_cooling(double restitution, std::size_t dimensions, double rate, double time) {
  const double loss = (1 - restitution * restitution) / (2 * static_cast<double>(dimensions));
  return std::log1p(loss * rate * time) / loss;
}

// How many contacts there are until spheres that fall through the box are at rest in a heap, or until `end`.
// Measured with 20 to 2,000 spheres and restitutions of .1 to .95: docs/decisions/0043-heaps-settle.md.
double contacts_of_heap(const Scenario& scenario, const GasStatistics& statistics, double end) {
  const double gravity = length(scenario.gravity);
  const double diameter = 2 * statistics.mean_radius();
  const double height = std::fabs(dot(statistics.extent, scenario.gravity)) / gravity;
  const double fall = std::sqrt(2 * height / gravity);
  const double restitution = std::isnan(scenario.restitution()) ? 0.8 : scenario.restitution();
  const double rest = fall * (1.6 + 0.2 / std::max(1 - restitution, 0.01));
  const double time = std::clamp(end, fall, std::max(rest, fall)) - fall;
  constexpr double kDensityOfHeaps = 0.6;
  const double layers = statistics.packing_fraction() / kDensityOfHeaps * height / diameter;
  const double duration = kSettlingDuration * std::sqrt(diameter / gravity);
  return static_cast<double>(statistics.spheres) * 0.25 * std::sqrt(layers) * time / duration;
}

}  // namespace

Trial try_out(const Scenario& scenario, const Outlook& outlook) {
  Simulation simulation = outlook.simulation;
  Measures measures(scenario.measures);
  RestWatch rest(scenario, simulation.totals(), simulation.size());
  const Clock::time_point begin = Clock::now();
  const double until = *scenario.run.until;
  Trial trial;
  Trial half;
  const auto note = [&] {
    trial.time = simulation.time();
    trial.seconds = seconds_since(begin);
    trial.contacts = simulation.counters().contacts();
    if (trial.seconds < kTrialSeconds / 2) half = trial;
  };
  const auto stop = [&] {
    note();
    return trial.seconds >= kTrialSeconds || is_interrupted();
  };
  try {
    while (simulation.time() < until && !rest.since()) {
      const Time next(std::min(until, rest.next_look(simulation.time())));
      const bool is_stopped = simulation.run({.until = next, .stop = stop}, measures) == RunStatus::stopped;
      note();
      if (is_stopped) break;
      rest.look(simulation.time(), [&] { return simulation.totals(); });
    }
  } catch (const RunFailure& failure) {
    trial.failure = failure.what();
  }
  trial.is_whole = simulation.time() >= until || rest.since();
  const double time = trial.time - half.time;
  if (time > 0) {
    trial.late_seconds = (trial.seconds - half.seconds) / time;
    trial.late_contacts = static_cast<double>(trial.contacts - half.contacts) / time;
  }
  return trial;
}

double expected_seconds(const Scenario& scenario, const Outlook& outlook, const Trial& trial) {
  const double left = *scenario.run.until - trial.time;
  if (trial.is_whole || !trial.failure.empty() || !(trial.late_contacts > 0)) return trial.seconds;
  const double seconds_of_contact = trial.late_seconds / trial.late_contacts;
  const auto spheres = static_cast<double>(outlook.statistics.spheres);
  if (scenario.settles) {
    const double expected = contacts_of_heap(scenario, outlook.statistics, *scenario.run.until);
    const double more = std::max(expected - static_cast<double>(trial.contacts), 0.0);
    return trial.seconds + more * seconds_of_contact;
  }
  const bool cools = scenario.restitution() < 1 && scenario.gravity == Vec3{} && !are_kept_moving(scenario) &&
                     !scenario.shear.is_present();
  if (cools) {
    const double more = spheres / 2 *
                        collisions_while_cooling(scenario.restitution(), scenario.dimensions(),
                                                 2 * trial.late_contacts / spheres, left);
    return trial.seconds + more * seconds_of_contact;
  }
  // Where nothing holds them, spheres meet ever more rarely.
  const bool flies_apart = outlook.statistics.box.is_any(Boundary::open) &&
                           std::ranges::all_of(scenario.surfaces, &SurfaceDescription::is_obstacle) &&
                           scenario.gravity == Vec3{};
  return trial.seconds + (flies_apart ? std::min(left, trial.time) : left) * trial.late_seconds;
}

}  // namespace hardball::cli
