// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/events/event.hpp"
#include "hardball/geometry/extent.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/queries/sphere_search.hpp"
#include "hardball/world/world.hpp"

/// Queries of a world at one moment, which change nothing. They look at all spheres, or in the cells that
/// engines have, and then give the same answers to the bit; a World is a search of all spheres. In all of
/// them `now` is finite and not before the start of any path, and a sphere never meets its own periodic
/// images.
namespace hardball {

/// The id of a sphere that is not in the world.
inline constexpr SphereId kNoSphere = std::numeric_limits<SphereId>::max();

/// A contact in the future.
struct NextContact {
  double time = 0;  ///< [T]
  EventKind kind = EventKind::collision;
  SphereId first = 0;
  std::uint32_t second = 0;  ///< The id of the other sphere, or the number of the wall.

  friend bool operator==(const NextContact&, const NextContact&) = default;
};

/// What a ray hits, and where.
struct RayHit {
  EventKind kind = EventKind::collision;  ///< What is hit: a sphere (collision) or a wall.
  std::uint32_t body = 0;                 ///< The id of the sphere, or the number of the wall.
  double distance = 0;                    ///< From the origin of the ray [L].
  Vec3 point;                             ///< Folded into a periodic box [L].
  Vec3 normal;                            ///< The unit vector out of the body [1].
};

/// How far the nearest body is.
struct Clearance {
  double distance = 0;                    ///< Between the surfaces; negative where they overlap [L].
  EventKind kind = EventKind::collision;  ///< What is nearest: a sphere (collision) or a wall.
  std::uint32_t body = 0;                 ///< The id of the sphere, or the number of the wall.
};

/// Which bodies a query looks for; all by default.
struct BodyFilter {
  /// Whether a sphere of a world, by its slot there, is looked for; all are if it is empty. It must be a
  /// function of the sphere alone, and is only asked about those that would be found.
  Function<bool(const World&, Slot)> spheres = {};
  bool walls = true;  ///< Whether walls are looked for.

  /// Whether a sphere belongs to the part and is looked for.
  bool accepts(const SphereSearch::Part& part, Slot slot) const {
    return (!part.owns || part.owns(slot)) && (!spheres || spheres(*part.world, slot));
  }
};

/// What a sphere would hit first up to `until` if it took this velocity [L/T] at `now`, and all others kept
/// their paths: to the last bit what an engine would predict after such a change. The sphere in question is
/// `first`. Of simultaneous contacts, that with the sphere of the lowest id comes first, and walls come last.
/// A sphere that passes through others touches them when it begins to.
///
/// Error: spheres grow or have potentials of steps; the box is sheared; no such sphere; a velocity that is
/// not finite or out of range; `until` is before `now` or NaN, or in a periodic box infinite. Cost:
/// O(spheres that could come near up to the contact), once the second question about a moment has sorted
/// them, O(n); that of the first question, and in a search without MovingSpheres: O(n), in a periodic box as
/// often as the fastest sphere would cross half of it before the contact.
HARDBALL_EXPORT std::optional<NextContact> first_contact(const SphereSearch& search, const Time& now,
                                                         SphereId id, const Vec3& velocity,
                                                         const Time& until);

/// The first contact of a sphere that is not in the world; `first` is kNoSphere. It hits now what it overlaps
/// and approaches. Error: see World::add.
HARDBALL_EXPORT std::optional<NextContact> first_contact(const SphereSearch& search, const Time& now,
                                                         const Sphere& sphere, const Time& until);

/// What a ray hits first, the world being at rest as it is at `now`, up to `most` [L] from its origin. A ray
/// that starts inside a sphere or an obstacle does not hit it. Of bodies at the same distance, spheres come
/// before walls, and low numbers before high ones. Error: the box is sheared; a number that is not finite, or
/// out of range; a direction of length zero; `most` is negative or NaN, or in a periodic box infinite. Cost:
/// with cells, O(cells up to the hit); otherwise O(n), in a periodic box as often as the ray crosses half of
/// it.
HARDBALL_EXPORT std::optional<RayHit> ray(const SphereSearch& search, const Time& now, const Vec3& origin,
                                          const Vec3& direction, double most, const BodyFilter& filter = {});

/// All that a ray enters, in the order of distances: it passes through spheres and obstacles, and ends at the
/// first other wall. Images of a sphere in a periodic box are hits of their own. Error and cost: as for ray,
/// up to the end.
HARDBALL_EXPORT std::vector<RayHit> ray_hits(const SphereSearch& search, const Time& now, const Vec3& origin,
                                             const Vec3& direction, double most,
                                             const BodyFilter& filter = {});

/// The body nearest to a point; of several, as for `ray`; none if there are none. Error: a coordinate that is
/// not finite or out of range. Cost: with cells, O(cells up to the body); otherwise O(n).
HARDBALL_EXPORT std::optional<Clearance> clearance(const SphereSearch& search, const Time& now,
                                                   const Vec3& point, const BodyFilter& filter = {});

/// The body nearest to a sphere, from surface to surface. Error: no such sphere. Cost: as for a point.
HARDBALL_EXPORT std::optional<Clearance> clearance(const SphereSearch& search, const Time& now, SphereId id,
                                                   const BodyFilter& filter = {});

/// The spheres that overlap a ball around `center` with this radius [L], in the order of ids; those that only
/// touch it do not. Error: a number that is not finite or out of range; a negative radius. Cost: with cells,
/// O(cells that it meets); otherwise O(n).
HARDBALL_EXPORT std::vector<SphereId> overlap(const SphereSearch& search, const Time& now, const Vec3& center,
                                              double radius, const BodyFilter& filter = {});

/// The spheres that overlap a box, in the order of ids. Error: as for a ball; its low end lies above its high
/// end; it is larger than a periodic box. Cost: as for a ball.
HARDBALL_EXPORT std::vector<SphereId> overlap(const SphereSearch& search, const Time& now,
                                              const Extent& extent, const BodyFilter& filter = {});

}  // namespace hardball
