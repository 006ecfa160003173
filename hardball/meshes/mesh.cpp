// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/meshes/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/double_double.hpp"
#include "hardball/geometry/nearest_point.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/meshes/mesh_repair.hpp"

namespace hardball {
namespace {

using Triangle = MeshParts::Triangle;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMostFeatures = std::size_t{1} << 30;
// The sine of the angle below which two triangles are one plane: contacts with the edge between them would
// tilt normals by no more.
constexpr double kFlat = 0x1p-40;

void refuse(const std::string& what, const char* remedy) {
  throw Error(what, "mesh", remedy);
}

void check_parts(const MeshParts& parts) {
  if (parts.triangles.empty()) refuse("a mesh has no triangles", "give one, or leave the mesh out");
  if (4 * parts.triangles.size() > kMostFeatures || parts.vertices.size() > kMostFeatures)
    refuse("a mesh has " + to_text(parts.triangles.size()) + " triangles", "give at most 2^28");
  for (const Vec3& vertex : parts.vertices) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) check_finite(vertex[axis], "coordinate", "mesh");
  }
  const auto check_index = [&](std::size_t triangle, std::uint32_t index, std::size_t count,
                               const char* name) {
    if (index < count) return;
    refuse("triangle " + to_text(triangle) + " of a mesh names the " + name + " " + to_text(index) + " of " +
               to_text(count),
           "count from zero");
  };
  for (std::size_t i = 0; i < parts.triangles.size(); ++i) {
    for (const std::uint32_t corner : parts.triangles[i])
      check_index(i, corner, parts.vertices.size(), "vertex");
  }
  if (parts.groups.empty()) return;
  if (parts.groups.size() != parts.triangles.size()) {
    refuse("a mesh has " + to_text(parts.triangles.size()) + " triangles and groups of " +
               to_text(parts.groups.size()),
           "give one for each triangle, or none");
  }
  for (std::size_t i = 0; i < parts.groups.size(); ++i)
    check_index(i, parts.groups[i], std::max<std::size_t>(1, parts.group_names.size()), "group");
}

double median_edge_of(const MeshParts& parts) {
  std::vector<double> lengths;
  lengths.reserve(3 * parts.triangles.size());
  for (const Triangle& corners : parts.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double edge = length(parts.vertices[corners[(k + 1) % 3]] - parts.vertices[corners[k]]);
      if (edge > 0) lengths.push_back(edge);
    }
  }
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

double largest_coordinate_of(const MeshParts& parts) {
  double largest = 0;
  for (const Vec3& vertex : parts.vertices)
    largest = std::max({largest, std::fabs(vertex.x), std::fabs(vertex.y), std::fabs(vertex.z)});
  return largest;
}

// A set whose elements are joined one by one.
class Partition {
 public:
  explicit Partition(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::uint32_t root(std::uint32_t element) {
    while (parent_[element] != element) element = parent_[element] = parent_[parent_[element]];
    return element;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace

Mesh::Mesh(MeshParts parts, double weld) : parts_(std::move(parts)) {
  check_parts(parts_);
  if (!(weld >= 0 && weld <= 0.5))
    refuse("vertices are welded within " + to_text(weld) + " of an edge", "give a fraction from 0 to 0.5");
  weld_equal_vertices(parts_, report_);
  if (weld > 0) {
    const double distance = weld * median_edge_of(parts_);
    if (distance > 0) weld_near_vertices(parts_, distance, report_);
  }
  remove_duplicates(parts_, report_);
  if (parts_.triangles.empty())
    refuse("the triangles of a mesh are points", "give triangles, or leave it out");
  // What single numbers, of which most files consist, are rounded by.
  constexpr double kSingleRounding = 0x1p-22;
  split_at_vertices(parts_,
                    std::max(weld * median_edge_of(parts_), kSingleRounding * largest_coordinate_of(parts_)),
                    report_);
  connect();
  count_defects();
  find_inner_edges();
  measure();
}

bool Mesh::restored() {
  check_parts(parts_);
  connect();
  const std::size_t flat = report_.flat_triangles;
  report_.flat_triangles = 0;
  count_defects();
  find_inner_edges();
  measure();
  return flat == report_.flat_triangles;
}

std::uint32_t Mesh::triangle_of(std::uint32_t feature) const {
  if (feature < triangles().size()) return feature;
  feature -= static_cast<std::uint32_t>(triangles().size());
  if (feature < edges_.size()) return triangles_at_edge(feature).front();
  feature -= static_cast<std::uint32_t>(edges_.size());
  std::uint32_t first = kNoEdge;
  for (const std::uint32_t edge : edges_at_vertex(feature))
    first = std::min(first, triangles_at_edge(edge).front());
  return first;
}

// Edges in the order of their ends, from lists of the sides of triangles by their lower ends.
void Mesh::connect() {
  struct Side {
    std::uint32_t high;
    std::uint32_t triangle;
    std::uint32_t place;
  };
  const std::size_t vertex_count = parts_.vertices.size();
  const auto for_each_side = [&](auto&& visit) {
    for (std::uint32_t i = 0; i < parts_.triangles.size(); ++i) {
      const Triangle& corners = parts_.triangles[i];
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = corners[k];
        const std::uint32_t b = corners[(k + 1) % 3];
        if (a != b) visit(std::min(a, b), Side{std::max(a, b), i, k});
      }
    }
  };
  std::vector<std::uint32_t> begins(vertex_count + 1);
  for_each_side([&](std::uint32_t low, const Side&) { ++begins[low + 1]; });
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  std::vector<Side> sides(begins.back());
  std::vector<std::uint32_t> ends(begins.begin(), begins.end() - 1);
  for_each_side([&](std::uint32_t low, const Side& side) { sides[ends[low]++] = side; });

  edges_.clear();
  triangle_edges_.assign(parts_.triangles.size(), {kNoEdge, kNoEdge, kNoEdge});
  edge_triangles_ = {};
  for (std::uint32_t low = 0; low < vertex_count; ++low) {
    const auto begin = sides.begin() + begins[low];
    const auto end = sides.begin() + begins[low + 1];
    std::sort(begin, end, [](const Side& a, const Side& b) {
      if (a.high != b.high) return a.high < b.high;
      return a.triangle != b.triangle ? a.triangle < b.triangle : a.place < b.place;
    });
    for (auto side = begin; side != end; ++side) {
      const bool is_new = side == begin || side->high != (side - 1)->high;
      if (is_new) {
        edge_triangles_.begins.push_back(static_cast<std::uint32_t>(edge_triangles_.entries.size()));
        edges_.push_back({low, side->high});
      }
      triangle_edges_[side->triangle][side->place] = static_cast<std::uint32_t>(edges_.size() - 1);
      // A segment has its edge twice.
      if (is_new || side->triangle != (side - 1)->triangle) edge_triangles_.entries.push_back(side->triangle);
    }
  }
  edge_triangles_.begins.push_back(static_cast<std::uint32_t>(edge_triangles_.entries.size()));
  parts_.vertices.shrink_to_fit();
  parts_.triangles.shrink_to_fit();
  edges_.shrink_to_fit();
  edge_triangles_.begins.shrink_to_fit();
  edge_triangles_.entries.shrink_to_fit();

  vertex_edges_ = {};
  vertex_edges_.begins.assign(vertex_count + 1, 0);
  for (const Edge& edge : edges_) {
    ++vertex_edges_.begins[edge.low + 1];
    ++vertex_edges_.begins[edge.high + 1];
  }
  std::partial_sum(vertex_edges_.begins.begin(), vertex_edges_.begins.end(), vertex_edges_.begins.begin());
  vertex_edges_.entries.resize(2 * edges_.size());
  ends.assign(vertex_edges_.begins.begin(), vertex_edges_.begins.end() - 1);
  for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
    vertex_edges_.entries[ends[edges_[edge].low]++] = edge;
    vertex_edges_.entries[ends[edges_[edge].high]++] = edge;
  }
}

void Mesh::count_defects() {
  is_flat_.assign(parts_.triangles.size(), false);
  for (std::size_t i = 0; i < parts_.triangles.size(); ++i) {
    const auto& [a, b, c] = parts_.triangles[i];
    const Vec3& corner = parts_.vertices[a];
    const Vec3 normal = cross(parts_.vertices[b] - corner, parts_.vertices[c] - corner);
    const double longest = std::max({length(parts_.vertices[b] - corner), length(parts_.vertices[c] - corner),
                                     length(parts_.vertices[c] - parts_.vertices[b])});
    // Narrower, a normal would be rounding.
    constexpr double kNarrowest = 0x1p-44;
    is_flat_[i] = !(length(normal) > kNarrowest * longest * longest);
    report_.flat_triangles += is_flat_[i] ? 1U : 0U;
  }
  report_.boundary_edges = report_.branching_edges = report_.flipped_edges = 0;
  has_even_edges_ = true;
  for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
    const std::span<const std::uint32_t> at_edge = triangles_at_edge(edge);
    report_.boundary_edges += at_edge.size() == 1 ? 1U : 0U;
    report_.branching_edges += at_edge.size() > 2 ? 1U : 0U;
    has_even_edges_ = has_even_edges_ && at_edge.size() % 2 == 0;
    if (at_edge.size() != 2) continue;
    const auto runs_up = [&](std::uint32_t triangle) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (triangle_edges_[triangle][k] == edge) return parts_.triangles[triangle][k] == edges_[edge].low;
      }
      return false;
    };
    report_.flipped_edges += runs_up(at_edge[0]) == runs_up(at_edge[1]) ? 1U : 0U;
  }
  Partition vertices(parts_.vertices.size());
  for (const Edge& edge : edges_) vertices.join(edge.low, edge.high);
  report_.components = 0;
  for (std::uint32_t vertex = 0; vertex < parts_.vertices.size(); ++vertex)
    report_.components += vertices.root(vertex) == vertex ? 1U : 0U;
}

void Mesh::find_inner_edges() {
  is_inner_.assign(edges_.size(), false);
  for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
    const std::span<const std::uint32_t> at_edge = triangles_at_edge(edge);
    if (at_edge.size() != 2 || is_flat_[at_edge[0]] || is_flat_[at_edge[1]]) continue;
    const Vec3& low = parts_.vertices[edges_[edge].low];
    const Vec3 along = parts_.vertices[edges_[edge].high] - low;
    // From the edge into each triangle, across the edge.
    const auto inward = [&](std::uint32_t triangle) {
      Vec3 farthest;
      for (const std::uint32_t corner : parts_.triangles[triangle]) {
        if (corner != edges_[edge].low && corner != edges_[edge].high)
          farthest = parts_.vertices[corner] - low;
      }
      return cross(cross(along, farthest), along);
    };
    const Vec3 one = inward(at_edge[0]);
    const Vec3 other = inward(at_edge[1]);
    is_inner_[edge] = dot(one, other) < 0 &&
                      length(cross(one, other)) < kFlat * std::sqrt(dot(one, one) * dot(other, other));
  }
}

void Mesh::measure() {
  extent_ = {parts_.vertices.front(), parts_.vertices.front()};
  for (const Vec3& vertex : parts_.vertices) extent_.enclose({vertex, vertex});
  largest_coordinate_ = largest_coordinate_of(parts_);
  median_edge_ = median_edge_of(parts_);
  std::vector<ExtentTree::Item> items;
  items.reserve(parts_.triangles.size());
  DoubleDouble<> six_volumes{0, 0};
  DoubleDouble<> two_areas{0, 0};
  // From a corner of the extent, so that little cancels.
  const Vec3& origin = extent_.low;
  for (std::uint32_t i = 0; i < parts_.triangles.size(); ++i) {
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = parts_.vertices[parts_.triangles[i][k]];
    Extent around{corners[0], corners[0]};
    around.enclose({corners[1], corners[1]});
    around.enclose({corners[2], corners[2]});
    items.push_back({around, i});
    using Precise = VectorOf<DoubleDouble<>>;
    const auto difference_of = [](const Vec3& a, const Vec3& b) {
      return Precise{difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z)};
    };
    const Precise normal =
        cross(difference_of(corners[1], corners[0]), difference_of(corners[2], corners[0]));
    six_volumes = six_volumes + dot(difference_of(corners[0], origin), normal);
    two_areas = two_areas + DoubleDouble<>{length({normal.x.high, normal.y.high, normal.z.high}), 0};
  }
  const bool encloses = is_closed() && report_.flipped_edges == 0;
  volume_ = encloses ? std::fabs(six_volumes.high) / 6 : kNaN;
  area_ = two_areas.high / 2;
  tree_ = ExtentTree(items);
}

double Mesh::clearance(const Vec3& point, double enough) const {
  constexpr double kPart = 0.8;
  double clear = enough;
  tree_.for_each_within(
      clear, [&](const FourExtents& extents) { return distance_to(extents, point); },
      [&](std::uint32_t triangle) {
        const auto& [a, b, c] = parts_.triangles[triangle];
        const Vec3 found =
            nearest_on_triangle(parts_.vertices[a], parts_.vertices[b], parts_.vertices[c], point);
        clear = std::min(clear, kPart * length(found - point));
      });
  return clear;
}

Mesh::NearestPoint Mesh::nearest(const Vec3& point) const {
  constexpr double kRoundedUp = 1 + 0x1p-40;
  NearestPoint nearest;
  double least = std::numeric_limits<double>::infinity();
  double farthest = least;
  tree_.for_each_within(
      farthest, [&](const FourExtents& extents) { return distance_to(extents, point); },
      [&](std::uint32_t triangle) {
        const auto& [a, b, c] = parts_.triangles[triangle];
        const Vec3 found =
            nearest_on_triangle(parts_.vertices[a], parts_.vertices[b], parts_.vertices[c], point);
        const double distance = length(found - point);
        if (!(distance < least) && !(distance == least && triangle < nearest.triangle)) return;
        nearest = {found, triangle};
        least = distance;
        farthest = kRoundedUp * least;
      });
  return nearest;
}

std::size_t Mesh::memory_bytes() const {
  const auto of = [](const auto& values) {
    return values.capacity() * sizeof(typename std::remove_cvref_t<decltype(values)>::value_type);
  };
  return of(parts_.vertices) + of(parts_.triangles) + of(parts_.groups) + of(edges_) + of(triangle_edges_) +
         of(edge_triangles_.begins) + of(edge_triangles_.entries) + of(vertex_edges_.begins) +
         of(vertex_edges_.entries) + (is_flat_.capacity() + is_inner_.capacity()) / 8 + tree_.memory_bytes();
}

}  // namespace hardball
