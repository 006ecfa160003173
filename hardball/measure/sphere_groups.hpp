// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>

#include "hardball/statistics/block_average.hpp"

/// Groups of spheres, from whose scatter the error of a mean over all spheres is computed. Spheres are
/// assigned to groups in turn, so that all groups have equal parts of the species.
namespace hardball {

inline constexpr std::size_t kSphereGroups = 16;

/// The group of a sphere; `rank`: its position among all in the order of ids.
constexpr std::size_t group_of(std::size_t rank) {
  return rank % kSphereGroups;
}

/// The group of one of two spheres, always of the same one: what they have in common counts there for both,
/// since it varies as one.
constexpr std::size_t group_of_pair(std::size_t rank, std::size_t other) {
  const bool is_lower = (rank + other) % 2 == 0;
  return group_of((rank < other) == is_lower ? rank : other);
}

/// The mean speed, from bins of an average that hold sums over spheres: of the speed, of its square in some
/// unit, and of one. Where energy is fixed, spheres vary less than independent ones: each group is scaled to
/// the mean energy.
inline Estimate mean_speed(const BlockAverage& average, std::size_t speed, std::size_t square,
                           std::size_t spheres, bool is_energy_fixed) {
  const double mean_square = average.ratio(square, spheres).value;
  return average.estimate(
      [=](Means means) {
        return means[speed] / means[spheres] * std::sqrt(mean_square * means[spheres] / means[square]);
      },
      is_energy_fixed ? BlockAverage::Groups::exchanging : BlockAverage::Groups::none);
}

}  // namespace hardball
