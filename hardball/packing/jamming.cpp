// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/jamming.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <queue>
#include <vector>

#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

// Lengths that a line cuts out of spheres: it meets each as often as its cross section is large, and the
// square of the length over the diameter is uniform. Evenly spread, not random.
std::vector<double> chords(std::span<const double> radii) {
  constexpr std::size_t kChords = 1 << 14;
  constexpr double kGolden = 0.6180339887498949;
  std::vector<double> sorted(radii.begin(), radii.end());
  ranges::sort(sorted);
  double all = 0;
  for (const double radius : sorted) all += radius * radius;
  std::vector<double> lengths(kChords);
  std::size_t sphere = 0;
  double met = sorted.front() * sorted.front();
  for (std::size_t k = 0; k < kChords; ++k) {
    const double share = (static_cast<double>(k) + 0.5) / kChords;
    while (met < share * all && sphere + 1 < sorted.size()) {
      ++sphere;
      met += sorted[sphere] * sorted[sphere];
    }
    const double turns = static_cast<double>(k + 1) * kGolden;
    lengths[k] = 2 * sorted[sphere] * std::sqrt(turns - std::floor(turns));
  }
  return lengths;
}

}  // namespace

SizeStatistics statistics_of(std::span<const double> radii, std::size_t dimensions) {
  const auto count = static_cast<double>(radii.size());
  SizeStatistics sizes;
  for (const double radius : radii) sizes.mean += radius / count;
  double square = 0;
  double volume = 0;
  for (const double radius : radii) {
    const double from_mean = radius / sizes.mean - 1;
    square += from_mean * from_mean / count;
    volume += power(radius, dimensions);
  }
  sizes.mean_volume = volume / count;
  sizes.deviation = std::sqrt(square);
  std::vector<double> sorted(radii.begin(), radii.end());
  ranges::sort(sorted, std::greater());
  sizes.largest = sorted.front();
  double held = 0;
  while (held < volume / 2 && sizes.half_of_volume < sorted.size())
    held += power(sorted[sizes.half_of_volume++], dimensions);
  return sizes;
}

double jamming_in_bulk(std::span<const double> radii, std::size_t dimensions) {
  constexpr double kSpheres = 0.644;
  constexpr double kDiscs = 0.843;
  if (dimensions == 2) return kDiscs;
  const auto [smallest, largest] = ranges::minmax(radii);
  constexpr double kEqual = 1e-9;
  if (largest - smallest <= kEqual * largest) return kSpheres;
  std::vector<double> rods = chords(radii);
  ranges::sort(rods, std::greater());
  // The gap beside a rod over its length, with which equal spheres are as dense as they jam.
  constexpr double kGap = 0.7638;
  std::priority_queue<double> gaps;
  gaps.push(kGap * rods.front());
  double filled = 0;
  for (const double rod : rods) {
    filled += rod;
    if (&rod == &rods.front()) continue;
    const double widest = gaps.top();
    gaps.pop();
    gaps.push(kGap * rod);
    gaps.push(std::max(kGap * rod, widest - (1 + kGap) * rod));
  }
  double empty = 0;
  for (; !gaps.empty(); gaps.pop()) empty += gaps.top();
  return filled / (filled + empty);
}

double plausible_packing_fraction(double in_bulk, const SizeStatistics& sizes, const Container& container) {
  // The volume next to walls that stays empty, as the thickness of a layer in diameters.
  constexpr double kEmptyLayer = 0.14;
  const double empty = kEmptyLayer * 2 * sizes.mean * container.wall_area() / container.volume();
  return in_bulk * std::max(0.1, 1 - empty);
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
