// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/jamming.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace hardball {

SizeStatistics statistics_of(std::span<const double> radii, std::size_t dimensions) {
  const auto count = static_cast<double>(radii.size());
  SizeStatistics sizes;
  for (const double radius : radii) sizes.mean += radius / count;
  double square = 0;
  double cube = 0;
  double volume = 0;
  for (const double radius : radii) {
    const double from_mean = radius / sizes.mean - 1;
    square += from_mean * from_mean / count;
    cube += from_mean * from_mean * from_mean / count;
    volume += power(radius, dimensions);
  }
  sizes.mean_volume = volume / count;
  sizes.deviation = std::sqrt(square);
  // Less is rounding.
  constexpr double kEqual = 1e-9;
  sizes.skewness = sizes.deviation > kEqual ? cube / (square * sizes.deviation) : 0;
  std::vector<double> sorted(radii.begin(), radii.end());
  std::ranges::sort(sorted, std::greater());
  sizes.largest = sorted.front();
  double held = 0;
  while (held < volume / 2 && sizes.half_of_volume < sorted.size())
    held += power(sorted[sizes.half_of_volume++], dimensions);
  return sizes;
}

double plausible_packing_fraction(const SizeStatistics& sizes, const Container& container) {
  constexpr double kSpheres = 0.644;
  constexpr double kDiscs = 0.843;
  // The most that small spheres add in the holes between large ones.
  constexpr double kDensest = 0.85;
  double bulk = kDiscs;
  if (container.dimensions == 3) {
    bulk = std::min(kDensest, kSpheres + 0.0658 * sizes.deviation +
                                  0.0857 * sizes.skewness * sizes.deviation * sizes.deviation);
  }
  // The volume next to walls that stays empty, as the thickness of a layer in diameters.
  constexpr double kEmptyLayer = 0.14;
  const double empty = kEmptyLayer * 2 * sizes.mean * container.wall_area() / container.volume();
  return bulk * std::max(0.1, 1 - empty);
}

double rate_for(double packing_fraction, double plausible) {
  struct UpTo {
    double fraction;
    double rate;
  };
  constexpr std::array<UpTo, 5> kRates{
      {{0.90, 0.1}, {0.97, 0.03}, {0.995, 0.01}, {1.003, 0.003}, {1.008, 0.001}}};
  for (const UpTo& step : kRates)
    if (packing_fraction <= step.fraction * plausible) return step.rate;
  return kRates.back().rate;
}

double expected_compressibility(double packing_fraction, double plausible, std::size_t dimensions) {
  const double phi = packing_fraction;
  const double fluid = dimensions == 2
                           ? (1 + phi * phi / 8) / ((1 - phi) * (1 - phi))
                           : (1 + phi + phi * phi - phi * phi * phi) / ((1 - phi) * (1 - phi) * (1 - phi));
  const double free_volume = static_cast<double>(dimensions) / std::max(1e-9, 1 - phi / plausible);
  // Where the free volume of the jammed state is the smaller one, the fluid has left the equation of state.
  const double dense = dimensions == 2 ? 0.65 : 0.5;
  return phi < dense ? fluid : std::max(fluid, free_volume);
}

double expected_collisions(double begin, double end, double rate, double plausible, std::size_t dimensions) {
  if (!(end > begin)) return 0;
  // d ln T = 2 (Z - 1) d ln s, and d ln phi = d d ln s.
  const double heating = std::sqrt(std::numbers::pi) / 3 * 2 * rate;
  const double last = std::min(end, plausible * (1 - 1e-3));
  constexpr int kSteps = 2000;
  double collisions = 0;
  const double step = (last - begin) / kSteps;
  for (int k = 0; k < kSteps && step > 0; ++k) {
    const double phi = begin + (k + 0.5) * step;
    const double excess = expected_compressibility(phi, plausible, dimensions) - 1;
    collisions += 2 * excess * step / (static_cast<double>(dimensions) * phi) / heating;
  }
  return collisions;
}

}  // namespace hardball
