// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <utility>

#include "hardball/describe/names.hpp"
#include "hardball/events/event.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/interaction/species.hpp"
#include "hardball/interaction/step_potential.hpp"
#include "hardball/surfaces/surface_material.hpp"

namespace hardball {

/// The velocities of the two bodies of a contact [L/T]; of a wall contact the second is the wall's.
struct Velocities {
  Vec3 first;
  Vec3 second;

  friend bool operator==(const Velocities&, const Velocities&) = default;
};

/// The angular velocities of the two bodies of a contact [1/T]; zero for a wall.
struct Spins {
  Vec3 first;
  Vec3 second;

  friend bool operator==(const Spins&, const Spins&) = default;
};

/// What becomes of the bodies of a contact.
enum class ContactOutcome : std::uint8_t {
  bounce,  ///< The bodies separate.
  pass,    ///< Spheres pass through each other, on unchanged paths.
  merge,   ///< Two spheres become one: the first, in the place and with the mass of both.
};
template <>
inline constexpr std::array<std::string_view, 3> kNames<ContactOutcome>{"bounce", "pass", "merge"};

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
  /// The image of the second sphere, or of a mesh, that was met, the spheres being folded into the box.
  Image image;
  /// Wall: the face, edge or vertex of a mesh that was met, see Mesh; zero of other walls.
  std::uint32_t feature = 0;
  std::uint32_t triangle = 0;  ///< Wall: the triangle of a mesh to which the feature belongs; else zero.
  std::uint32_t group = 0;     ///< Wall: the index of the group of this triangle; else zero.
  Vec3 position;               ///< Center of the first sphere, folded into the box [L].
  /// Collision: center of the second sphere, folded into the box [L]. Wall: zero.
  Vec3 second_position;
  /// Collision: from the center of the first sphere to that of the second. Wall: from the center to the wall,
  /// perpendicular. [L]
  Vec3 separation;
  /// The length that `separation` should have [L]: the sum of the radii, or the radius; at a step or the core
  /// of a potential, its distance.
  double reach = 0;
  double first_radius = 0;  ///< [L]
  /// Collision: the radius of the second sphere. Wall: zero. [L]
  double second_radius = 0;
  double first_mass = 0;   ///< [M]; infinite for a kinematic sphere.
  double second_mass = 0;  ///< [M]; infinite for a wall, too.
  /// How much faster the image of the second sphere moves along x than the sphere itself [L/T]; zero but for
  /// images above or below in a sheared box.
  double image_speed = 0;
  /// Velocities of the centers before the contact [L/T], that of the second sphere being its image's. While a
  /// response is called for spheres that grow: velocities of their surfaces where they meet.
  Velocities before;
  Velocities after;    ///< [L/T]; equal to `before` while the response is called.
  Spins spins_before;  ///< [1/T]
  Spins spins_after;   ///< [1/T]; equal to `spins_before` while the response is called.
  /// Moments of inertia over mass and squared radius [1].
  double first_inertia_factor = kSphereInertiaFactor;
  double second_inertia_factor = kSphereInertiaFactor;
  /// When the motion of each sphere had last changed; minus infinity for a wall.
  Time first_since;
  Time second_since;
  SpeciesId first_species = 0;
  SpeciesId second_species = 0;  ///< Zero for a wall.
  ContactOutcome outcome = ContactOutcome::bounce;
  Vec3 wall_normal;  ///< Wall: the unit vector from the center toward it [1].
  /// Wall: from the point of a surface, which moves with it, to where the sphere touches it; of a face of the
  /// box zero. [L]
  Vec3 wall_arm;
  double pressing = 0;            ///< Wall: the acceleration of the sphere toward it [L/T^2].
  double growth = 0;              ///< The rate at which `reach` grows [L/T].
  SurfaceMaterial wall_material;  ///< Wall: what it does.
  StepAttempt step;               ///< Collision: the step of a potential, if the spheres meet at one.

  bool is_collision() const { return kind == EventKind::collision; }
  /// Unit vector along `separation`, or toward the wall [1].
  Vec3 normal() const { return is_collision() ? (1 / length(separation)) * separation : wall_normal; }
  /// The point at which the surfaces touch, in the coordinates of `position` [L].
  Vec3 point() const { return position + first_radius * normal(); }
  /// The momentum the first sphere gained [M L/T]; the second lost as much. Zero between kinematic spheres.
  Vec3 impulse() const {
    if (first_mass < std::numeric_limits<double>::infinity()) [[likely]]
      return first_mass * (after.first - before.first);
    return second_mass < std::numeric_limits<double>::infinity()
               ? second_mass * (before.second - after.second)
               : Vec3{};
  }
  /// How long the motions of both bodies had not changed [T].
  double flight() const { return duration(later(first_since, second_since), time); }
  /// The speed at which the surfaces met, along the normal [L/T]; not negative.
  double impact_speed() const {
    const double speed = dot(before.first - before.second, normal()) + growth;
    return speed > 0 ? speed : 0;
  }
  /// How far the surfaces overlapped by rounding, as a fraction of `reach` [1]; negative for a gap.
  double overlap() const {
    return 1 - (is_collision() ? length(separation) : dot(separation, normal())) / reach;
  }
};

/// What a response decides: the velocities and spins after a contact, and whether two spheres merge.
struct Outcome {
  /// An outcome with these velocities, in which spins stay as they are.
  Outcome(const Contact& contact, const Velocities& after) : velocities(after), spins(contact.spins_before) {}

  Velocities velocities;  ///< [L/T]
  Spins spins;            ///< [1/T]
  /// Whether the spheres merge, whatever the velocities and spins; at a wall they never do.
  bool merges = false;
};

/// What a contact does to motions. A response takes the contact with `after` still equal to `before`, and
/// returns the new velocities or the whole Outcome. Or it has `decide`, which sets the state after the
/// contact in the contact itself, which saves copies, and returns whether it may have changed spins.
/// Velocities returned for a wall or a kinematic sphere are ignored. The bodies must not approach each other
/// afterwards.
template <class R>
concept Response = requires(const R& response, const Contact& contact) {
  { response(contact) } -> std::convertible_to<Velocities>;
}
|| requires(const R& response, const Contact& contact) {
  { response(contact) } -> std::convertible_to<Outcome>;
}
|| requires(const R& response, Contact& contact) {
  { response.decide(contact) } -> std::same_as<bool>;
};

/// Applies a response to a contact, and returns whether it may have changed spins.
template <Response R>
bool decide(const R& response, Contact& contact) {
  if constexpr (requires { response.decide(contact); }) {
    return response.decide(contact);
  } else if constexpr (std::convertible_to<decltype(response(std::as_const(contact))), Velocities>) {
    contact.after = response(std::as_const(contact));
    return false;
  } else {
    const Outcome outcome = response(std::as_const(contact));
    contact.after = outcome.velocities;
    contact.spins_after = outcome.spins;
    contact.outcome =
        outcome.merges && contact.is_collision() ? ContactOutcome::merge : ContactOutcome::bounce;
    return true;
  }
}

/// The outcome of a response, for custom responses that are composed of others.
template <Response R>
Outcome outcome_of(const R& response, Contact contact) {
  decide(response, contact);
  Outcome outcome(contact, contact.after);
  outcome.spins = contact.spins_after;
  outcome.merges = contact.outcome == ContactOutcome::merge;
  return outcome;
}

}  // namespace hardball
