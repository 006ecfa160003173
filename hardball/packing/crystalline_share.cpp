// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/crystalline_share.hpp"

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "hardball/measure/bonds.hpp"

namespace hardball {
namespace {

constexpr double kNeighborGap = 0.4;
constexpr double kAlike = 0.7;

// The cosine between the vectors of two surroundings.
double likeness(const BondsInSpace& a, const BondsInSpace& b) {
  return a.six.product(b.six) / std::sqrt(a.six.product(a.six) * b.six.product(b.six));
}
double likeness(const BondsInPlane& a, const BondsInPlane& b) {
  return (a.six * std::conj(b.six)).real() / (std::abs(a.six) * std::abs(b.six));
}

template <class Bonds>
double share_with(const PackedSpheres& spheres, std::size_t least) {
  std::vector<Bonds> bonds(spheres.size());
  std::vector<bool> is_at_wall(spheres.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbors;
  spheres.for_each_near(kNeighborGap, [&](const NearPair& pair) {
    if (pair.bodies.is_wall) {
      is_at_wall[pair.bodies.first] = true;
      return;
    }
    const Vec3 direction = (1 / length(pair.separation)) * pair.separation;
    bonds[pair.bodies.first].add(direction);
    bonds[pair.bodies.second].add(-direction);
    neighbors.emplace_back(pair.bodies.first, pair.bodies.second);
  });
  std::vector<std::size_t> alike(spheres.size());
  for (const auto& [a, b] : neighbors) {
    if (!(likeness(bonds[a], bonds[b]) > kAlike)) continue;
    ++alike[a];
    ++alike[b];
  }
  std::size_t crystalline = 0;
  std::size_t surrounded = 0;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    if (is_at_wall[i]) continue;
    ++surrounded;
    if (alike[i] >= least) ++crystalline;
  }
  return surrounded > 0 ? static_cast<double>(crystalline) / static_cast<double>(surrounded) : 0;
}

}  // namespace

double crystalline_share(const PackedSpheres& spheres) {
  constexpr std::size_t kLeast = 8;
  constexpr std::size_t kLeastOfDiscs = 4;
  return spheres.container.dimensions == 2 ? share_with<BondsInPlane>(spheres, kLeastOfDiscs)
                                           : share_with<BondsInSpace>(spheres, kLeast);
}

}  // namespace hardball
