// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/polish/polish.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <vector>

#include <coin/ClpSimplex.hpp>
#include <coin/ClpSolve.hpp>
#include <coin/CoinPackedMatrix.hpp>

#include "hardball/errors/error.hpp"

namespace hardball::polish {
namespace {

// What a program says: how spheres move, and what each pair bears.
struct Step {
  std::vector<Vec3> moves;      // [L]
  std::vector<NearPair> pairs;  // that might touch after it
  std::vector<double> forces;   // of the pairs
  double growth = 0;            // of all sizes, by the linear program [1]
};

Vec3 direction_of(const NearPair& pair) {
  return (1 / length(pair.separation)) * pair.separation;
}

// Maximizes the growth of all sizes while no sphere moves by more than `trust` along any axis. Lengths are in
// units of `trust`, so that numbers stay near one however small it is. A distance that is linearized is
// smaller than the distance, so that no two spheres overlap after it; at walls that are curved they may, a
// little, which the next program mends.
Step solve(const PackedSpheres& spheres, double trust) {
  const auto dimensions = static_cast<int>(spheres.container.dimensions);
  const int count = static_cast<int>(spheres.size());
  Step step;
  const double smallest = *std::ranges::min_element(spheres.radii);
  constexpr double kWider = 4;
  spheres.for_each_near(kWider * trust / smallest, [&](const NearPair& pair) {
    if (pair.gap <= kWider * trust) step.pairs.push_back(pair);
  });
  const int growth = count * dimensions;  // its column
  std::vector<int> rows;
  std::vector<int> columns;
  std::vector<double> elements;
  std::vector<double> least;
  for (const NearPair& pair : step.pairs) {
    const int row = static_cast<int>(least.size());
    const Vec3 direction = direction_of(pair);
    for (int axis = 0; axis < dimensions; ++axis) {
      const double along = direction[static_cast<std::size_t>(axis)];
      const auto add = [&](std::uint32_t sphere, double element) {
        rows.push_back(row);
        columns.push_back(static_cast<int>(sphere) * dimensions + axis);
        elements.push_back(element);
      };
      // A sphere and its own image keep their distance.
      if (!pair.bodies.is_wall && pair.bodies.first == pair.bodies.second) continue;
      add(pair.bodies.first, -along);
      if (!pair.bodies.is_wall) add(pair.bodies.second, along);
    }
    rows.push_back(row);
    columns.push_back(growth);
    elements.push_back(-pair.reach / smallest);
    least.push_back(-pair.gap / trust);
  }
  const int unknowns = growth + 1;
  CoinPackedMatrix matrix(false, rows.data(), columns.data(), elements.data(),
                          static_cast<CoinBigIndex>(elements.size()));
  std::vector<double> lower(static_cast<std::size_t>(unknowns), -1);
  std::vector<double> upper(static_cast<std::size_t>(unknowns), 1);
  std::vector<double> objective(static_cast<std::size_t>(unknowns), 0);
  objective.back() = 1;
  ClpSimplex model;
  model.setLogLevel(0);
  std::vector<double> most(least.size(), COIN_DBL_MAX);
  // A last row or column without elements counts, too.
  matrix.setDimensions(static_cast<int>(least.size()), unknowns);
  model.loadProblem(matrix, lower.data(), upper.data(), objective.data(), least.data(), most.data());
  model.setOptimizationDirection(-1);
  model.setPrimalTolerance(1e-9);
  model.setDualTolerance(1e-9);
  // Its choice among primal methods, behind a presolve: 12 to 35 times as fast here as the dual method alone.
  ClpSolve method;
  method.setSolveType(ClpSolve::usePrimalorSprint);
  model.initialSolve(method);
  if (!model.isProvenOptimal()) throw RunFailure("the linear program for the last gaps has no solution");
  const double* solution = model.primalColumnSolution();
  step.moves.resize(spheres.size());
  for (int sphere = 0; sphere < count; ++sphere) {
    for (int axis = 0; axis < dimensions; ++axis) {
      step.moves[static_cast<std::size_t>(sphere)][static_cast<std::size_t>(axis)] =
          trust * solution[sphere * dimensions + axis];
    }
  }
  step.growth = trust / smallest * solution[growth];
  const double* duals = model.dualRowSolution();
  double strongest = 0;
  for (std::size_t row = 0; row < least.size(); ++row) strongest = std::max(strongest, std::fabs(duals[row]));
  constexpr double kRounding = 1e-9;
  for (std::size_t row = 0; row < least.size(); ++row) {
    const double force = std::fabs(duals[row]);
    step.forces.push_back(force > kRounding * strongest ? force : 0);
  }
  return step;
}

// Carries out a step, and makes spheres as large as they then can be.
void apply(const Step& step, PackedSpheres& spheres) {
  const Box box = spheres.container.box();
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    spheres.positions[i] += step.moves[i];
    box.fold(spheres.positions[i]);
  }
  const auto multiply = [&spheres](double factor) {
    for (double& radius : spheres.radii) radius *= factor;
  };
  multiply(1 + step.growth);
  double room = std::numeric_limits<double>::infinity();
  constexpr double kNear = 1e-3;
  spheres.for_each_near(kNear, [&](const NearPair& pair) { room = std::min(room, pair.gap / pair.reach); });
  if (std::isfinite(room)) multiply(1 + room);
}

// The longest way of a sphere that bears force [L].
double longest_move(const Step& step) {
  double longest = 0;
  for (std::size_t k = 0; k < step.pairs.size(); ++k) {
    if (!(step.forces[k] > 0)) continue;
    const NearPair& pair = step.pairs[k];
    longest = std::max(longest, length(step.moves[pair.bodies.first]));
    if (!pair.bodies.is_wall) longest = std::max(longest, length(step.moves[pair.bodies.second]));
  }
  return longest;
}

// The widest gap between bodies that bear force, over their reach [1].
double widest_gap(const Step& step, const PackedSpheres& spheres) {
  std::unordered_map<ContactKey, double> bearing;
  for (std::size_t k = 0; k < step.pairs.size(); ++k)
    if (step.forces[k] > 0) bearing[step.pairs[k].bodies] = step.forces[k];
  double widest = 0;
  constexpr double kNear = 1e-3;
  std::size_t found = 0;
  spheres.for_each_near(kNear, [&](const NearPair& pair) {
    if (!bearing.contains(pair.bodies)) return;
    ++found;
    widest = std::max(widest, pair.gap / pair.reach);
  });
  return found == bearing.size() ? widest : std::numeric_limits<double>::infinity();
}

}  // namespace

void polish(Packing& packing, const Function<void(int)>& on_round) {
  if (!(packing.network.tolerance > 0) || packing.network.backbone_contacts == 0) {
    throw Error("only spheres that have jammed can be polished", "polish",
                "pack to the density max, or to a high pressure");
  }
  PackedSpheres& spheres = packing.spheres;
  constexpr double kFirst = 3e-3;
  constexpr double kTouching = 1e-12;
  constexpr int kMostRounds = 60;
  const double diameter = spheres.mean_diameter();
  double trust = kFirst * diameter;
  for (int round = 0; round < kMostRounds; ++round) {
    if (on_round) on_round(round);
    const Step step = solve(spheres, trust);
    apply(step, spheres);
    const double moved = longest_move(step);
    const double gap = widest_gap(step, spheres);
    std::unordered_map<ContactKey, double> forces;
    for (std::size_t k = 0; k < step.pairs.size(); ++k) {
      if (step.forces[k] > 0) forces[step.pairs[k].bodies] = step.forces[k];
    }
    packing.network = contact_network(spheres, kTouching, forces);
    packing.is_polished = gap <= kTouching;
    if (packing.is_polished) break;
    constexpr double kLess = 1e-3;
    constexpr double kRoom = 4;
    constexpr double kFinest = 1e-12;
    trust = std::max(kFinest * diameter, std::clamp(kRoom * moved, kLess * trust, trust));
  }
}

}  // namespace hardball::polish
