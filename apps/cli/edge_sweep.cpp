// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/edge_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "apps/cli/interruption.hpp"
#include "hardball/error.hpp"
#include "hardball/run/make_engine.hpp"
#include "hardball/theory.hpp"
#include "hardball/tuning/cell_edge.hpp"

namespace hardball::cli {
namespace {

constexpr int kEdgesBelow = 6;  // the one chosen
constexpr int kEdgesAbove = 5;

// Many short rounds, so that other load on the machine slows all points alike; but long enough that a round
// does not mainly reload the spheres into cache.
constexpr double kLeastSecondsOfRound = 0.03;
constexpr double kLeastSecondsForEachSphere = 1e-6;
// The share of the budget after which no edge is added, and measurements begin.
constexpr double kPrepared = 0.5;

// The simulation of a point being measured.
struct Contender {
  EdgePoint point;
  Simulation simulation;
  Counters before;
};

double run_timed(Simulation& simulation, double until) {
  const auto begin = std::chrono::steady_clock::now();
  simulation.run({.until = Time(until), .stop = [] { return is_interrupted(); }});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return seconds;
}

// Adds a contender with cells of this edge, unless one has the same cells, and returns its index.
std::optional<std::size_t> add(std::vector<Contender>& contenders, const Simulation& start,
                               EngineOptions options, double edge) {
  options.cell_edge = edge;
  std::optional<Simulation> simulation;
  try {
    simulation.emplace(start.world(), options);
  } catch (const Error&) {
    return std::nullopt;  // too small
  }
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    if (contenders[i].point.edge == simulation->cell_edge()) return i;
  }
  const GasStatistics statistics = gas_statistics(start.world(), start.now());
  EdgePoint point;
  point.edge = simulation->cell_edge();
  point.expected = expected_counts(statistics, edge);
  constexpr double kNanosecond = 1e-9;
  point.predicted_seconds =
      kNanosecond * static_cast<double>(statistics.spheres) * cost_rate(point.expected, options.unit_costs);
  contenders.push_back({std::move(point), std::move(*simulation), {}});
  return contenders.size() - 1;
}

}  // namespace

const EdgePoint& EdgeSweep::chosen() const {
  return *std::find_if(points.begin(), points.end(), [](const EdgePoint& point) { return point.is_chosen; });
}

const EdgePoint& EdgeSweep::paper() const {
  return *std::find_if(points.begin(), points.end(), [](const EdgePoint& point) { return point.is_paper; });
}

const EdgePoint& EdgeSweep::best() const {
  return *std::min_element(points.begin(), points.end(), [](const EdgePoint& a, const EdgePoint& b) {
    return a.median_seconds() < b.median_seconds();
  });
}

EdgeSweep sweep_cell_edges(const Simulation& start, const EngineOptions& options, Budget& budget) {
  const GasStatistics statistics = gas_statistics(start.world(), start.now());
  if (!(statistics.mean_speed > 0)) throw Error("nothing moves", "tune", "give the spheres velocities");
  std::vector<Contender> contenders;
  budget.show("preparing");
  const double chosen_edge =
      choose_length(start.world(), statistics, EngineKind::cells, options, start.now());
  const std::optional<std::size_t> added = add(contenders, start, options, chosen_edge);
  if (!added) {
    throw Error("no cells fit the spheres at time " + to_text(start.time()), "tune",
                "end the run earlier, with --until, or enlarge the spheres or shrink the box");
  }
  const std::size_t chosen = *added;
  contenders[chosen].point.is_chosen = true;
  const std::optional<std::size_t> paper =
      add(contenders, start, options, paper_cell_edge(statistics, options.unit_costs));
  contenders[paper.value_or(chosen)].point.is_paper = true;

  // Long enough for the number of rows left behind to become stationary.
  const CellCounts expected = contenders[chosen].point.expected;
  double until =
      contenders[chosen].simulation.time() + 3 / (expected.enter + expected.collision + expected.wall);
  std::size_t prepared = 0;
  const auto prepare = [&] {
    for (; prepared < contenders.size(); ++prepared) {
      budget.show("preparing");
      run_timed(contenders[prepared].simulation, until);
      contenders[prepared].before = contenders[prepared].simulation.counters();
    }
  };
  prepare();
  for (int k = 1; k <= std::max(kEdgesBelow, kEdgesAbove); ++k) {
    for (const int step : {k, -k}) {
      if (step > kEdgesAbove || budget.spent() > kPrepared) continue;
      add(contenders, start, options, chosen_edge * std::exp2(step / 3.0));
      prepare();
    }
  }
  const double seconds =
      std::max(kLeastSecondsOfRound, kLeastSecondsForEachSphere * static_cast<double>(start.size()));
  const double span = seconds / contenders[chosen].point.predicted_seconds;
  int rounds = 0;
  do {
    until += span;
    for (Contender& contender : contenders) {
      budget.show(fmt::format("round {} of measurements", rounds + 1));
      contender.point.seconds.push_back(run_timed(contender.simulation, until) / span);
    }
    ++rounds;
  } while (budget.spent() < 1);
  EdgeSweep sweep;
  sweep.span = rounds * span;
  for (Contender& contender : contenders) {
    contender.point.counted = contender.simulation.counters() - contender.before;
    std::sort(contender.point.seconds.begin(), contender.point.seconds.end());
    sweep.points.push_back(std::move(contender.point));
  }
  std::sort(sweep.points.begin(), sweep.points.end(),
            [](const EdgePoint& a, const EdgePoint& b) { return a.edge < b.edge; });
  return sweep;
}

}  // namespace hardball::cli
