// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/surroundings.hpp"

#include <numbers>

namespace hardball {

Surroundings::Surroundings(const World& world, const Time& now, double range)
    : range_(range), neighborhood_(world.box(), world.size(), range / 2) {
  centers_.reserve(world.size());
  radii_.reserve(world.size());
  world.for_each_by_id([&](Slot slot) {
    centers_.push_back(world.position(slot, now));
    radii_.push_back(world.radius(slot));
    neighborhood_.insert(centers_.back(), range / 2);
  });
  neighbors_ =
      static_cast<double>(size()) * 4 * std::numbers::pi / 3 * range * range * range / world.box().volume();
  const auto affordable = std::min(kMostNeighbors / neighbors_, static_cast<double>(kMostCenters));
  chosen_ = std::min(size(), static_cast<std::size_t>(std::max(affordable, 1.0)));
}

double Surroundings::cost() const {
  constexpr double kEachSphere = 100;
  constexpr double kEachCenter = 400;
  constexpr double kEachNeighbor = 30;
  return kEachSphere * static_cast<double>(size()) + kEachCenter * static_cast<double>(chosen_) +
         kEachNeighbor * neighbors();
}

}  // namespace hardball
