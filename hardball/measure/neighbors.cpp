// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/neighbors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "hardball/measure/bonds.hpp"
#include "hardball/measure/fluid_structure.hpp"
#include "hardball/measure/reasons.hpp"
#include "hardball/measure/sphere_groups.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/world/pair_event.hpp"
#include "hardball/world/step_levels.hpp"

namespace hardball {
namespace {

// Equal spheres have at most 12 or 13; a large one among small ones may have more, which are counted in the
// last bin.
constexpr std::size_t kMaxNeighbors = 100;

// Bins: spheres by their number of neighbors, all of these, and all neighbors.
enum : std::size_t { kCenters = kMaxNeighbors + 1, kNeighbors, kCoordinationBins };

constexpr double kExpected = 10;
constexpr double kWidestInOpenSpace = 10;

// Whether centers may be closer than the sum of the radii.
bool may_overlap(const World& world) {
  const StepTable& steps = world.interactions().steps();
  bool is_core_smaller = false;
  for (std::size_t number = 0; number < steps.size(); ++number) {
    is_core_smaller |= steps[static_cast<StepTable::Number>(number)].rules().core < 1;
  }
  return has_passing_pairs(world) || is_core_smaller;
}

constexpr std::size_t kBins = 100;  // of q4 and q6, which lie between 0 and 1

// Bins of the averages: counts of spheres by q4 and by q6; Q4 and Q6 of all bonds; all spheres, those that
// have a bond, and sums over these.
enum : std::size_t { kCountsFour, kCountsSix = kCountsFour + kBins, kAllFour = kCountsSix + kBins, kAllSix };
enum : std::size_t { kSpheres = kAllSix + 1, kBonded, kSumFour, kSumSix, kBonds, kAllBins };

std::size_t bin_of(double invariant) {
  return std::min(static_cast<std::size_t>(invariant * kBins), kBins - 1);
}

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

void Coordination::add_results(const Scene& scene, Measurement& found) const {
  const BlockAverage average = without_transient(average_, std::array{ratio_of(kNeighbors, kCenters)}, scene,
                                                 found, BlockAverage::Groups::separate);
  found.add("mean_neighbors", "1", average.ratio(kNeighbors, kCenters));
  found.add("neighbor_reach", "1", Estimate{reach_}).reason = kReachChosen;
  std::size_t rows = 0;
  for (std::size_t k = 0; k <= kMaxNeighbors; ++k) {
    if (average.total(k) > 0) rows = k + 1;
  }
  found.add_argument("neighbors", "1", tabulated(rows, [](std::size_t k) { return static_cast<double>(k); }));
  found.add("fraction", "1", average.histogram(0, rows, kCenters));
}

bool Coordination::restored() const {
  return average_.has(kCoordinationBins, kSphereGroups) && reach_ > 0 && std::isfinite(reach_);
}

NearestNeighbor::NearestNeighbor(const Scene& scene, std::size_t bins)
    : motion_(scene.thermal_motion()),
      diameter_(2 * scene.world().largest_radius()),
      dimensions_(scene.world().box().dimensions()),
      packing_fraction_(may_overlap(scene.world()) ? kNoNumber : fluid_packing_fraction(scene)),
      begin_(scene.now()),
      bins_(bins),
      average_(bins + 3, kSphereGroups) {
  const World& world = scene.world();
  if (world.size() < 2) return;
  widest_ = kWidestInOpenSpace * diameter_;
  if (std::isfinite(world.box().volume())) {
    const double volume_each = world.box().volume() / static_cast<double>(world.size());
    const double square = diameter_ * diameter_;
    widest_ = (dimensions_ == 2
                   ? std::sqrt(square + kExpected * volume_each / std::numbers::pi)
                   : std::cbrt(square * diameter_ + kExpected * volume_each * 3 / (4 * std::numbers::pi))) -
              diameter_;
    widest_ = std::min(widest_, shortest_period(world.box()));
  }
  sample_cost_ = NeighborQuery::effort(world, diameter_ + widest_).cost;
}

void NearestNeighbor::sample(const Scene& scene) {
  if (widest_ == 0 || scene.world().size() < 2) return;
  const NeighborQuery& surroundings = scene.surroundings();
  const double range = diameter_ + widest_;
  const auto bins = static_cast<double>(bins_);
  surroundings.for_each_center(range, [&](std::size_t center) {
    double nearest = widest_;
    std::size_t nearest_one = center;
    surroundings.for_each_neighbor(center, range, [&](std::size_t neighbor, const Vec3&, double square) {
      const double reach = surroundings.radius(center) + surroundings.radius(neighbor);
      const double gap = std::sqrt(square) - reach;
      if (gap >= nearest) return;
      nearest = gap;
      nearest_one = neighbor;
    });
    average_.put(spheres_bin(), 1, group_of(center));
    if (nearest == widest_) return;
    // Most are mutual nearest neighbors, with the same gap.
    double* const sums = average_.open_bins(0, group_of_pair(center, nearest_one));
    ++sums[known_bin()];
    sums[gaps_bin()] += nearest;
    ++sums[std::min(static_cast<std::size_t>(std::max(nearest, 0.0) / widest_ * bins), bins_ - 1)];
  });
  average_.close_sample(duration(begin_, scene.now()));
}

void NearestNeighbor::add_results(const Scene& scene, Measurement& found) const {
  if (widest_ == 0) return;
  const FunctionOfMeans gap_of = ratio_of(gaps_bin(), known_bin());
  constexpr auto kCoupled = BlockAverage::Groups::coupled;
  const BlockAverage average = without_transient(average_, std::array{gap_of}, scene, found, kCoupled);
  const double width = widest_ / static_cast<double>(bins_);
  const auto none_within = [&](double gap_width) {
    return nearest_neighbor_beyond(packing_fraction_, 1 + gap_width / diameter_, dimensions_);
  };
  const auto low = [&](std::size_t bin) { return static_cast<double>(bin) * width; };
  const auto middle = [&](std::size_t bin) { return low(bin) + width / 2; };
  const auto theory = [&](std::size_t bin) {
    return (none_within(low(bin)) - none_within(low(bin) + width)) / width;
  };
  // The mean is the integral of the probability that the gap is wider; by Simpson's rule.
  double mean_by_theory = 0;
  for (std::size_t bin = 0; bin < bins_; ++bin) {
    mean_by_theory +=
        (none_within(low(bin)) + 4 * none_within(middle(bin)) + none_within(low(bin) + width)) * width / 6;
  }
  const double tolerance = scene.has_equilibrium(motion_) ? kGapTolerance * mean_by_theory : kForComparison;
  Quantity& mean_gap =
      found.add("mean_gap", "L", average.estimate(gap_of, kCoupled), mean_by_theory, tolerance);
  if (may_overlap(scene.world())) {
    leave_out(mean_gap, found.is_transient_over ? "spheres that pass into each other have no gap between them"
                                                : found.unsettled);
  }
  found.add_argument("gap", "L", tabulated(bins_, middle));
  found.add("probability_density", "L^-1", average.histogram(0, bins_, spheres_bin()) / width,
            std::isfinite(packing_fraction_) ? std::optional(tabulated(bins_, theory)) : std::nullopt);
}

bool NearestNeighbor::restored() const {
  return bins_ > 0 && bins_ < average_.bins() && average_.has(bins_ + 3, kSphereGroups) &&
         (dimensions_ == 2 || dimensions_ == 3) && widest_ >= 0 && std::isfinite(widest_) && diameter_ >= 0 &&
         std::isfinite(diameter_);
}

BondOrder::BondOrder(const Scene& scene, double reach)
    : reach_(reach),
      is_flat_(scene.world().box().is_flat()),
      begin_(scene.now()),
      average_(kAllBins, kSphereGroups) {
  constexpr double kEachBond = 100;
  const World& world = scene.world();
  if (world.size() == 0) return;
  const NeighborQuery::Effort effort = NeighborQuery::effort(world, 2 * reach_ * world.largest_radius());
  sample_cost_ = effort.cost + kEachBond * effort.neighbors;
}

void BondOrder::sample(const Scene& scene) {
  if (scene.world().size() == 0) return;
  is_flat_ ? sample_bonds<BondsInPlane>(scene) : sample_bonds<BondsInSpace>(scene);
}

template <class Bonds>
void BondOrder::sample_bonds(const Scene& scene) {
  const NeighborQuery& surroundings = scene.surroundings();
  const double range = 2 * reach_ * scene.world().largest_radius();
  Bonds all;
  surroundings.for_each_center(range, [&](std::size_t center) {
    Bonds bonds;
    const auto add = [&](std::size_t neighbor, const Vec3& separation, double square) {
      bonds.add(1 / std::sqrt(square) * separation);
      average_.put(kBonds, 1, group_of_pair(center, neighbor));
    };
    const std::size_t nearest = surroundings.for_each_bond(center, reach_, add);
    average_.put(kSpheres, 1, group_of(center));
    if (bonds.count == 0) return;
    all.add(bonds);
    // Neighbors have bonds in common.
    double* const sums = average_.open_bins(0, group_of_pair(center, nearest));
    ++sums[kBonded];
    const double four = bonds.invariant_four();
    const double six = bonds.invariant_six();
    sums[kSumFour] += four;
    sums[kSumSix] += six;
    ++sums[kCountsFour + bin_of(four)];
    ++sums[kCountsSix + bin_of(six)];
  });
  if (all.count > 0) {
    average_.put(kAllFour, all.invariant_four());
    average_.put(kAllSix, all.invariant_six());
  }
  // Without a bond the order is undefined.
  average_.close_sample(duration(begin_, scene.now()), all.count > 0 ? 1 : 0);
}

void BondOrder::add_results(const Scene& scene, Measurement& found) const {
  const std::string of_all = is_flat_ ? "Psi" : "Q";
  const std::string of_each = is_flat_ ? "psi" : "q";
  const std::array sensitive{ratio_of(kSumSix, kBonded), ratio_of(kSumFour, kBonded),
                             ratio_of(kBonds, kSpheres)};
  constexpr auto kCoupled = BlockAverage::Groups::coupled;
  const BlockAverage average = without_transient(average_, sensitive, scene, found, kCoupled);
  found.add(of_all + "4", "1", average.ratio(kAllFour));
  found.add(of_all + "6", "1", average.ratio(kAllSix));
  found.add("mean_" + of_each + "4", "1", average.estimate(ratio_of(kSumFour, kBonded), kCoupled));
  found.add("mean_" + of_each + "6", "1", average.estimate(ratio_of(kSumSix, kBonded), kCoupled));
  found.add("mean_bonds", "1", average.ratio(kBonds, kSpheres));
  found.add("neighbor_reach", "1", Estimate{reach_}).reason = kReachChosen;
  found.add_argument("invariant", "1", tabulated(kBins, [](std::size_t bin) {
                       return (static_cast<double>(bin) + 0.5) / kBins;
                     }));
  found.add(of_each + "6_density", "1", kBins * average.histogram(kCountsSix, kBins, kBonded));
  found.add(of_each + "4_density", "1", kBins * average.histogram(kCountsFour, kBins, kBonded));
}

bool BondOrder::restored() const {
  return average_.has(kAllBins, kSphereGroups) && reach_ > 0 && std::isfinite(reach_);
}

}  // namespace hardball
