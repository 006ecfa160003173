// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/extent.hpp"
#include "hardball/geometry/rotation_matrix.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// What a robot may touch: spheres, boxes, capsules, triangles and half-spaces. All are convex; only spheres
/// move.
///
/// Obstacles are numbered in the order in which they are added; a mesh is one obstacle.
class HARDBALL_EXPORT Obstacles {
 public:
  /// Each of these adds obstacles and returns the number of the first. Error: a number that is not finite; a
  /// length that must be positive and is not. Cost: O(log^2 n) amortized.
  ///
  /// A sphere, the center of which is at `center` [L] at a time, and moves with a constant velocity [L/T].
  std::size_t add_sphere(const Vec3& center, double radius, const Vec3& velocity = {}, double time = 0);
  /// A box around `center` with edges of these lengths [L], turned about its center. Error: as for a sphere;
  /// a rotation that is none.
  std::size_t add_box(const Vec3& center, const Vec3& size, const RotationMatrix& rotation = {});
  /// All points within a radius of the segment between two points [L]. Error: as for a sphere.
  std::size_t add_capsule(const Vec3& begin, const Vec3& end, double radius);
  /// A half-space: the side of the plane through a point [L] that its normal, of any length, points away
  /// from. Error: as for a sphere; a normal of length zero.
  std::size_t add_plane(const Vec3& point, const Vec3& normal);
  /// A surface of triangles, by the numbers of their vertices [L], which is touched from both sides. All
  /// points within `thickness` [L] belong to it. Error: as for a sphere; a vertex that does not exist; a
  /// negative thickness; no triangles.
  std::size_t add_mesh(std::span<const Vec3> vertices,
                       std::span<const std::array<std::uint32_t, 3>> triangles, double thickness = 0);
  /// Everything in a world from `now` on, as if nothing collided: its spheres, in the order of ids, then the
  /// walls of its box, by the number of the face, and its surfaces. Error: a box that is periodic; gravity or
  /// growth; surfaces that are neither planes, meshes nor obstacles; planes or meshes that move.
  std::size_t add_world(const World& world, const Time& now);

  /// The number of obstacles.
  std::size_t size() const { return count_; }

  /// A convex shape with no size of its own, and all points within a radius of it.
  struct Ball {
    Vec3 center;
    double radius = 0;
    Vec3 velocity;
    double time = 0;  ///< At which it is at its center [T].
  };
  struct Box {
    Vec3 center;
    Vec3 half;
    RotationMatrix rotation;
  };
  struct Capsule {
    Vec3 begin;
    Vec3 end;
    double radius = 0;
  };
  struct HalfSpace {
    Vec3 point;
    Vec3 normal;
  };
  struct Triangle {
    Vec3 a;
    Vec3 b;
    Vec3 c;
    double thickness = 0;
  };
  using Shape = std::variant<Ball, Box, Capsule, HalfSpace, Triangle>;
  /// A shape, and the obstacle that it is a part of.
  struct Item {
    Shape shape;
    std::uint32_t obstacle = 0;
  };
  /// A node of a tree of boxes, the left child of which follows it.
  struct Node {
    Extent extent;     ///< At the reference time [L].
    double speed = 0;  ///< With which parts of it may leave the extent [L/T].
    double size = 0;   ///< Half of the diagonal [L].
    std::uint32_t right_or_item = 0;
    bool is_leaf = false;
  };
  const Item& item(std::size_t number) const { return items_[number]; }
  const Node& node(std::size_t number) const { return nodes_[number]; }
  /// The nodes that no others contain.
  std::vector<std::uint32_t> roots() const;
  /// The items that have no finite extent.
  std::span<const std::uint32_t> unbounded() const { return unbounded_; }
  /// The time of the extents [T].
  double reference_time() const { return reference_time_; }

 private:
  struct Tree {
    std::size_t first_order = 0;
    std::size_t first_node = 0;
  };

  std::size_t add(const Shape& shape, const char* where);
  void insert(const Shape& shape, std::size_t obstacle);
  void grow_trees(std::size_t first_order);
  void build(std::size_t begin, std::size_t end);
  Extent extent_of(std::uint32_t item) const;
  void add_walls(const World& world, const char* where);
  void add_surface(const Surface& surface, const char* where);

  std::vector<Item> items_;
  std::vector<std::uint32_t> unbounded_;
  std::vector<std::uint32_t> order_;  // bounded items, as the leaves of the trees have them
  std::vector<Tree> trees_;
  std::vector<Node> nodes_;
  std::size_t count_ = 0;
  double reference_time_ = 0;
  bool has_moving_ = false;
};

/// How near a point is to a shape.
struct NearestOfShape {
  double distance = 0;  ///< From the surface; negative within [L].
  Vec3 normal;  ///< The unit vector from the nearest point of the surface [1]; zero where it is not known.
};

/// The nearest point of a shape, at `time` if it moves. Within a box, a capsule or a mesh, the distance is
/// that from the box, from the axis or from the triangle less the radius. Cost: O(1).
NearestOfShape nearest_of(const Obstacles::Shape& shape, const Vec3& point, double time);

}  // namespace hardball
