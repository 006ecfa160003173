// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/coordination.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace hardball {
namespace {

// Equal spheres have at most 12 or 13; a large one among small ones may have more, which count as so many.
constexpr std::size_t kMostNeighbors = 100;

}  // namespace

Coordination::Coordination(const Scene& scene, double reach) : reach_(reach), fractions_(kMostNeighbors + 1) {
  const World& world = scene.world();
  if (world.size() == 0) return;
  sample_cost_ = Surroundings::effort(world, 2 * reach_ * world.largest_radius()).cost;
}

void Coordination::sample(const Scene& scene) {
  if (scene.world().size() == 0) return;
  const Surroundings& surroundings = scene.surroundings();
  const double range = 2 * reach_ * scene.world().largest_radius();
  std::vector<double> spheres(kMostNeighbors + 1);
  double centers = 0;
  double sum = 0;
  surroundings.for_each_center(range, [&](std::size_t center) {
    std::size_t neighbors = 0;
    surroundings.for_each_neighbor(center, range, [&](std::size_t neighbor, const Vec3&, double square) {
      const double farthest = reach_ * (surroundings.radius(center) + surroundings.radius(neighbor));
      if (square <= farthest * farthest) ++neighbors;
    });
    ++centers;
    sum += static_cast<double>(neighbors);
    ++spheres[std::min(neighbors, kMostNeighbors)];
  });
  for (double& count : spheres) count /= centers;
  fractions_.add(spheres);
  mean_.add(sum / centers);
}

Measurement Coordination::result(const Scene& /*scene*/) const {
  Measurement found{
      .name = std::string(kName),
      .title = "Numbers of neighbours",
      .formula =
          "fraction of the spheres with k neighbours closer than a multiple of the distance at contact",
      .source = "Bernal and Mason, Nature 188 (1960) 910"};
  found.quantities = {
      {"mean_neighbors", "1", mean_.mean(), mean_.error()},
      {"neighbor_reach", "1", reach_},
  };
  Column neighbors{"neighbors", "1", ColumnRole::argument, {}};
  Column value{"fraction", "1", ColumnRole::value, {}};
  Column error{"fraction_error", "1", ColumnRole::error, {}};
  std::size_t rows = 0;
  for (std::size_t k = 0; k < fractions_.bins(); ++k) {
    if (fractions_.mean(k) > 0) rows = k + 1;
  }
  for (std::size_t k = 0; k < rows; ++k) {
    neighbors.values.push_back(static_cast<double>(k));
    value.values.push_back(fractions_.mean(k));
    error.values.push_back(fractions_.error(k));
  }
  found.columns = {std::move(neighbors), std::move(value), std::move(error)};
  return found;
}

}  // namespace hardball
