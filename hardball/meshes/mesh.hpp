// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/extent_tree.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// What a mesh is made of, as files have it: triangles that name their corners. A triangle that names one
/// corner twice is a segment.
struct MeshParts {
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<Vec3> vertices;         ///< [L]
  std::vector<Triangle> triangles;    ///< Indices of vertices, counterclockwise as seen from outside.
  std::vector<std::uint32_t> groups;  ///< Index of the group of each triangle; empty if all are in the first.
  std::vector<std::string> group_names;  ///< Empty if there is one group, without a name.
};

/// What was done to the parts of a mesh to make it, and how well it closes.
struct MeshReport {
  std::size_t welded_vertices = 0;      ///< Vertices where another one was.
  std::size_t duplicate_triangles = 0;  ///< Triangles that had the corners of another one; they are left out.
  std::size_t flat_triangles = 0;       ///< Triangles without an area: only their edges can be touched.
  std::size_t split_triangles = 0;      ///< Triangles split where a vertex lay on one of their edges.
  std::size_t boundary_edges = 0;       ///< Edges of one triangle.
  std::size_t branching_edges = 0;      ///< Edges of more than two triangles.
  std::size_t flipped_edges = 0;        ///< Edges of two triangles of which one is inside out.
  std::size_t components = 0;           ///< Parts that have no vertex in common.

  static void persist(auto& archive, auto& self) {
    archive(self.welded_vertices, self.duplicate_triangles, self.flat_triangles, self.split_triangles,
            self.boundary_edges, self.branching_edges, self.flipped_edges, self.components);
  }
};

/// A surface of triangles, which spheres touch from both sides, with everything that questions about it need:
/// which triangles meet at an edge, which edges at a vertex, and a tree that finds triangles near a point.
///
/// Its *features* are what can be touched: faces, edges and vertices, each once however many triangles share
/// it. They have one numbering: faces in the order of the triangles, then edges by the lower and the higher
/// number of their vertices, then vertices.
class HARDBALL_EXPORT Mesh {
 public:
  using Triangle = MeshParts::Triangle;

  /// An edge, from the vertex with the lower number to that with the higher.
  struct Edge {
    std::uint32_t low;
    std::uint32_t high;
  };

  /// Vertices in the same place become one; with `weld` [1], so do those that are closer than this fraction
  /// of the median length of the edges, each at the place of the first. Triangles are split where a vertex
  /// lies on an edge that belongs to them alone. Error, with the triangle: there is none; a coordinate that
  /// is not finite or out of range; an index or a group that does not exist; more than 2^30 features; `weld`
  /// is not between 0 and 0.5. Cost: O(n log n).
  explicit Mesh(MeshParts parts, double weld = 0);

  std::span<const Vec3> vertices() const { return parts_.vertices; }
  std::span<const Triangle> triangles() const { return parts_.triangles; }
  std::span<const Edge> edges() const { return edges_; }
  std::span<const std::string> group_names() const { return parts_.group_names; }
  /// The index of the group of a triangle.
  std::uint32_t group(std::uint32_t triangle) const {
    return parts_.groups.empty() ? 0 : parts_.groups[triangle];
  }
  std::size_t group_count() const { return parts_.group_names.empty() ? 1 : parts_.group_names.size(); }
  const MeshReport& report() const { return report_; }

  /// How many faces, edges and vertices there are, however flat.
  std::size_t feature_count() const { return triangles().size() + edges_.size() + vertices().size(); }
  /// The triangle to which a feature belongs: the first of an edge or of a vertex.
  std::uint32_t triangle_of(std::uint32_t feature) const;
  /// Whether a triangle has an area: one without has edges only.
  bool has_area(std::uint32_t triangle) const { return !is_flat_[triangle]; }
  /// Whether an edge lies within a plane of two triangles: nothing can touch it before them.
  bool is_inner(std::uint32_t edge) const { return is_inner_[edge]; }
  /// The edges of a triangle: from its first corner to its second, from there to its third, and back; one
  /// that joins a corner to itself is kNoEdge.
  const std::array<std::uint32_t, 3>& edges_of(std::uint32_t triangle) const {
    return triangle_edges_[triangle];
  }
  static constexpr std::uint32_t kNoEdge = 0xffffffff;
  /// The triangles that meet at an edge, in order.
  std::span<const std::uint32_t> triangles_at_edge(std::uint32_t edge) const {
    return edge_triangles_.of(edge);
  }
  /// The edges that meet at a vertex, in order.
  std::span<const std::uint32_t> edges_at_vertex(std::uint32_t vertex) const {
    return vertex_edges_.of(vertex);
  }

  /// Whether it encloses space: each edge belongs to two triangles, or to an even number.
  bool is_closed() const { return report_.boundary_edges == 0 && has_even_edges_; }
  /// The volume enclosed [L^3], exact but for rounding once; positive whichever way the triangles are turned;
  /// NaN if the mesh is not closed or some triangles are inside out.
  double volume() const { return volume_; }
  /// The area of one side of all triangles [L^2].
  double area() const { return area_; }
  /// The extent of all vertices [L].
  const Extent& extent() const { return extent_; }
  /// The largest magnitude of a coordinate [L].
  double largest_coordinate() const { return largest_coordinate_; }
  /// The median length of the edges [L].
  double median_edge() const { return median_edge_; }
  /// The triangles, by their numbers.
  const ExtentTree& tree() const { return tree_; }

  /// Whether a point is inside, decided by exact signs. Precondition: is_closed(). Cost: O(log n) on average.
  bool contains(const Vec3& point) const;
  /// How often the mesh winds around a point [1]: 1 inside and 0 outside one that is closed and turned
  /// outward, a fraction where there are holes. Cost: O(n). Source: Jacobson, Kavan and Sorkine-Hornung, ACM
  /// Trans. Graph. 32 (2013) 33.
  double winding_number(const Vec3& point) const;
  /// A point of the mesh [L], and the triangle that it belongs to.
  struct NearestPoint {
    Vec3 point;
    std::uint32_t triangle = 0;
  };
  /// The point of the mesh nearest to another [L]; of several triangles, the first. Cost: O(log n) on
  /// average.
  NearestPoint nearest(const Vec3& point) const;
  /// A distance within which there is nothing of the mesh [L]: at least three quarters of the greatest, or
  /// `enough` [L] if that is less. Cost: O(log n), a fraction of that of nearest().
  double clearance(const Vec3& point, double enough) const;

  std::size_t memory_bytes() const;

 private:
  friend class Persistence;
  Mesh() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.parts_.vertices, self.parts_.triangles, self.parts_.groups, self.parts_.group_names,
            self.report_);
  }
  bool restored();

  // Lists of numbers, one after another.
  struct Lists {
    std::vector<std::uint32_t> begins;
    std::vector<std::uint32_t> entries;

    std::span<const std::uint32_t> of(std::uint32_t list) const {
      return std::span(entries).subspan(begins[list], begins[list + 1] - begins[list]);
    }
  };

  void connect();
  void find_inner_edges();
  void count_defects();
  void measure();

  MeshParts parts_;
  MeshReport report_;
  std::vector<Edge> edges_;
  std::vector<std::array<std::uint32_t, 3>> triangle_edges_;
  Lists edge_triangles_;
  Lists vertex_edges_;
  std::vector<bool> is_flat_;
  std::vector<bool> is_inner_;
  bool has_even_edges_ = true;
  double volume_ = 0;
  double area_ = 0;
  double median_edge_ = 0;
  double largest_coordinate_ = 0;
  Extent extent_;
  ExtentTree tree_;
};

}  // namespace hardball
