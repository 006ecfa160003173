// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "hardball/world/neighborhood.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// All spheres as they are at one moment, numbered in the order of ids, and who is near whom: what the
/// measures of structure look at. Nothing depends on where spheres are stored.
class Surroundings {
 public:
  /// The measures look at the surroundings of all spheres up to this many, and of as many chosen evenly by id
  /// if there are more.
  static constexpr std::size_t kMostCenters = 20000;
  /// Of fewer, if they would have more neighbours than this in all.
  static constexpr double kMostNeighbors = 2e5;

  /// `range` [L]: how far away a neighbour's centre may be. Cost: O(n).
  Surroundings(const World& world, const Time& now, double range);

  /// What making this and visiting all neighbours costs [ns], if they are spread evenly.
  double cost() const;

  /// How many neighbours there are to visit, about all centers together, if they are spread evenly.
  double neighbors() const { return static_cast<double>(chosen_) * neighbors_; }

  std::size_t size() const { return centers_.size(); }
  /// Folded into a periodic box [L].
  const Vec3& center(std::size_t sphere) const { return centers_[sphere]; }
  /// [L]
  double radius(std::size_t sphere) const { return radii_[sphere]; }

  /// Calls visit(sphere) for all spheres, or for those chosen.
  template <class Visit>
  void for_each_center(Visit&& visit) const {
    for (std::size_t k = 0; k < chosen_; ++k) visit(k * size() / chosen_);
  }

  /// Calls visit(neighbor, separation, square) for every other sphere, and every periodic copy, within the
  /// range; `separation` [L] points to it, `square` [L^2] is its squared length.
  template <class Visit>
  void for_each_neighbor(std::size_t sphere, Visit&& visit) const {
    const auto look_at = [&](std::uint32_t neighbor, const Vec3& separation, double /*reach*/) {
      const double square = dot(separation, separation);
      if (square > range_ * range_ || (neighbor == sphere && square == 0)) return;
      visit(std::size_t{neighbor}, separation, square);
    };
    neighborhood_.for_each_near(centers_[sphere], range_ / 2, look_at);
  }

 private:
  double range_;
  double neighbors_ = 0;    // of each sphere, if they are spread evenly; zero in open space
  std::size_t chosen_ = 0;  // centers
  std::vector<Vec3> centers_;
  std::vector<double> radii_;
  Neighborhood neighborhood_;  // of balls that touch when their centres are the range apart
};

}  // namespace hardball
