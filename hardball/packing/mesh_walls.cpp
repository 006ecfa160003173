// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/mesh_walls.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "hardball/geometry/extent.hpp"
#include "hardball/geometry/nearest_point.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/box.hpp"

namespace hardball {
namespace {

// By how much cones are wider, as a fraction of the distance, and how far apart points count as two: more
// than rounding leaves between cones, and less than any gap that counts as a contact.
constexpr double kSlack = 0x1p-32;
constexpr double kDistinct = 0x1p-28;

using FineVector = std::array<Fine, kAxes>;

FineVector fine_difference(const Vec3& a, const Vec3& b) {
  return {difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z)};
}

FineVector fine_cross(const FineVector& a, const FineVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Whether a vector leads no farther than `slack` along a direction of any length.
bool is_behind(const Vec3& vector, const Vec3& direction, double slack) {
  return dot(vector, direction) <= slack * length(direction);
}

// What is near a point: of each feature, whether the point is in its normal cone, and how far away it is.
class Surroundings {
 public:
  Surroundings(const Mesh& mesh, const Vec3& center, double slack)
      : mesh_(mesh), center_(center), slack_(slack) {}

  std::optional<NearWall> face(std::uint32_t triangle) const {
    if (!mesh_.has_area(triangle)) return {};
    const auto& [a, b, c] = corners(triangle);
    const Vec3 normal = cross(b - a, c - a);
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      if (!is_behind(center_ - from, cross(to - from, normal), slack_)) return {};
    const FineVector across = fine_cross(fine_difference(b, a), fine_difference(c, a));
    const FineVector from_a = fine_difference(center_, a);
    Fine height = sum_of_three(from_a[0] * across[0], from_a[1] * across[1], from_a[2] * across[2]);
    if (height.high < 0) height = -height;
    const double square = dot(normal, normal);
    return NearWall{triangle, (-dot(center_ - a, normal) / square) * normal,
                    quotient(height, length_of(across))};
  }

  std::optional<NearWall> edge(std::uint32_t edge) const {
    if (mesh_.is_inner(edge)) return {};
    const Vec3& low = vertex_at(mesh_.edges()[edge].low);
    const Vec3& high = vertex_at(mesh_.edges()[edge].high);
    const Vec3 along = high - low;
    if (!is_behind(low - center_, along, slack_) || !is_behind(center_ - high, along, slack_)) return {};
    for (const std::uint32_t triangle : mesh_.triangles_at_edge(edge)) {
      if (!mesh_.has_area(triangle)) continue;
      if (!is_behind(center_ - low, into(triangle, low, high), slack_)) return {};
    }
    const FineVector direction = fine_difference(high, low);
    const Fine area = length_of(fine_cross(fine_difference(center_, low), direction));
    return NearWall{static_cast<std::uint32_t>(mesh_.triangles().size()) + edge,
                    nearest_on_segment(low, high, center_) - center_, quotient(area, length_of(direction))};
  }

  std::optional<NearWall> vertex(std::uint32_t vertex) const {
    const Vec3& place = vertex_at(vertex);
    for (const std::uint32_t edge : mesh_.edges_at_vertex(vertex)) {
      const auto& [low, high] = mesh_.edges()[edge];
      if (!is_behind(center_ - place, vertex_at(low == vertex ? high : low) - place, slack_)) return {};
    }
    const std::size_t before = mesh_.triangles().size() + mesh_.edges().size();
    return NearWall{static_cast<std::uint32_t>(before) + vertex, place - center_,
                    length_of(fine_difference(place, center_))};
  }

 private:
  const Vec3& vertex_at(std::uint32_t vertex) const { return mesh_.vertices()[vertex]; }
  std::array<Vec3, 3> corners(std::uint32_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles()[triangle];
    return {vertex_at(a), vertex_at(b), vertex_at(c)};
  }
  // From a side of a triangle into it, across that side.
  Vec3 into(std::uint32_t triangle, const Vec3& low, const Vec3& high) const {
    const Vec3 along = high - low;
    for (const Vec3& corner : corners(triangle)) {
      if (corner == low || corner == high) continue;
      const Vec3 from = corner - low;
      return from - (dot(from, along) / dot(along, along)) * along;
    }
    return {};
  }

  const Mesh& mesh_;
  Vec3 center_;
  double slack_;
};

}  // namespace

MeshWalls::MeshWalls(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)) {
  flat_parts_.resize(mesh_->triangles().size());
  std::iota(flat_parts_.begin(), flat_parts_.end(), 0U);
  const auto first_of = [this](std::uint32_t triangle) {
    while (flat_parts_[triangle] != triangle)
      triangle = flat_parts_[triangle] = flat_parts_[flat_parts_[triangle]];
    return triangle;
  };
  for (std::uint32_t edge = 0; edge < mesh_->edges().size(); ++edge) {
    if (!mesh_->is_inner(edge)) continue;
    const std::span<const std::uint32_t> triangles = mesh_->triangles_at_edge(edge);
    const std::uint32_t one = first_of(triangles.front());
    const std::uint32_t other = first_of(triangles.back());
    flat_parts_[std::max(one, other)] = std::min(one, other);
  }
  for (std::uint32_t triangle = 0; triangle < flat_parts_.size(); ++triangle)
    flat_parts_[triangle] = first_of(triangle);
}

std::uint32_t MeshWalls::number(std::uint32_t feature) const {
  return kFaces + (feature < flat_parts_.size() ? flat_parts_[feature] : feature);
}

void MeshWalls::for_each_near(const Vec3& center, double within,
                              const Function<void(const NearWall&)>& visit) const {
  const Surroundings near(*mesh_, center, kSlack * within);
  std::vector<NearWall> walls;
  const auto note = [&](std::optional<NearWall> wall) {
    if (!wall || wall->distance.high > within) return;
    wall->number = number(wall->number);
    walls.push_back(*wall);
  };
  std::vector<std::uint32_t> edges;
  std::vector<std::uint32_t> vertices;
  mesh_->tree().for_each_within(
      within, [&](const FourExtents& extents) { return distance_to(extents, center); },
      [&](std::uint32_t triangle) {
        note(near.face(triangle));
        for (const std::uint32_t edge : mesh_->edges_of(triangle))
          if (edge != Mesh::kNoEdge) edges.push_back(edge);
        for (const std::uint32_t vertex : mesh_->triangles()[triangle]) vertices.push_back(vertex);
      });
  for (auto* features : {&edges, &vertices}) {
    ranges::sort(*features);
    features->erase(std::unique(features->begin(), features->end()), features->end());
  }
  for (const std::uint32_t edge : edges) note(near.edge(edge));
  for (const std::uint32_t vertex : vertices) note(near.vertex(vertex));
  ranges::stable_sort(walls, {}, &NearWall::number);
  std::vector<NearWall> apart;
  for (const NearWall& wall : walls) {
    const auto same = ranges::find_if(apart, [&](const NearWall& other) {
      return length(other.separation - wall.separation) < kDistinct * within;
    });
    if (same == apart.end()) {
      apart.push_back(wall);
    } else if ((wall.distance - same->distance).high < 0) {
      same->distance = wall.distance;
    }
  }
  for (const NearWall& wall : apart) visit(wall);
}

}  // namespace hardball
