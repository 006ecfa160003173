// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/nearest_neighbor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "hardball/measure/fluid_structure.hpp"
#include "hardball/measure/sphere_groups.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/statistics/qualification.hpp"
#include "hardball/statistics/transient.hpp"
#include "hardball/world/pair_event.hpp"

namespace hardball {
namespace {

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

}  // namespace

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

Measurement NearestNeighbor::result(const Scene& scene) const {
  Measurement result{
      .name = std::string(kName),
      .title = "Gaps between nearest neighbors",
      .formula = "probability density of the gap between a sphere and the one whose surface is nearest",
      .source = "Torquato, Phys. Rev. E 51 (1995) 3170"};
  if (widest_ == 0) return result;
  const FunctionOfMeans gap_of = ratio_of(gaps_bin(), known_bin());
  constexpr auto kCoupled = BlockAverage::Groups::coupled;
  const Transient transient = find_transient(average_, std::array{gap_of}, scene.settled(), kCoupled);
  const BlockAverage average = transient.left_out_of(average_);
  std::vector<Estimate> densities = average.histogram(0, bins_, spheres_bin());
  std::vector<double> gaps;
  std::vector<double> theory;
  const double width = widest_ / static_cast<double>(bins_);
  const auto none_within = [&](double gap_width) {
    return nearest_neighbor_beyond(packing_fraction_, 1 + gap_width / diameter_, dimensions_);
  };
  double mean_by_theory = 0;
  for (std::size_t bin = 0; bin < bins_; ++bin) {
    const double low = static_cast<double>(bin) * width;
    const double middle = low + width / 2;
    const double high = low + width;
    gaps.push_back(middle);
    densities[bin] = densities[bin] / width;
    theory.push_back((none_within(low) - none_within(high)) / width);
    // The mean is the integral of the probability that the gap is wider; by Simpson's rule.
    mean_by_theory += (none_within(low) + 4 * none_within(middle) + none_within(high)) * width / 6;
  }
  const double tolerance = scene.has_equilibrium(motion_) ? kGapTolerance * mean_by_theory : kForComparison;
  result.add("mean_gap", "L", average.estimate(gap_of, kCoupled), mean_by_theory, tolerance);
  result.add_argument("gap", "L", std::move(gaps));
  result.add_estimates("probability_density", "L^-1", densities);
  if (std::isfinite(packing_fraction_)) result.add_theory(std::move(theory));
  transient.note_in(result);
  if (may_overlap(scene.world())) {
    leave_out(result.quantities.front(), "spheres that pass into each other have no gap between them");
  }
  return result;
}

bool NearestNeighbor::restored() const {
  return bins_ > 0 && bins_ < average_.bins() && average_.has(bins_ + 3, kSphereGroups) &&
         (dimensions_ == 2 || dimensions_ == 3) && widest_ >= 0 && std::isfinite(widest_) && diameter_ >= 0 &&
         std::isfinite(diameter_);
}

bool NearestNeighbor::matches(const World& world) const {
  return dimensions_ == world.box().dimensions();
}

}  // namespace hardball
