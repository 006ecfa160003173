// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/bond_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "hardball/measure/bonds.hpp"
#include "hardball/measure/reasons.hpp"
#include "hardball/measure/sphere_groups.hpp"
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
  const std::array sensitive{ratio_of(kSumSix, kBonded), ratio_of(kSumFour, kBonded),
                             ratio_of(kBonds, kSpheres)};
  constexpr auto kCoupled = BlockAverage::Groups::coupled;
  const Transient transient = find_transient(average_, sensitive, scene.settled(), kCoupled);
  const BlockAverage average = transient.left_out_of(average_);
  found.add(of_all + "4", "1", average.ratio(kAllFour));
  found.add(of_all + "6", "1", average.ratio(kAllSix));
  found.add("mean_" + of_each + "4", "1", average.estimate(ratio_of(kSumFour, kBonded), kCoupled));
  found.add("mean_" + of_each + "6", "1", average.estimate(ratio_of(kSumSix, kBonded), kCoupled));
  found.add("mean_bonds", "1", average.ratio(kBonds, kSpheres));
  found.add("neighbor_reach", "1", {reach_}).reason = kReachChosen;
  std::vector<double> invariants;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    invariants.push_back((static_cast<double>(bin) + 0.5) / kBins);
  }
  found.add_argument("invariant", "1", std::move(invariants));
  const auto add_density = [&](const std::string& name, std::size_t first) {
    std::vector<Estimate> shares = average.histogram(first, kBins, kBonded);
    for (Estimate& share : shares) share = kBins * share;
    found.add_estimates(name, "1", shares);
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
