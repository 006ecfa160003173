// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/polish/polish.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>
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
  std::vector<NearPair> pairs;  // that might touch after it, once for each row
  std::vector<double> forces;   // of the rows
  double growth = 0;            // of all sizes, by the linear program [1]
};

Vec3 direction_of(const NearPair& pair) {
  return (1 / length(pair.separation)) * pair.separation;
}

// A bound of the gap between two bodies after a step: what is left of it, and less by as much as the first
// moves along `towards` and the second against it.
struct Bound {
  NearPair pair;
  double gap = 0;
  Vec3 towards;
};

// The solution of a linear program: how all spheres move, how they grow, and what each row bears. Lengths are
// in units of `trust`.
struct Solution {
  std::vector<double> unknowns;
  std::vector<double> duals;
};

// Maximizes the growth of all sizes within these bounds while no sphere moves by more than `trust` along any
// axis. In units of it numbers stay near one however small it is. Nothing if no solution is found.
std::optional<Solution> maximize_growth(const std::vector<Bound>& bounds, std::size_t spheres, int dimensions,
                                        double trust, double smallest) {
  const int growth = static_cast<int>(spheres) * dimensions;  // its column
  std::vector<int> rows;
  std::vector<int> columns;
  std::vector<double> elements;
  std::vector<double> least;
  for (const Bound& bound : bounds) {
    const int row = static_cast<int>(least.size());
    const ContactKey& bodies = bound.pair.bodies;
    const auto add = [&](int column, double element) {
      rows.push_back(row);
      columns.push_back(column);
      elements.push_back(element);
    };
    // A sphere and its own image keep their distance.
    const bool is_fixed = !bodies.is_wall && bodies.first == bodies.second;
    for (int axis = 0; axis < dimensions && !is_fixed; ++axis) {
      const double towards = bound.towards[static_cast<std::size_t>(axis)];
      add(static_cast<int>(bodies.first) * dimensions + axis, -towards);
      if (!bodies.is_wall) add(static_cast<int>(bodies.second) * dimensions + axis, towards);
    }
    add(growth, -bound.pair.reach / smallest);
    least.push_back(-bound.gap / trust);
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
  if (!model.isProvenOptimal()) return {};
  const double* solution = model.primalColumnSolution();
  const double* duals = model.dualRowSolution();
  return Solution{{solution, solution + unknowns}, {duals, duals + least.size()}};
}

// Of spheres that a step would take out of a curved container, bounds by the plane that touches its wall
// where they would be. Within the wall all such planes hold, and few suffice.
std::vector<Bound> bounds_of_walls_left(const PackedSpheres& spheres, const Step& step) {
  std::vector<Bound> bounds;
  const std::vector<Surface> surfaces = spheres.container.surfaces();
  if (surfaces.empty()) return bounds;
  constexpr double kOfGrowth = 1e-3;
  constexpr double kRounding = 1e-15;
  const double tolerated = std::max(kRounding, kOfGrowth * step.growth);
  const ContactKey* last = nullptr;
  for (const NearPair& pair : step.pairs) {
    // What is within a shell or an annulus is convex as spheres are.
    const bool may_be_left = pair.bodies.is_wall && (spheres.container.mesh ? pair.bodies.second >= kFaces
                                                                            : pair.bodies.second == kFaces);
    if (!may_be_left || (last && last->first == pair.bodies.first)) continue;
    last = &pair.bodies;
    const Vec3& position = spheres.positions[pair.bodies.first];
    const Vec3 moved = position + step.moves[pair.bodies.first];
    const double distance = surfaces.front().distance(moved, Time(0));
    if (distance - (1 + step.growth) * pair.reach >= -tolerated * pair.reach) continue;
    const Vec3 towards = surfaces.front().direction(moved, Time(0));
    bounds.push_back({pair, distance + dot(towards, moved - position) - pair.reach, towards});
  }
  return bounds;
}

// The step in which all sizes grow most while no sphere moves by more than `trust` along any axis. A distance
// that is linearized is smaller than the distance, so that no two spheres overlap after it. Nothing if no
// such step is found.
std::optional<Step> solve(const PackedSpheres& spheres, double trust) {
  const std::size_t dimensions = spheres.container.dimensions;
  const double smallest = *std::ranges::min_element(spheres.radii);
  std::vector<Bound> bounds;
  constexpr double kWider = 4;
  spheres.for_each_near(kWider * trust / smallest, [&](const NearPair& pair) {
    if (pair.gap <= kWider * trust) bounds.push_back({pair, pair.gap, direction_of(pair)});
  });
  Step step;
  constexpr int kMostCuts = 12;
  for (int cuts = 0;; ++cuts) {
    const std::optional<Solution> solution =
        maximize_growth(bounds, spheres.size(), static_cast<int>(dimensions), trust, smallest);
    if (!solution) return {};
    step = {};
    step.moves.resize(spheres.size());
    for (std::size_t sphere = 0; sphere < spheres.size(); ++sphere)
      for (std::size_t axis = 0; axis < dimensions; ++axis)
        step.moves[sphere][axis] = trust * solution->unknowns[sphere * dimensions + axis];
    step.growth = trust / smallest * solution->unknowns.back();
    double strongest = 0;
    for (const double dual : solution->duals) strongest = std::max(strongest, std::fabs(dual));
    constexpr double kRounding = 1e-9;
    for (std::size_t row = 0; row < bounds.size(); ++row) {
      const double force = std::fabs(solution->duals[row]);
      step.pairs.push_back(bounds[row].pair);
      step.forces.push_back(force > kRounding * strongest ? force : 0);
    }
    const std::vector<Bound> left = bounds_of_walls_left(spheres, step);
    if (left.empty() || cuts == kMostCuts) return step;
    bounds.insert(bounds.end(), left.begin(), left.end());
  }
}

// Whether each sphere bears force.
std::vector<bool> bearing_spheres(const Step& step) {
  std::vector<bool> bears(step.moves.size());
  for (std::size_t k = 0; k < step.pairs.size(); ++k) {
    if (!(step.forces[k] > 0)) continue;
    const ContactKey& bodies = step.pairs[k].bodies;
    bears[bodies.first] = true;
    if (!bodies.is_wall) bears[bodies.second] = true;
  }
  return bears;
}

// Takes the motions that the container leaves free to all spheres that bear force together out of the moves:
// they change no gap, and may be as long as the program allows.
void stop_free_motions(const PackedSpheres& spheres, Step& step) {
  const Container& container = spheres.container;
  if (container.free_motions() == 0) return;
  const std::vector<bool> bears = bearing_spheres(step);
  std::vector<Vec3>& moves = step.moves;
  if (container.shape == Container::Shape::box) {
    Vec3 mean;
    const double share = 1 / std::max(1.0, static_cast<double>(std::ranges::count(bears, true)));
    for (std::size_t i = 0; i < moves.size(); ++i)
      if (bears[i]) mean += share * moves[i];
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      if (!container.is_periodic(axis)) mean[axis] = 0;
    for (Vec3& move : moves) move = move - mean;
    return;
  }
  // Turns about one axis after the other: only about that of a cylinder or a cone, and of a circle.
  const std::size_t first = container.free_motions() == 1 ? 2 : 0;
  for (std::size_t axis = first; axis < kAxes; ++axis) {
    const std::size_t next = (axis + 1) % kAxes;
    const std::size_t last = (axis + 2) % kAxes;
    double turned = 0;
    double inertia = 0;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      if (!bears[i]) continue;
      const Vec3 from = spheres.positions[i] - 0.5 * container.size;
      turned += from[next] * moves[i][last] - from[last] * moves[i][next];
      inertia += from[next] * from[next] + from[last] * from[last];
    }
    if (!(inertia > 0)) continue;
    const double sine = std::sin(turned / inertia);
    const double versine = 1 - std::cos(turned / inertia);
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const Vec3 from = spheres.positions[i] - 0.5 * container.size + moves[i];
      moves[i][next] += sine * from[last] - versine * from[next];
      moves[i][last] -= sine * from[next] + versine * from[last];
    }
  }
}

// Carries out a step, and makes spheres as large as they then can be; returns by which factor they are
// larger.
double apply(const Step& step, PackedSpheres& spheres) {
  const Box box = spheres.container.box();
  const double before = spheres.radii.front();
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
  return spheres.radii.front() / before;
}

// The longest way of a sphere that bears force [L].
double longest_move(const Step& step) {
  const std::vector<bool> bears = bearing_spheres(step);
  double longest = 0;
  for (std::size_t i = 0; i < bears.size(); ++i)
    if (bears[i]) longest = std::max(longest, length(step.moves[i]));
  return longest;
}

// Forces by contact; only those that are there.
std::unordered_map<ContactKey, double> forces_of(const Step& step) {
  std::unordered_map<ContactKey, double> forces;
  for (std::size_t k = 0; k < step.pairs.size(); ++k)
    if (step.forces[k] > 0) forces[step.pairs[k].bodies] += step.forces[k];
  return forces;
}

// Whether all bodies that bear force on each other touch.
bool touch(const std::unordered_map<ContactKey, double>& forces, const PackedSpheres& spheres,
           double tolerance) {
  std::size_t touching = 0;
  spheres.for_each_near(tolerance, [&](const NearPair& pair) { touching += forces.count(pair.bodies); });
  return !forces.empty() && touching == forces.size();
}

}  // namespace

void polish(Packing& packing, const Function<void(int)>& on_round) {
  if (!(packing.network.tolerance > 0)) {
    throw Error("only spheres that have jammed can be polished", "polish",
                "pack to the density max, or to a high pressure");
  }
  constexpr double kFirst = 3e-3;
  constexpr double kTouching = 1e-12;
  // Some is left for the rounding of what is written.
  constexpr double kTighter = 0.9;
  constexpr int kMostRounds = 100;
  PackedSpheres spheres = packing.spheres;
  const double diameter = spheres.mean_diameter();
  constexpr double kFinest = 1e-13;
  double trust = kFirst * diameter;
  for (int round = 0; round < kMostRounds && trust > kFinest * diameter; ++round) {
    if (on_round) on_round(round);
    std::optional<Step> step = solve(spheres, trust);
    PackedSpheres larger = spheres;
    constexpr double kRounding = 1e-15;
    if (step) stop_free_motions(spheres, *step);
    if (!step || apply(*step, larger) < 1 - kRounding) {
      constexpr double kShorter = 0.125;
      trust *= kShorter;
      continue;
    }
    spheres = std::move(larger);
    const std::unordered_map<ContactKey, double> forces = forces_of(*step);
    // Where moves are as long as they may be, spheres are held by that alone.
    const double moved = longest_move(*step);
    if (moved < trust && touch(forces, spheres, kTighter * kTouching)) {
      ContactNetwork network = contact_network(spheres, kTouching, forces);
      if (network.backbone_contacts == 0) break;  // a chain that is held by its ends, and would buckle
      packing.network = std::move(network);
      packing.spheres = std::move(spheres);
      packing.is_polished = true;
      return;
    }
    constexpr double kLess = 1e-3;
    constexpr double kRoom = 4;
    trust = std::min(kFirst * diameter, std::clamp(kRoom * moved, kLess * trust, kRoom * trust));
  }
  packing.warnings.emplace_back(
      "the linear programs did not end with spheres that touch: the packing is as it was before them");
}

}  // namespace hardball::polish
