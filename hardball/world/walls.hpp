// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "hardball/errors/export.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Whether there is anything but spheres to be met: faces of the box, or surfaces.
HARDBALL_EXPORT bool has_walls(const Setting& setting);

/// Whether nothing but contacts of spheres and plain faces of the box, which all reflect alike, changes
/// motions: no gravity, no surface, no face with properties of its own. Then a fluid is the same everywhere.
HARDBALL_EXPORT bool is_uniform(const Setting& setting);

/// Whether solids, which are obstacles at rest and meshes, have images in a periodic box.
HARDBALL_EXPORT bool has_images_of_solids(const Setting& setting);

/// The next contact of a sphere with a face of the box, or with a surface that is no solid, where none has
/// come before `now`; an event that never happens if there is none.
HARDBALL_EXPORT Event next_wall_event(const World& world, Slot slot, const Time& now);

/// The next contact of a sphere on any path, of this base radius [L], with a face of the box, or with a
/// surface that is no solid, where none has come before `now`, as an event of sphere `id`; an event that
/// never happens if there is none.
HARDBALL_EXPORT Event next_wall_event(const Setting& setting, SphereId id, const Path& path, double radius,
                                      const Time& now);

/// The next contact of a sphere with a solid, or an image of one, where none has come before `now`. If there
/// is none before `until` [T], it is a later one or an event that never happens. Precondition: in a periodic
/// box, the sphere covers no more than a few boxes until then. Cost: O(log n), of n obstacles or triangles,
/// for each that it comes close to.
HARDBALL_EXPORT Event next_solid_event(const World& world, Slot slot, const Time& now, double until);

/// The next contact of a sphere on any path, of this base radius [L], with a solid, or an image of one, as an
/// event of sphere `id`. `until` and the precondition are those for a sphere of a world.
HARDBALL_EXPORT Event next_solid_event(const Setting& setting, SphereId id, const Path& path, double radius,
                                       const Time& now, double until);

/// How many groups the triangles of a surface have: one unless it is a mesh of several.
HARDBALL_EXPORT std::size_t group_count_of(const Surface& surface);

/// Where a sphere touches a mesh.
struct MeshTouch {
  Image image;                ///< The image of the mesh, in the coordinates of the path.
  std::uint32_t feature = 0;  ///< What it touches, see Mesh.
  Vec3 towards;               ///< From the center to the nearest point of the feature [L].
};

/// What the sphere of a wall event touches, if the surface is a mesh. Preconditions: it is; `path` is the
/// sphere's, of this base radius [L], and `moment` that of the event.
HARDBALL_EXPORT MeshTouch touch_of_mesh(const Setting& setting, std::uint32_t number, const Path& path,
                                        double radius, const Time& moment);

/// What may_meet_wall does for surfaces, and for faces of the box if there is gravity or growth.
HARDBALL_EXPORT bool may_meet_wall_of_any_kind(const World& world, Slot slot, double time, const Time& now);

/// Whether a sphere may meet a wall before `time`, from products instead of quotients: if not, the high part
/// of the time of next_wall_event is no less than `time`. Precondition: its path does not start later.
inline bool may_meet_wall(const World& world, Slot slot, double time, const Time& now) {
  if (!world.motion().is_straight() || world.motion().has_growth() || !world.other_surfaces().empty())
      [[unlikely]]
    return may_meet_wall_of_any_kind(world, slot, time, now);
  const Path& path = world.path(slot);
  const double radius = world.base_radius(slot);
  // More than the difference, the quotient and the product are rounded by.
  constexpr double kRounding = 1 + 0x1p-50;
  const double elapsed = (time - rounded_down(path.time)) * kRounding;
  bool may = false;
  for_each_axis([&](auto axis) {
    const double velocity = path.velocity[axis];
    const double below = path.position[axis] - radius;
    const double above = (world.box().size()[axis] - radius) - path.position[axis];
    const double way = std::fabs(velocity) * elapsed;
    may |= world.box().is_wall(axis) && (velocity > 0 ? above : below) <= way;
  });
  return may;
}

/// The contact of a sphere with an image of a mesh, in the coordinates of the path.
struct ImageContact {
  SurfaceContact contact;
  Image image;
};

/// The first contact of a sphere with a mesh, or an image of it, from `now` until another time [T], where
/// none has come before; if there is none until then, a later one or none.
HARDBALL_EXPORT ImageContact first_contact_with_mesh(const Box& box, const Motion& motion,
                                                     const Surface& mesh, const Path& path, double radius,
                                                     const Time& now, double until);

/// The distance from a point to a surface at `moment`, or to its nearest image [L]; negative beyond it.
HARDBALL_EXPORT double distance_to_surface(const Box& box, const Surface& surface, const Vec3& position,
                                           const Time& moment);

/// The distance from a point to the nearest surface at `moment`, or its nearest image [L]; negative beyond
/// it, and infinite if there are none.
HARDBALL_EXPORT double distance_to_surfaces(const Setting& setting, const Vec3& position, const Time& moment);

/// A distance from a point within which there is nothing of a solid or of an image of one [L]: at least three
/// quarters of the greatest, or `enough` [L] if that is less; not positive within an obstacle. Precondition:
/// solids rest. Cost: O(log n) of n obstacles or triangles.
HARDBALL_EXPORT double clearance_of_solids(const Setting& setting, const Vec3& position, double enough);

/// More than coordinates and distances near solids are rounded by [L].
HARDBALL_EXPORT double rounding_near_solids(const Setting& setting);

/// Whether a sphere of this radius [L] overlaps no surface: distance_to_surfaces is no less. Cost: O(log n)
/// for n obstacles.
HARDBALL_EXPORT bool is_clear_of_surfaces(const Setting& setting, const Vec3& position, double radius,
                                          const Time& moment);

/// The volume that spheres share: that of the box less the obstacles, or of the one hollow sphere, or tube or
/// cone along an axis of the box or between planes across its own, that encloses them [L^3]; infinite in open
/// space, NaN between other surfaces.
HARDBALL_EXPORT double accessible_volume(const Setting& setting);

/// The volume of the spheres at `moment` over the accessible volume [1]; NaN in unbounded space, and without
/// spheres.
HARDBALL_EXPORT double packing_fraction(const World& world, const Time& moment);
/// The volume of spheres [L^3], which the world need not have, over the accessible volume [1]; NaN in
/// unbounded space, and without spheres.
HARDBALL_EXPORT double packing_fraction(const Setting& setting, double sphere_volume);

/// The displacement of the image of a surface nearest to `position`, in a periodic box [L]; zero if the
/// surface has none, or is a mesh.
HARDBALL_EXPORT Vec3 nearest_image_of(const Box& box, const Surface& surface, const Vec3& position);

}  // namespace hardball
