// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

/// Groups of spheres, whose scatter tells how well a mean over all spheres is known. Every so-manieth sphere
/// is in one group, so that all groups have equal shares of the species.
namespace hardball {

inline constexpr std::size_t kSphereGroups = 16;

/// The group of a sphere; `rank`: its place among all in the order of ids.
constexpr std::size_t group_of(std::size_t rank) {
  return rank % kSphereGroups;
}

/// The group of one of two spheres, always of the same one: what they share counts there for both, since it
/// is one and the same chance.
constexpr std::size_t group_of_pair(std::size_t rank, std::size_t other) {
  const bool is_lower = (rank + other) % 2 == 0;
  return group_of((rank < other) == is_lower ? rank : other);
}

}  // namespace hardball
