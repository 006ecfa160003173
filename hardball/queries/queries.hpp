// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "hardball/errors/export.hpp"
#include "hardball/events/event.hpp"
#include "hardball/world/world.hpp"

/// Queries of a world at one moment, which look at every sphere once: they need no structures and change
/// nothing. In all of them `now` is finite and not before the start of any path, and a sphere never meets its
/// own periodic images.
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

/// What a sphere would hit first up to `until` if it took this velocity [L/T] at `now`, and all others kept
/// their paths: to the last bit what an engine would predict after such a change. The sphere in question is
/// `first`. Of simultaneous contacts, that with the sphere of the lowest id comes first, and walls come last.
/// A sphere that passes through others touches them when it begins to.
///
/// Error: spheres grow or have potentials of steps; the box is sheared; no such sphere; a velocity that is
/// not finite or out of range; `until` is before `now` or NaN, or in a periodic box infinite. Cost: O(n), and
/// in a periodic box as often as the fastest sphere would cross half of it before the contact.
HARDBALL_EXPORT std::optional<NextContact> first_contact(const World& world, const Time& now, SphereId id,
                                                         const Vec3& velocity, const Time& until);

/// The first contact of a sphere that is not in the world; `first` is kNoSphere. It hits now what it overlaps
/// and approaches. Error: see World::add.
HARDBALL_EXPORT std::optional<NextContact> first_contact(const World& world, const Time& now,
                                                         const Sphere& sphere, const Time& until);

/// What a ray hits first, the world being at rest as it is at `now`, up to `most` [L] from its origin. A ray
/// that starts inside a sphere or an obstacle does not hit it. Of bodies at the same distance, spheres come
/// before walls, and low numbers before high ones. Error: the box is sheared; a number that is not finite, or
/// out of range; a direction of length zero; `most` is negative or NaN, or in a periodic box infinite. Cost:
/// O(n), and in a periodic box as often as the ray crosses half of it.
HARDBALL_EXPORT std::optional<RayHit> ray(const World& world, const Time& now, const Vec3& origin,
                                          const Vec3& direction, double most);

/// The body nearest to a point; of several, as for `ray`; none if the world is empty. Error: a coordinate
/// that is not finite or out of range. Cost: O(n).
HARDBALL_EXPORT std::optional<Clearance> clearance(const World& world, const Time& now, const Vec3& point);

/// The body nearest to a sphere, from surface to surface. Error: no such sphere. Cost: O(n).
HARDBALL_EXPORT std::optional<Clearance> clearance(const World& world, const Time& now, SphereId id);

}  // namespace hardball
