// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "hardball/world/static_hash_grid.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The size of the box along the shortest periodic axis [L]: a sphere has an image of itself that near.
/// Infinite if no axis is periodic.
double shortest_period(const Box& box);

/// Whether two boxes have the same edges and boundaries.
bool is_same_box(const Box& a, const Box& b);

/// All spheres at one time, numbered in the order of ids, and their neighbors: the input of the measures of
/// structure. Nothing depends on where spheres are stored.
class NeighborQuery {
 public:
  /// Measures use the surroundings of all spheres up to this many, and of as many chosen evenly by id if
  /// there are more.
  static constexpr std::size_t kMaxCenters = 5000;
  /// Fewer are chosen if they would have more neighbors than this in all.
  static constexpr double kMaxNeighbors = 2e5;

  /// The work of visiting all neighbors within a range of the spheres chosen, if all are spread evenly.
  struct Effort {
    std::size_t centers;  ///< How many are chosen.
    double neighbors;     ///< Neighbors of all centers together; zero in open space.
    double cost;          ///< Including the search for neighbors [ns].
  };
  /// `range` [L]: how far away a neighbor's center may be. Cost: O(1).
  static Effort effort(const World& world, double range);

  /// Refers to the world and to `centers` [L], those of all spheres in the order of ids, folded into a
  /// periodic box as it is `now`; most lie within the space `extent` [L^3]. Cost: O(n).
  NeighborQuery(const World& world, std::span<const Vec3> centers, double extent, const Time& now);

  std::size_t size() const { return centers_.size(); }
  /// [L]
  double radius(std::size_t sphere) const { return radii_[sphere]; }

  /// Calls visit(sphere) for all spheres, or for those chosen if neighbors within `range` [L] are visited.
  template <class Visit>
  void for_each_center(double range, Visit&& visit) const {
    const std::size_t chosen = effort(world_, range).centers;
    for (std::size_t k = 0; k < chosen; ++k) visit(k * size() / chosen);
  }

  /// Calls visit(neighbor, separation, square) for every other sphere, and every periodic image, no farther
  /// away than `range` [L]; `separation` [L] points to it, `square` [L^2] is its squared length.
  template <class Visit>
  void for_each_neighbor(std::size_t sphere, double range, Visit&& visit) const {
    const auto check = [&](std::uint32_t neighbor, const Vec3& separation, double /*reach*/) {
      const double square = dot(separation, separation);
      if (square > range * range || (neighbor == sphere && square == 0)) return;
      visit(std::size_t{neighbor}, separation, square);
    };
    neighborhood_.for_each_near(centers_[sphere], range - ball_, check);
  }

  /// Calls visit(neighbor, separation, square) as for_each_neighbor() does, for every neighbor that is no
  /// farther away than `reach` [1] times the sum of the two radii. Returns the nearest one, or the sphere
  /// itself if there is none.
  template <class Visit>
  std::size_t for_each_bond(std::size_t sphere, double reach, Visit&& visit) const {
    std::size_t nearest = sphere;
    double least_square = std::numeric_limits<double>::infinity();
    const double range = 2 * reach * world_.largest_radius();
    for_each_neighbor(sphere, range, [&](std::size_t neighbor, const Vec3& separation, double square) {
      const double farthest = reach * (radius(sphere) + radius(neighbor));
      if (square > farthest * farthest) return;
      if (square < least_square) {
        least_square = square;
        nearest = neighbor;
      }
      visit(neighbor, separation, square);
    });
    return nearest;
  }

 private:
  const World& world_;
  std::span<const Vec3> centers_;
  std::vector<double> radii_;
  double ball_;                  // radius of all balls in the neighborhood [L]
  StaticHashGrid neighborhood_;  // its cells hold about two centers each
};

}  // namespace hardball
