// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>

#include "hardball/events/event.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/surfaces/surface.hpp"

namespace hardball {

/// The velocities of the two bodies of a contact [L/T]; of a wall contact the second is the wall's.
struct Velocities {
  Vec3 first;
  Vec3 second;

  friend bool operator==(const Velocities&, const Velocities&) = default;
};

/// Negative if bodies that are `separation` [L] apart approach each other [L^2/T]: the same expression whose
/// sign decides whether a contact is predicted.
inline double approach(const Vec3& separation, const Velocities& velocities) {
  return dot(separation, velocities.second - velocities.first);
}

/// One collision or wall contact: the state at the moment of contact, and the velocities after it.
struct Contact {
  Time time;
  EventKind kind = EventKind::collision;  ///< collision or wall
  SphereId first = 0;                     ///< The sphere; of a collision, the one with the lower id.
  std::uint32_t second = 0;               ///< The id of the other sphere, or the number of the wall.
  Image image;    ///< The image of the second sphere that was met, both being folded into the box.
  Vec3 position;  ///< Centre of the first sphere, folded into the box [L].
  /// Collision: centre of the second sphere, folded into the box [L]. Wall: zero.
  Vec3 second_position;
  /// Collision: from the centre of the first sphere to that of the second. Wall: from the centre to the wall,
  /// perpendicular. [L]
  Vec3 separation;
  double reach = 0;         ///< Sum of the radii, or the radius: the length `separation` should have [L].
  double first_radius = 0;  ///< [L]
  double first_mass = 0;    ///< [M]
  double second_mass = 0;   ///< [M]; infinite for a wall.
  Velocities before;        ///< [L/T]
  Velocities after;         ///< [L/T]; equal to `before` while the response is called.
  Vec3 wall_normal;         ///< Wall: the unit vector from the centre towards it [1].
  double pressing = 0;      ///< Wall: the acceleration of the sphere towards it [L/T^2].
  SurfaceMaterial wall_material;  ///< Wall: what it does; of a face of the box, what the response does.

  bool is_collision() const { return kind == EventKind::collision; }
  /// Unit vector along `separation`, or towards the wall [1].
  Vec3 normal() const { return is_collision() ? (1 / length(separation)) * separation : wall_normal; }
  /// Where the surfaces touch, in the coordinates of `position` [L].
  Vec3 point() const { return position + first_radius * normal(); }
  /// The momentum the first sphere gained [M L/T]; the second lost as much.
  Vec3 impulse() const { return first_mass * (after.first - before.first); }
  /// The speed at which the surfaces met, along the normal [L/T]; not negative.
  double impact_speed() const {
    const double speed = dot(before.first - before.second, normal());
    return speed > 0 ? speed : 0;
  }
  /// How far the surfaces overlapped by rounding, as a fraction of `reach` [1]; negative for a gap.
  double overlap() const {
    return 1 - (is_collision() ? length(separation) : dot(separation, normal())) / reach;
  }
};

/// What a contact does to velocities: given the contact with `after` still equal to `before`, the new
/// velocities. What is returned for a wall is ignored. The bodies must not approach each other afterwards.
template <class R>
concept Response = requires(const R& response, const Contact& contact) {
  { response(contact) } -> std::convertible_to<Velocities>;
};

}  // namespace hardball
