// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/bond_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "hardball/measure/bonds.hpp"
#include "hardball/measure/sphere_groups.hpp"
#include "hardball/statistics/qualification.hpp"
#include "hardball/statistics/transient.hpp"
#include "hardball/world/step_levels.hpp"

namespace hardball {
namespace {

constexpr std::size_t kBins = 100;  // of q4 and q6, which lie between 0 and 1

// Bins of the averages: counts of spheres by q4 and by q6; Q4 and Q6 of all bonds; all spheres, those that
// have a bond, and sums over these.
constexpr std::size_t kCountsFour = 0;
constexpr std::size_t kCountsSix = kCountsFour + kBins;
constexpr std::size_t kAllFour = kCountsSix + kBins;
constexpr std::size_t kAllSix = kAllFour + 1;
constexpr std::size_t kSpheres = kAllSix + 1;
constexpr std::size_t kBonded = kSpheres + 1;
constexpr std::size_t kSumFour = kBonded + 1;
constexpr std::size_t kSumSix = kSumFour + 1;
constexpr std::size_t kBonds = kSumSix + 1;
constexpr std::size_t kAllBins = kBonds + 1;

std::size_t bin_of(double invariant) {
  return std::min(static_cast<std::size_t>(invariant * kBins), kBins - 1);
}

}  // namespace

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
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t nearest_one = center;
    surroundings.for_each_neighbor(
        center, range, [&](std::size_t neighbor, const Vec3& separation, double square) {
          const double farthest = reach_ * (surroundings.radius(center) + surroundings.radius(neighbor));
          if (square > farthest * farthest) return;
          if (square < nearest) {
            nearest = square;
            nearest_one = neighbor;
          }
          bonds.add(1 / std::sqrt(square) * separation);
          average_.put(kBonds, 1, group_of_pair(center, neighbor));
        });
    average_.put(kSpheres, 1, group_of(center));
    if (bonds.count == 0) return;
    all.add(bonds);
    // Neighbors have bonds in common.
    double* const sums = average_.open_bins(0, group_of_pair(center, nearest_one));
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

Measurement BondOrder::result(const Scene& scene) const {
  Measurement found{
      .name = std::string(kName),
      .title = "Bond-orientational order",
      .formula =
          R"($Q_l = \left( \frac{4 \pi}{2 l + 1} \sum_m |\langle Y_{lm} \rangle|^2 \right)^{1/2}$ over all )"
          R"(bonds; $q_l$: the same over the bonds of one sphere)",
      .source = "Steinhardt, Nelson and Ronchetti, Phys. Rev. B 28 (1983) 784"};
  if (is_flat_) {
    found.formula =
        R"($\Psi_l = \left| \langle e^{i l \theta} \rangle \right|$ over all bonds; $\psi_l$: the same over )"
        R"(the bonds of one disc)";
    found.source = "Halperin and Nelson, Phys. Rev. Lett. 41 (1978) 121";
  }
  const std::string of_all = is_flat_ ? "Psi" : "Q";
  const std::string of_each = is_flat_ ? "psi" : "q";
  const auto mean_of = [](std::size_t sum) {
    return [sum](std::span<const double> means) { return means[sum] / means[kBonded]; };
  };
  const FunctionOfMeans six_of = mean_of(kSumSix);
  const FunctionOfMeans four_of = mean_of(kSumFour);
  const FunctionOfMeans bonds_of = [](std::span<const double> means) {
    return means[kBonds] / means[kSpheres];
  };
  const Transient transient = find_transient(average_, std::array{six_of, four_of, bonds_of}, scene.settled(),
                                             BlockAverage::Groups::coupled);
  const BlockAverage average = transient.left_out_of(average_);
  const auto quantity = [&](const std::string& name, const Estimate& estimate) {
    return Quantity{name, "1", estimate.value, estimate.error};
  };
  found.quantities = {
      quantity(of_all + "4", average.ratio(kAllFour)),
      quantity(of_all + "6", average.ratio(kAllSix)),
      quantity("mean_" + of_each + "4", average.estimate(four_of, BlockAverage::Groups::coupled)),
      quantity("mean_" + of_each + "6", average.estimate(six_of, BlockAverage::Groups::coupled)),
      quantity("mean_bonds", average.ratio(kBonds, kSpheres)),
      no_estimate("neighbor_reach", "1", reach_, "it is a choice of the measure")};
  Column invariant{"invariant", "1", ColumnRole::argument, {}};
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    invariant.values.push_back((static_cast<double>(bin) + 0.5) / kBins);
  }
  found.columns.push_back(std::move(invariant));
  const auto add_density = [&](const std::string& name, std::size_t first) {
    Column value{name, "1", ColumnRole::value, {}};
    Column error{name + "_error", "1", ColumnRole::error, {}};
    for (const Estimate& share : average.histogram(first, kBins, kBonded)) {
      value.values.push_back(share.value * kBins);
      error.values.push_back(share.error * kBins);
    }
    found.columns.push_back(std::move(value));
    found.columns.push_back(std::move(error));
  };
  add_density(of_each + "6_density", kCountsSix);
  add_density(of_each + "4_density", kCountsFour);
  transient.note_in(found);
  return found;
}

bool BondOrder::restored() const {
  return average_.has(kAllBins, kSphereGroups) && reach_ > 0 && std::isfinite(reach_);
}

}  // namespace hardball
