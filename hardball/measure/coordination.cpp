// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/coordination.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "hardball/measure/reasons.hpp"
#include "hardball/measure/sphere_groups.hpp"
#include "hardball/statistics/transient.hpp"

namespace hardball {
namespace {

// Equal spheres have at most 12 or 13; a large one among small ones may have more, which are counted in the
// last bin.
constexpr std::size_t kMaxNeighbors = 100;

// Bins: spheres by their number of neighbors, all of these, and all neighbors.
constexpr std::size_t kCenters = kMaxNeighbors + 1;
constexpr std::size_t kNeighbors = kCenters + 1;
constexpr std::size_t kCoordinationBins = kNeighbors + 1;

}  // namespace

Coordination::Coordination(const Scene& scene, double reach)
    : reach_(reach), begin_(scene.now()), average_(kCoordinationBins, kSphereGroups) {
  const World& world = scene.world();
  if (world.size() == 0) return;
  sample_cost_ = NeighborQuery::effort(world, 2 * reach_ * world.largest_radius()).cost;
}

void Coordination::sample(const Scene& scene) {
  if (scene.world().size() == 0) return;
  const NeighborQuery& surroundings = scene.surroundings();
  const double range = 2 * reach_ * scene.world().largest_radius();
  surroundings.for_each_center(range, [&](std::size_t center) {
    std::size_t neighbors = 0;
    const auto count = [&](std::size_t neighbor, const Vec3&, double) {
      ++neighbors;
      average_.put(kNeighbors, 1, group_of_pair(center, neighbor));
    };
    const std::size_t nearest = surroundings.for_each_bond(center, reach_, count);
    average_.put(kCenters, 1, group_of(center));
    // Nearby spheres have neighbors in common.
    const std::size_t group = neighbors > 0 ? group_of_pair(center, nearest) : group_of(center);
    average_.put(std::min(neighbors, kMaxNeighbors), 1, group);
  });
  average_.close_sample(duration(begin_, scene.now()));
}

Measurement Coordination::result(const Scene& scene) const {
  Measurement found{
      .name = std::string(kName),
      .title = "Numbers of neighbors",
      .formula = "fraction of the spheres with $k$ neighbors closer than a multiple of the sum of the radii",
      .source = "Bernal and Mason, Nature 188 (1960) 910"};
  const Transient transient = find_transient(average_, std::array{ratio_of(kNeighbors, kCenters)},
                                             scene.settled(), BlockAverage::Groups::separate);
  const BlockAverage average = transient.left_out_of(average_);
  found.add("mean_neighbors", "1", average.ratio(kNeighbors, kCenters));
  found.add("neighbor_reach", "1", {reach_}).reason = kReachChosen;
  std::size_t rows = 0;
  for (std::size_t k = 0; k <= kMaxNeighbors; ++k) {
    if (average.total(k) > 0) rows = k + 1;
  }
  std::vector<double> neighbors(rows);
  std::iota(neighbors.begin(), neighbors.end(), 0.0);
  found.add_argument("neighbors", "1", std::move(neighbors));
  found.add_estimates("fraction", "1", average.histogram(0, rows, kCenters));
  transient.note_in(found);
  return found;
}

bool Coordination::restored() const {
  return average_.has(kCoordinationBins, kSphereGroups) && reach_ > 0 && std::isfinite(reach_);
}

}  // namespace hardball
