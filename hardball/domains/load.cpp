// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/load.hpp"

#include <algorithm>
#include <numeric>

#include "hardball/standard/ranges.hpp"

namespace hardball {

std::uint64_t Load::waited() const {
  const std::uint64_t all = std::accumulate(contacts.begin(), contacts.end(), std::uint64_t{0});
  return contacts.size() * ranges::max(contacts) - all;
}

bool Load::is_uneven(std::uint64_t spheres) const {
  // A division takes about as long as two contacts of every sphere.
  constexpr std::uint64_t kContactsPerSphere = 4;
  return waited() > kContactsPerSphere * spheres;
}

bool Load::has_shallow_halos() const {
  constexpr std::uint64_t kFew = 32;
  return kFew * windows.failed > windows.windows;
}

std::vector<Vec3> centers_by_load(std::span<const Vec3> centers, const Partition& partition,
                                  const Load& load) {
  std::vector<double> spheres(partition.size());
  for (const Vec3& center : centers) ++spheres[partition.domain_at(center)];
  const double all =
      static_cast<double>(std::accumulate(load.contacts.begin(), load.contacts.end(), std::uint64_t{0}));
  const double mean = all / std::max(1.0, static_cast<double>(centers.size()));
  std::vector<double> weights;
  for (std::size_t domain = 0; domain < spheres.size(); ++domain) {
    // Spheres without contacts cost something, too, and few contacts say little.
    constexpr double kLeast = 0.25;
    constexpr double kMost = 8;
    const double rate = static_cast<double>(load.contacts[domain]) / std::max(1.0, spheres[domain]);
    weights.push_back(mean > 0 ? std::clamp(rate / mean, kLeast, kMost) : 1);
  }
  std::vector<Vec3> weighted;
  double due = 0;
  for (const Vec3& center : centers) {
    due += weights[partition.domain_at(center)];
    for (; due >= 1; --due) weighted.push_back(center);
  }
  return weighted;
}

}  // namespace hardball
