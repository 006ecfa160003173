// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "hardball/describe/names.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/geometry/extent.hpp"
#include "hardball/meshes/mesh.hpp"
#include "hardball/surfaces/passage.hpp"
#include "hardball/surfaces/surface_material.hpp"

namespace hardball {

/// Where spheres are that a mesh confines.
enum class MeshSide : std::uint8_t {
  both,     ///< Anywhere.
  inside,   ///< In what the mesh encloses.
  outside,  ///< Around what the mesh encloses.
};
template <>
inline constexpr std::array<std::string_view, 3> kNames<MeshSide>{"both", "inside", "outside"};

/// When a sphere touches a mesh, and with which feature of it (see Mesh).
struct MeshContact {
  double wait = std::numeric_limits<double>::infinity();  ///< After the start of the passage [T].
  std::uint32_t feature = 0;

  bool happens() const { return wait < std::numeric_limits<double>::infinity(); }
};

/// A mesh that spheres touch from both sides.
///
/// A sphere touches a feature only where its center is in the feature's normal cone: above a face, beside an
/// edge beyond all faces that meet there, off a vertex beyond all edges. Cones of neighbors have only borders
/// in common, so that no sphere touches what is hidden behind a surface, and a sphere that crosses a border
/// while it touches and approaches what lies beyond touches that there. Cost of a question: O(log n) of n
/// triangles, and for each triangle within reach.
class HARDBALL_EXPORT MeshShape {
 public:
  static constexpr std::string_view kName = "mesh";
  static constexpr auto fields() { return std::tuple<>(); }
  /// The least radius of spheres, thickness included, as a fraction of the mesh's largest coordinate [1].
  static constexpr double kSmallestReach = 0x1p-30;

  /// `thickness` [L] is added to the radius of every sphere: a segment becomes a capsule, a triangle a plate
  /// with round edges. Error: spheres are inside or outside of what is not closed; a thickness that is
  /// negative or not finite; no mesh.
  explicit MeshShape(std::shared_ptr<const Mesh> mesh, MeshSide spheres = MeshSide::both,
                     double thickness = 0);

  const Mesh& mesh() const { return *mesh_; }
  const std::shared_ptr<const Mesh>& shared_mesh() const { return mesh_; }
  MeshSide spheres() const { return spheres_; }
  double thickness() const { return thickness_; }

  /// Gives the triangles of a group, and the edges and vertices that belong to them, a material of their own.
  /// Error: no such group; the material, see check_material.
  void set_group_material(std::string_view group, const SurfaceMaterial& material);
  /// Gives the random numbers of all groups that are thermal walls this seed.
  void set_seed(std::uint64_t seed) {
    for (auto& [group, material] : materials_) material.seed = seed;
  }
  /// The material of a feature; null if its group has none of its own.
  const SurfaceMaterial* material_of(std::uint32_t feature) const;
  /// The groups that have one, by their indices.
  const std::vector<std::pair<std::uint32_t, SurfaceMaterial>>& group_materials() const { return materials_; }

  /// The first contact of a sphere that there is not before `begin`; if there is none until `end` [T], a
  /// later one or none. Both count from the start of the passage. What it says of a contact depends on the
  /// passage alone.
  MeshContact first_contact(const Passage& passage, double begin, double end) const;
  /// When a sphere first touches the mesh while they approach, at the start of a passage or later.
  Time contact_time(const Passage& passage) const {
    return after(passage.start, first_contact(passage, 0, std::numeric_limits<double>::infinity()).wait);
  }
  /// How fast the gap to a feature opens at the start of a passage; only the sign matters.
  DoubleDouble<> opening_speed(const Passage& passage, std::uint32_t feature) const;
  /// The vector from the center of a sphere to the nearest point of a feature, `wait` after the start of a
  /// passage [L]. Precondition: the sphere is in the feature's cone.
  Vec3 towards(const Passage& passage, double wait, std::uint32_t feature) const;

  /// The distance from a point to the surface [L]; negative on the side where spheres are not.
  double distance(const Vec3& position) const;
  /// A vector of any length from a point toward the surface.
  Vec3 towards(const Vec3& position) const { return mesh_->nearest(position).point - position; }
  /// Where spheres may be along the axes of a box [L].
  Extent room() const { return spheres_ == MeshSide::inside ? mesh_->extent() : Extent(); }
  /// Null: it has images.
  static const char* remedy_for_period(std::size_t) { return nullptr; }
  /// The volume within, if spheres are inside [L^3]; NaN if that is not known.
  double volume(const auto& /*box*/, const Vec3&) const {
    return spheres_ == MeshSide::inside && thickness_ == 0 ? mesh_->volume()
                                                           : std::numeric_limits<double>::quiet_NaN();
  }
  /// The volume that it takes from spheres on the outside or on both sides [L^3]: zero if it is an open
  /// sheet; NaN if that is not known.
  double displaced_volume() const;
  /// The area of one side [L^2].
  double area(const auto& /*box*/) const { return mesh_->area(); }

 private:
  friend class Persistence;
  MeshShape() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.mesh_, self.spheres_, self.thickness_, self.materials_);
    archive.require(self.spheres_ <= MeshSide::outside);
  }

  std::shared_ptr<const Mesh> mesh_;
  MeshSide spheres_ = MeshSide::both;
  double thickness_ = 0;
  std::vector<std::pair<std::uint32_t, SurfaceMaterial>> materials_;
};

}  // namespace hardball
