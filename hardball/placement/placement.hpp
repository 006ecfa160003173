// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/placement/region.hpp"
#include "hardball/world/box.hpp"
#include "hardball/world/progress.hpp"

namespace hardball {

/// Whether the center of a sphere of this radius [L] may lie there [L]. Where this holds in less than about a
/// ten-thousandth of a region, no place may be found.
using IsAllowed = Function<bool(const Vec3& center, double radius)>;

/// The densest packing of equal spheres, pi / sqrt(18), or of equal discs, pi / sqrt(12).
inline constexpr double kClosePacking = 0.74048048969306104;
inline constexpr double kClosePackingOfDiscs = 0.90689968211710893;

/// A sphere whose place is given, which others avoid.
struct PlacedSphere {
  Vec3 center;        ///< Within the box along periodic axes [L].
  double radius = 0;  ///< [L]
};

/// Centers for spheres of these radii [L], in the order given, each uniform among the positions that are
/// allowed and overlap no sphere placed before; large spheres are placed first, after those that are `placed`
/// already. Centers stay a radius away from the ends of axes that are not periodic. The region is the box
/// along bounded axes, an interval along open ones; without `is_allowed` all of it is allowed. Nothing where
/// random placement does not reach this density. Error, with `where` as its place: a number out of range;
/// a sphere is larger than the region; no packing of equal spheres is that dense. Cost: O(n), also where the
/// region is nearly full; in inverse proportion to the part of the region that is allowed.
HARDBALL_EXPORT std::optional<std::vector<Vec3>> find_random_places(
    const Box& box, const Region& region, std::span<const double> radii, Random& random,
    const std::string& where, const Progress& progress = {}, const IsAllowed& is_allowed = {},
    std::span<const PlacedSphere> placed = {});

/// Centers as find_random_places gives them. Error: also if random placement does not reach this density.
HARDBALL_EXPORT std::vector<Vec3> place_randomly(const Box& box, const Region& region,
                                                 std::span<const double> radii, Random& random,
                                                 const std::string& where, const Progress& progress = {},
                                                 const IsAllowed& is_allowed = {},
                                                 std::span<const PlacedSphere> placed = {});

/// Centers for `count` spheres of one radius [L] on a lattice stretched to fill the region, face-centered
/// cubic or, in two dimensions, hexagonal, with vacancies spread evenly. Cost: O(n). Error, with `where` as
/// its place: a number out of range; no such lattice leaves room for the spheres.
HARDBALL_EXPORT std::vector<Vec3> place_on_lattice(const Box& box, const Region& region, std::size_t count,
                                                   double radius, const std::string& where);
/// Calls take(center) for one center after the other, for callers that cannot keep all of them.
HARDBALL_EXPORT void place_on_lattice(const Box& box, const Region& region, std::size_t count, double radius,
                                      const std::string& where, const Function<void(const Vec3&)>& take);

}  // namespace hardball
