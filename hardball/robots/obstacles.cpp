// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/robots/obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/nearest_point.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/surfaces/surface.hpp"

namespace hardball {
namespace {

constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max() / 2;

void check_vector(const Vec3& vector, const char* name, const char* where) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) check_finite(vector[axis], name, where);
}

Extent around(const Vec3& center, const Vec3& half) {
  return {center - half, center + half};
}

Extent united(const Extent& a, const Extent& b) {
  Extent both;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    both.low[axis] = std::min(a.low[axis], b.low[axis]);
    both.high[axis] = std::max(a.high[axis], b.high[axis]);
  }
  return both;
}

Extent of_points(const Vec3& a, const Vec3& b) {
  return united({a, a}, {b, b});
}

NearestOfShape from(const Vec3& nearest, const Vec3& point, double radius) {
  const Vec3 apart = point - nearest;
  const double distance = length(apart);
  return {distance - radius, distance > 0 ? (1 / distance) * apart : Vec3{}};
}

struct NearestVisitor {
  const Vec3& point;
  double time;

  NearestOfShape operator()(const Obstacles::Ball& ball) const {
    return from(ball.center + (time - ball.time) * ball.velocity, point, ball.radius);
  }
  NearestOfShape operator()(const Obstacles::Box& box) const {
    const Vec3 local = box.rotation.turned_back(point - box.center);
    const NearestOfShape found = from(nearest_in_box(-box.half, box.half, local), local, 0);
    return {found.distance, box.rotation.turned(found.normal)};
  }
  NearestOfShape operator()(const Obstacles::Capsule& capsule) const {
    return from(nearest_on_segment(capsule.begin, capsule.end, point), point, capsule.radius);
  }
  NearestOfShape operator()(const Obstacles::HalfSpace& space) const {
    return {dot(point - space.point, space.normal), space.normal};
  }
  NearestOfShape operator()(const Obstacles::Triangle& triangle) const {
    return from(nearest_on_triangle(triangle.a, triangle.b, triangle.c, point), point, triangle.thickness);
  }
};

}  // namespace

NearestOfShape nearest_of(const Obstacles::Shape& shape, const Vec3& point, double time) {
  return std::visit(NearestVisitor{point, time}, shape);
}

std::size_t Obstacles::add_sphere(const Vec3& center, double radius, const Vec3& velocity, double time) {
  constexpr const char* kWhere = "Obstacles::add_sphere";
  check_vector(center, "the center", kWhere);
  check_positive(radius, "the radius", kWhere);
  check_vector(velocity, "the velocity", kWhere);
  check_finite(time, "the time", kWhere);
  return add(Ball{center, radius, velocity, time}, kWhere);
}

std::size_t Obstacles::add_box(const Vec3& center, const Vec3& size, const RotationMatrix& rotation) {
  constexpr const char* kWhere = "Obstacles::add_box";
  check_vector(center, "the center", kWhere);
  for (std::size_t axis = 0; axis < kAxes; ++axis) check_positive(size[axis], "an edge", kWhere);
  if (!rotation.is_sound())
    throw Error("the rotation is none", kWhere, "give three unit vectors at right angles, right-handed");
  return add(Box{center, 0.5 * size, rotation}, kWhere);
}

std::size_t Obstacles::add_capsule(const Vec3& begin, const Vec3& end, double radius) {
  constexpr const char* kWhere = "Obstacles::add_capsule";
  check_vector(begin, "an end", kWhere);
  check_vector(end, "an end", kWhere);
  check_positive(radius, "the radius", kWhere);
  return add(Capsule{begin, end, radius}, kWhere);
}

std::size_t Obstacles::add_plane(const Vec3& point, const Vec3& normal) {
  constexpr const char* kWhere = "Obstacles::add_plane";
  check_vector(point, "the point", kWhere);
  check_vector(normal, "the normal", kWhere);
  const double size = length(normal);
  if (!(size > 0)) throw Error("the normal is a vector of length zero", kWhere, "give a direction");
  return add(HalfSpace{point, (1 / size) * normal}, kWhere);
}

std::size_t Obstacles::add_mesh(std::span<const Vec3> vertices,
                                std::span<const std::array<std::uint32_t, 3>> triangles, double thickness) {
  constexpr const char* kWhere = "Obstacles::add_mesh";
  for (const Vec3& vertex : vertices) check_vector(vertex, "a vertex", kWhere);
  check_finite(thickness, "the thickness", kWhere);
  if (thickness < 0) throw Error("the thickness is " + to_text(thickness), kWhere, "give zero or more");
  if (triangles.empty()) throw Error("there are no triangles", kWhere, "give at least one");
  if (triangles.size() > kMost - items_.size())
    throw Error("there are too many obstacles", kWhere, "give fewer");
  for (const auto& corners : triangles) {
    for (const std::uint32_t corner : corners) {
      if (corner >= vertices.size()) {
        throw Error("a triangle has the vertex " + to_text(corner), kWhere,
                    "give numbers below " + to_text(vertices.size()));
      }
    }
  }
  const std::size_t first = order_.size();
  for (const auto& [a, b, c] : triangles)
    insert(Triangle{vertices[a], vertices[b], vertices[c], thickness}, count_);
  grow_trees(first);
  return count_++;
}

std::size_t Obstacles::add_world(const World& world, const Time& now) {
  constexpr const char* kWhere = "Obstacles::add_world";
  check_moment(now, kWhere);
  if (!world.motion().is_straight() || world.motion().has_growth())
    throw Error("spheres fall or grow", kWhere, "give a world where they move straight");
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (world.box().is_periodic(axis))
      throw Error("the box is periodic", kWhere, "give a world whose box has walls or is open");
  }
  // All is added to a copy, so that nothing changes where a surface is refused.
  Obstacles all = *this;
  std::vector<Slot> slots(world.size());
  for (Slot slot = 0; slot < slots.size(); ++slot) slots[slot] = slot;
  std::sort(slots.begin(), slots.end(), [&](Slot a, Slot b) { return world.id(a) < world.id(b); });
  for (const Slot slot : slots) {
    all.add_sphere(world.position(slot, now), world.base_radius(slot), world.unfolded_velocity(slot, now),
                   now.value());
  }
  all.add_walls(world, kWhere);
  for (const Surface& surface : world.surfaces()) all.add_surface(surface, kWhere);
  const std::size_t first = count_;
  *this = std::move(all);
  return first;
}

void Obstacles::add_walls(const World& world, const char* where) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (world.box().boundary(axis) != Boundary::wall) continue;
    Vec3 inward;
    inward[axis] = 1;
    add(HalfSpace{{}, inward}, where);
    Vec3 corner;
    corner[axis] = world.box().size()[axis];
    add(HalfSpace{corner, -inward}, where);
  }
}

void Obstacles::add_surface(const Surface& surface, const char* where) {
  if (surface.mesh() && surface.velocity() == Vec3{}) {
    std::vector<Vec3> vertices;
    for (const Vec3& vertex : surface.mesh()->mesh().vertices()) vertices.push_back(surface.point() + vertex);
    add_mesh(vertices, surface.mesh()->mesh().triangles(), surface.mesh()->thickness());
    return;
  }
  const auto* const sphere = std::get_if<hardball::Obstacle>(&surface.shape());
  const auto* const plane = std::get_if<hardball::Plane>(&surface.shape());
  if (sphere != nullptr) {
    add(Ball{surface.point(), sphere->radius(), surface.velocity(), surface.since().value()}, where);
  } else if (plane != nullptr && surface.velocity() == Vec3{}) {
    add(HalfSpace{surface.point(), plane->normal()}, where);
  } else {
    throw Error("there is a surface of the shape " + std::string(surface.name()) +
                    (plane != nullptr ? " that moves" : ""),
                where, "use planes and meshes at rest, and obstacles, or add their shapes one by one");
  }
}

std::size_t Obstacles::add(const Shape& shape, const char* where) {
  if (items_.size() >= kMost) throw Error("there are too many obstacles", where, "give fewer");
  const std::size_t first = order_.size();
  insert(shape, count_);
  grow_trees(first);
  return count_++;
}

void Obstacles::insert(const Shape& shape, std::size_t obstacle) {
  const auto number = static_cast<std::uint32_t>(items_.size());
  items_.push_back({shape, static_cast<std::uint32_t>(obstacle)});
  if (std::holds_alternative<HalfSpace>(shape)) {
    unbounded_.push_back(number);
    return;
  }
  const auto* const ball = std::get_if<Ball>(&shape);
  if (ball != nullptr && ball->velocity != Vec3{} && !has_moving_) {
    // Extents of what is at rest hold at any time.
    has_moving_ = true;
    reference_time_ = ball->time;
  }
  order_.push_back(number);
}

// Trees that are not larger than what follows them are joined with it: then there are few.
void Obstacles::grow_trees(std::size_t first_order) {
  if (first_order == order_.size()) return;
  Tree tree{first_order, nodes_.size()};
  while (!trees_.empty() &&
         tree.first_order - trees_.back().first_order <= order_.size() - tree.first_order) {
    tree = trees_.back();
    trees_.pop_back();
  }
  nodes_.resize(tree.first_node);
  build(tree.first_order, order_.size());
  trees_.push_back(tree);
}

Extent Obstacles::extent_of(std::uint32_t item) const {
  const Shape& shape = items_[item].shape;
  if (const auto* const ball = std::get_if<Ball>(&shape)) {
    const Vec3 center = ball->center + (reference_time_ - ball->time) * ball->velocity;
    return around(center, Vec3{ball->radius, ball->radius, ball->radius});
  }
  if (const auto* const capsule = std::get_if<Capsule>(&shape))
    return of_points(capsule->begin, capsule->end).grown(capsule->radius);
  if (const auto* const triangle = std::get_if<Triangle>(&shape)) {
    const Extent extent = united(of_points(triangle->a, triangle->b), {triangle->c, triangle->c});
    return extent.grown(triangle->thickness);
  }
  const Box& box = std::get<Box>(shape);
  Vec3 half;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    half[axis] = std::fabs(box.rotation.x[axis]) * box.half.x + std::fabs(box.rotation.y[axis]) * box.half.y +
                 std::fabs(box.rotation.z[axis]) * box.half.z;
  }
  return around(box.center, half);
}

void Obstacles::build(std::size_t begin, std::size_t end) {
  const std::size_t place = nodes_.size();
  nodes_.emplace_back();
  Node node;
  node.extent = extent_of(order_[begin]);
  for (std::size_t k = begin; k < end; ++k) {
    node.extent = united(node.extent, extent_of(order_[k]));
    if (const auto* const ball = std::get_if<Ball>(&items_[order_[k]].shape))
      node.speed = std::max(node.speed, length(ball->velocity));
  }
  const Vec3 diagonal = node.extent.high - node.extent.low;
  node.size = 0.5 * length(diagonal);
  if (end - begin == 1) {
    node.is_leaf = true;
    node.right_or_item = order_[begin];
    nodes_[place] = node;
    return;
  }
  std::size_t axis = 0;
  for (std::size_t other = 1; other < kAxes; ++other) {
    if (diagonal[other] > diagonal[axis]) axis = other;
  }
  std::vector<std::pair<double, std::uint32_t>> places;
  places.reserve(end - begin);
  for (std::size_t k = begin; k < end; ++k) {
    const Extent extent = extent_of(order_[k]);
    places.emplace_back(extent.low[axis] + extent.high[axis], order_[k]);
  }
  std::sort(places.begin(), places.end());
  for (std::size_t k = begin; k < end; ++k) order_[k] = places[k - begin].second;
  const std::size_t middle = begin + (end - begin) / 2;
  build(begin, middle);
  node.right_or_item = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end);
  nodes_[place] = node;
}

std::vector<std::uint32_t> Obstacles::roots() const {
  std::vector<std::uint32_t> roots;
  for (const Tree& tree : trees_) roots.push_back(static_cast<std::uint32_t>(tree.first_node));
  return roots;
}

}  // namespace hardball
