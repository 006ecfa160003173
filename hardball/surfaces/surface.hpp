// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/motion.hpp"
#include "hardball/surfaces/cone.hpp"
#include "hardball/surfaces/cylinder.hpp"
#include "hardball/surfaces/hollow_sphere.hpp"
#include "hardball/surfaces/mesh_shape.hpp"
#include "hardball/surfaces/obstacle.hpp"
#include "hardball/surfaces/oscillating_plane.hpp"
#include "hardball/surfaces/own_shape.hpp"
#include "hardball/surfaces/pillar.hpp"
#include "hardball/surfaces/plane.hpp"
#include "hardball/surfaces/surface_material.hpp"

namespace hardball {

/// The shapes of surfaces, each in a file of its own: what describes it, where a sphere touches it, which way
/// it lies, and what it encloses.
///
/// A shape has `kName`, `kMeaning` and `fields()`; `kPoint`, what its point is, if it is a wall;
/// `gap(passage)`, a polynomial that is positive while a sphere does not touch it, or `contact_time(passage)`
/// and `opening_speed(passage)`, of a mesh with the feature that is touched; `distance(position)` and
/// `towards(position)`; `room()` and `remedy_for_period(axis)`; where they are known, `largest_sphere()`,
/// `volume(box, point)` and `area(box)`; and if it moves by itself, `rest()`, `displacement_at(moment)` and
/// `velocity_at(moment)`. Positions are relative to the surface's point.
using Shape = std::variant<Plane, OscillatingPlane, Cylinder, HollowSphere, Obstacle, Cone, OwnShape,
                           MeshShape, Pillar>;

/// A plane that oscillates along its normal, with this amplitude [L] and frequency [1/T]; the plane itself if
/// both are zero. Error: it is not a plane.
HARDBALL_EXPORT Shape oscillating(const Shape& plane, double amplitude, double frequency);

/// When a sphere touches a surface, and with which feature of a mesh (see Mesh); zero of other shapes.
struct SurfaceContact {
  Time time = kNever;
  std::uint32_t feature = 0;
};

/// A wall or an obstacle that spheres bounce off: at rest, in uniform motion, or oscillating.
class HARDBALL_EXPORT Surface {
 public:
  /// `point` [L]: of the plane, on the axis, or the center, at time zero; `velocity` [L/T]: of the whole
  /// surface. Error: a number out of range; a direction that is not a unit vector.
  Surface(const Shape& shape, const Vec3& point, const Vec3& velocity = {},
          const SurfaceMaterial& material = {});
  /// This surface as it moves from `moment` on: its point is at `point` [L] then, and has this velocity
  /// [L/T]. Error: a number is not finite.
  Surface moved(const Time& moment, const Vec3& point, const Vec3& velocity) const;

  const Shape& shape() const { return shape_; }
  const Vec3& point() const { return point_; }
  const Vec3& velocity() const { return velocity_; }
  /// When the surface is at its point: zero, or the moment from which it has moved so.
  const Time& since() const { return since_; }
  const SurfaceMaterial& material() const { return material_; }
  /// The material of a feature, which a group of the triangles of a mesh may have for itself.
  const SurfaceMaterial& material_of(std::uint32_t feature) const;
  /// The shape, if the surface is a mesh; null if not.
  const MeshShape* mesh() const { return std::get_if<MeshShape>(&shape_); }
  std::string_view name() const;
  /// The shape, of one that oscillates that at rest, for the words by which it is described.
  Shape shape_at_rest() const;
  /// The normal of a plane, toward the spheres; null for other shapes.
  const Vec3* normal() const;
  /// Where spheres may be along the axes of a box, at time zero or while it oscillates [L].
  Extent room() const;
  /// The radius of the largest sphere within [L]; infinite if there is none.
  double largest_sphere() const;
  /// This surface at rest, where it is at `moment`.
  Surface at_rest(const Time& moment) const;

  /// When a sphere on `path` of this base radius first touches the surface while they approach, at the start
  /// of the path, of the epoch of its growth or of the surface's motion, or later; kNever if it never does. A
  /// function of these alone.
  Time contact_time(const Motion& motion, const Path& path, double radius) const;
  /// The first contact with a mesh from `now` until another time [T], where none has come before; if there is
  /// none until then, a later one or none. Precondition: mesh().
  SurfaceContact first_contact(const Motion& motion, const Path& path, double radius, const Time& now,
                               double until) const;
  /// The vector from the center of a sphere on `path` to a feature of a mesh that it touches at `moment` [L].
  /// Precondition: mesh().
  Vec3 towards_feature(const Motion& motion, const Path& path, double radius, const Time& moment,
                       std::uint32_t feature) const;
  /// Whether a sphere at that start approaches the surface, or the feature of a mesh: if not, and if
  /// it touches it, it does so again only later.
  bool is_approached(const Motion& motion, const Path& path, double radius, std::uint32_t feature = 0) const;
  /// A time before which a sphere on `path` does not touch the surface [T], from where it is at `now`.
  double free_until(const Motion& motion, const Path& path, double radius, const Time& now) const;

  /// The distance of a point from the surface at `moment` [L]; negative beyond it.
  double distance(const Vec3& position, const Time& moment) const;
  /// The unit vector from a point toward the surface at `moment` [1].
  Vec3 direction(const Vec3& position, const Time& moment) const;
  /// The velocity of the surface at `moment` [L/T].
  Vec3 velocity_at(const Time& moment) const;

 private:
  friend class Persistence;
  Surface() : shape_(HollowSphere(0)) {}
  static void persist(auto& archive, auto& self) {
    archive(self.shape_, self.point_, self.velocity_, self.material_);
    if (archive.version() >= kSinceVersion) archive(self.since_);
  }
  bool restored() {
    *this = Surface(shape_, point_, velocity_, material_).moved(since_, point_, velocity_);
    return true;
  }
  static constexpr std::uint32_t kSinceVersion = 15;  // of archives that have since_

  Passage passage_of(const Motion& motion, const Path& path, double radius) const;
  Vec3 path_until(const Time& moment) const;
  Vec3 relative_position(const Vec3& position, const Time& moment) const;

  Shape shape_;
  Vec3 point_;
  Vec3 velocity_;
  SurfaceMaterial material_;
  Time since_;
};

}  // namespace hardball
