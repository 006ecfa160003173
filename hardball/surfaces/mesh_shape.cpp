// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/surfaces/mesh_shape.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/nearest_point.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/geometry/safe_step.hpp"
#include "hardball/geometry/swept_ball.hpp"

namespace hardball {
namespace {

constexpr double kNoContact = std::numeric_limits<double>::infinity();
// By how much cones are wider, as a fraction of the radius: more than rounding leaves between them.
constexpr double kSlack = 0x1p-40;
// Rays have no radius: as a fraction of the largest coordinate.
constexpr double kSlackOfRays = 0x1p-50;

DoubleDouble<> square_root(const DoubleDouble<>& a) {
  if (!(a.high > 0)) return {0, 0};
  const double root = std::sqrt(a.high);
  const DoubleDouble<> rest = a - product(root, root);
  return normalized(root, rest.high / (2 * root));
}

double length_of(const PreciseVector& a) {
  return length(rounded(a));
}

// The direction from a to b, exactly, in powers of two of which the longest component is almost one: with
// lengths of any magnitude, products of many would leave the range of numbers.
PreciseVector direction_between(const Vec3& a, const Vec3& b) {
  const PreciseVector apart = precise_difference(b, a);
  const double largest =
      std::max({std::fabs(apart.x.high), std::fabs(apart.y.high), std::fabs(apart.z.high)});
  int exponent = 0;
  std::frexp(largest, &exponent);
  constexpr int kLeast = -1000;  // beyond it, the scale would be infinite
  const double scale = std::ldexp(1.0, -std::max(exponent, kLeast));
  const auto scaled = [scale](const DoubleDouble<>& component) {
    return DoubleDouble<>{scale * component.high, scale * component.low};
  };
  return {scaled(apart.x), scaled(apart.y), scaled(apart.z)};
}

// Where the center of a sphere is relative to a vertex: position + velocity t + curvature t^2.
struct Course {
  PreciseVector position;
  PreciseVector velocity;
  PreciseVector curvature;

  Course(const Passage& passage, const Vec3& vertex)
      : position(passage.position - precise(vertex)),
        velocity(passage.velocity),
        curvature(half(passage.acceleration)) {}

  // How far it is along a direction, times the length of that.
  Polynomial along(const PreciseVector& direction) const {
    return {{dot(position, direction), dot(velocity, direction), dot(curvature, direction)}};
  }
  // The square of its distance from the vertex.
  Polynomial square() const { return squared_distance(position, velocity, curvature); }
  // The square of its distance from the line through the vertex, times that of the length of the direction.
  Polynomial square_across(const PreciseVector& direction) const {
    return squared_distance(cross(position, direction), cross(velocity, direction),
                            cross(curvature, direction));
  }
  PreciseVector at(double t) const {
    const auto value = [&](std::size_t axis) {
      return Polynomial{{position[axis], velocity[axis], curvature[axis]}}(t);
    };
    return {value(0), value(1), value(2)};
  }
};

Polynomial multiplied(const DoubleDouble<>& factor, Polynomial p) {
  for (DoubleDouble<>& coefficient : p.coefficients) coefficient = factor * coefficient;
  return p;
}

Polynomial negative(Polynomial p) {
  for (DoubleDouble<>& coefficient : p.coefficients) coefficient = -coefficient;
  return p;
}

// Polynomials of degree two that are not negative where the center is in a cone.
using NormalCone = std::vector<Polynomial>;

// The first time of an interval at which the center is in a cone; infinite if there is none.
double first_within(const Descents::Interval& during, const NormalCone& cone) {
  double t = during.begin;
  std::size_t entered = cone.size();  // through this border, just now
  for (std::size_t border = 0; border < cone.size(); ++border) {
    if (border == entered || !(cone[border](t).high < 0)) continue;
    // Before it, this border alone keeps the center out.
    const double entry = earliest_descent(negative(cone[border]));
    if (!(entry > t && entry < during.end)) return kNoContact;
    t = entry;
    entered = border;
    border = static_cast<std::size_t>(-1);
  }
  return t;
}

// Whether a triangle touches no sphere on its border that moves no farther than `way` [L] from where it
// touches the triangle: it is above the face.
bool is_within(const std::array<Vec3, 3>& corners, const Vec3& center, double radius, double way) {
  const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double least_square = way * (2 * radius + way);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 along = corners[(k + 1) % 3] - corners[k];
    // In the plane, from the side: times the lengths of the side and of the normal.
    const double beyond = dot(cross(along, center - corners[k]), normal);
    if (!(beyond > 0 && beyond * beyond > least_square * dot(along, along) * dot(normal, normal)))
      return false;
  }
  return true;
}

// A feature of a mesh as a sphere sees it that passes by.
class Encounter {
 public:
  Encounter(const MeshShape& shape, const Passage& passage)
      : mesh_(shape.mesh()),
        passage_(passage),
        radius_(sum(passage.radius, shape.thickness())),
        slack_(radius_.high > 0 ? kSlack * radius_.high : kSlackOfRays * shape.mesh().largest_coordinate()) {}

  // When the sphere first touches a feature.
  double contact(std::uint32_t feature) const {
    const auto faces = static_cast<std::uint32_t>(mesh_.triangles().size());
    if (feature < faces) return contact_with_face(feature);
    const std::uint32_t edge = feature - faces;
    if (edge < mesh_.edges().size()) return contact_with_edge(edge);
    return contact_with_vertex(edge - static_cast<std::uint32_t>(mesh_.edges().size()));
  }

  // When the sphere touches a face, where it is known to be above the face all the time from `begin` to `end`
  // and to begin an overlap in that time.
  double contact_with_face_between(std::uint32_t triangle, double begin, double end) const {
    const Face face = this->face(triangle);
    // On the side of its center: on the other it overlaps all the time.
    for (const Descents::Interval& closing : descents(gap_to_face(face, is_above(face, begin) ? 1 : -1))) {
      if (closing.begin >= begin && closing.begin <= end) return closing.begin;
    }
    return contact_with_face(triangle);
  }

  // The gap to a feature, or what has its sign; of a face, on the side where the center is at `wait`.
  Polynomial gap(std::uint32_t feature, double wait) const {
    const auto faces = static_cast<std::uint32_t>(mesh_.triangles().size());
    if (feature < faces) {
      const Face face = this->face(feature);
      return gap_to_face(face, is_above(face, wait) ? 1 : -1);
    }
    const std::uint32_t edge = feature - faces;
    if (edge < mesh_.edges().size()) return gap_to_edge(edge);
    return gap_to_vertex(edge - static_cast<std::uint32_t>(mesh_.edges().size()));
  }

  // From the center to the nearest point of a feature in whose cone it is.
  Vec3 towards(std::uint32_t feature, double wait) const {
    const auto faces = static_cast<std::uint32_t>(mesh_.triangles().size());
    if (feature < faces) {
      const Face face = this->face(feature);
      const Vec3 normal = rounded(face.normal);
      return (-face.height(wait).high / dot(normal, normal)) * normal;
    }
    const std::uint32_t edge = feature - faces;
    if (edge >= mesh_.edges().size()) {
      const std::uint32_t vertex = edge - static_cast<std::uint32_t>(mesh_.edges().size());
      return -rounded(Course(passage_, mesh_.vertices()[vertex]).at(wait));
    }
    const PreciseVector along = direction(edge);
    const PreciseVector from = Course(passage_, mesh_.vertices()[mesh_.edges()[edge].low]).at(wait);
    const Vec3 across = rounded(cross(cross(along, from), along));
    return (-1 / dot(rounded(along), rounded(along))) * across;
  }

 private:
  struct Face {
    std::array<Vec3, 3> corners;
    PreciseVector normal;  // not of unit length
    DoubleDouble<> length;
    Polynomial height;  // of the center, times the length
  };

  Face face(std::uint32_t triangle) const {
    Face face{corners_of(triangle), {}, {}, {}};
    face.normal = normal_of(face.corners);
    face.length = square_root(dot(face.normal, face.normal));
    face.height = Course(passage_, face.corners[0]).along(face.normal);
    return face;
  }
  static bool is_above(const Face& face, double wait) { return face.height(wait).high >= 0; }

  Polynomial gap_to_face(const Face& face, int side) const {
    Polynomial gap = side > 0 ? face.height : negative(face.height);
    gap.coefficients[0] = gap.coefficients[0] - face.length * radius_;
    gap.coefficients[1] = gap.coefficients[1] - face.length * DoubleDouble<>{passage_.growth, 0};
    return gap;
  }
  Polynomial gap_to_edge(std::uint32_t edge) const {
    const PreciseVector along = direction(edge);
    return difference(Course(passage_, mesh_.vertices()[mesh_.edges()[edge].low]).square_across(along),
                      multiplied(dot(along, along), square_of(radius_, {passage_.growth, 0})));
  }
  Polynomial gap_to_vertex(std::uint32_t vertex) const {
    return difference(Course(passage_, mesh_.vertices()[vertex]).square(),
                      square_of(radius_, {passage_.growth, 0}));
  }

  PreciseVector direction(std::uint32_t edge) const {
    return direction_between(mesh_.vertices()[mesh_.edges()[edge].low],
                             mesh_.vertices()[mesh_.edges()[edge].high]);
  }

  // Widened by the slack, which is a distance, for a border whose normal has this length.
  Polynomial widened(Polynomial border, double normal_length) const {
    border.coefficients[0] = border.coefficients[0] + DoubleDouble<>{slack_ * normal_length, 0};
    return border;
  }

  double contact_with_face(std::uint32_t triangle) const {
    if (!mesh_.has_area(triangle)) return kNoContact;
    const Face face = this->face(triangle);
    NormalCone slab;
    double first = kNoContact;
    for (const int side : {1, -1}) {
      for (const Descents::Interval& closing : descents(gap_to_face(face, side))) {
        if (slab.empty()) {
          for (std::size_t k = 0; k < 3; ++k) {
            const PreciseVector inward =
                cross(face.normal, direction_between(face.corners[k], face.corners[(k + 1) % 3]));
            slab.push_back(widened(Course(passage_, face.corners[k]).along(inward), length_of(inward)));
          }
          slab.emplace_back();
        }
        // The center of a sphere that overlaps is on this side, too, and so is a ray that arrives.
        slab[3] = side > 0 ? face.height : negative(face.height);
        slab[3].coefficients[0] =
            slab[3].coefficients[0] + face.length * DoubleDouble<>{0.5 * radius_.high + slack_, 0};
        first = std::min(first, first_within(closing, slab));
      }
    }
    return first;
  }

  double contact_with_edge(std::uint32_t edge) const {
    if (mesh_.is_inner(edge)) return kNoContact;
    NormalCone cone;
    double first = kNoContact;
    for (const Descents::Interval& closing : descents(gap_to_edge(edge))) {
      if (cone.empty()) cone = cone_of_edge(edge);
      first = std::min(first, first_within(closing, cone));
    }
    return first;
  }

  double contact_with_vertex(std::uint32_t vertex) const {
    NormalCone cone;
    double first = kNoContact;
    for (const Descents::Interval& closing : descents(gap_to_vertex(vertex))) {
      if (cone.empty()) cone = cone_of_vertex(vertex);
      first = std::min(first, first_within(closing, cone));
    }
    return first;
  }

  NormalCone cone_of_edge(std::uint32_t edge) const {
    const Vec3& low = mesh_.vertices()[mesh_.edges()[edge].low];
    const Vec3& high = mesh_.vertices()[mesh_.edges()[edge].high];
    const PreciseVector along = direction(edge);
    const Course from_low(passage_, low);
    const double edge_length = length_of(along);
    NormalCone cone{widened(from_low.along(along), edge_length),
                    widened(negative(Course(passage_, high).along(along)), edge_length)};
    for (const std::uint32_t triangle : mesh_.triangles_at_edge(edge)) {
      if (!mesh_.has_area(triangle)) continue;
      // From the edge into the triangle, across the edge.
      PreciseVector inward = cross(normal_of(corners_of(triangle)), along);
      for (std::size_t k = 0; k < 3; ++k) {
        if (mesh_.edges_of(triangle)[k] == edge && mesh_.triangles()[triangle][k] != mesh_.edges()[edge].low)
          inward = {-inward.x, -inward.y, -inward.z};
      }
      cone.push_back(widened(negative(from_low.along(inward)), length_of(inward)));
    }
    return cone;
  }

  NormalCone cone_of_vertex(std::uint32_t vertex) const {
    const Vec3& place = mesh_.vertices()[vertex];
    const Course from(passage_, place);
    NormalCone cone;
    for (const std::uint32_t edge : mesh_.edges_at_vertex(vertex)) {
      const auto& [low, high] = mesh_.edges()[edge];
      const PreciseVector along = direction_between(place, mesh_.vertices()[low == vertex ? high : low]);
      cone.push_back(widened(negative(from.along(along)), length_of(along)));
    }
    return cone;
  }

  std::array<Vec3, 3> corners_of(std::uint32_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles()[triangle];
    return {mesh_.vertices()[a], mesh_.vertices()[b], mesh_.vertices()[c]};
  }
  static PreciseVector normal_of(const std::array<Vec3, 3>& corners) {
    return cross(direction_between(corners[0], corners[1]), direction_between(corners[0], corners[2]));
  }

  const Mesh& mesh_;
  const Passage& passage_;
  DoubleDouble<> radius_;
  double slack_;
};

}  // namespace

MeshShape::MeshShape(std::shared_ptr<const Mesh> mesh, MeshSide spheres, double thickness)
    : mesh_(std::move(mesh)), spheres_(spheres), thickness_(thickness) {
  if (!mesh_) throw Error("a surface has no mesh", "mesh", "give one");
  if (!(thickness >= 0 && is_in_range(thickness)))
    throw Error("the thickness of a mesh is " + to_text(thickness), "mesh", "give zero or a positive number");
  if (spheres == MeshSide::both || mesh_->is_closed()) return;
  throw Error("a mesh is not closed and has no inside: " + to_text(mesh_->report().boundary_edges) +
                  " of its edges belong to one triangle, and " + to_text(mesh_->report().branching_edges) +
                  " to more than two",
              "mesh", "close it, or let spheres be on both sides, and give their positions");
}

void MeshShape::set_group_material(std::string_view group, const SurfaceMaterial& material) {
  check_material(material, "mesh");
  const std::span<const std::string> names = mesh_->group_names();
  const auto found = std::find(names.begin(), names.end(), group);
  if (found == names.end()) {
    std::string known;
    for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
    throw Error("a mesh has no group '" + std::string(group) + "'", "mesh",
                known.empty() ? "give its faces groups, or all one material" : "its groups are " + known);
  }
  materials_.emplace_back(static_cast<std::uint32_t>(found - names.begin()), material);
}

const SurfaceMaterial* MeshShape::material_of(std::uint32_t feature) const {
  if (materials_.empty()) return nullptr;
  const std::uint32_t group = mesh_->group(mesh_->triangle_of(feature));
  for (const auto& [index, material] : materials_) {
    if (index == group) return &material;
  }
  return nullptr;
}

MeshContact MeshShape::first_contact(const Passage& passage, double begin, double end) const {
  const SweptBall ball(rounded(passage.position), rounded(passage.velocity), rounded(passage.acceleration),
                       passage.radius + thickness_, passage.growth);
  // More than coordinates are rounded by; steps end where less than this or a billionth of the radius is
  // left.
  const double scale =
      mesh_->largest_coordinate() + length(rounded(passage.position)) + ball.radius_at(begin);
  const double rounding = 1e-12 * scale;
  const double acceleration = ball.acceleration();
  struct Candidate {
    double bound;
    std::uint32_t triangle;
    // If finite, the sphere touches the face in no more time than this, and cannot touch its border in
    // twice the time.
    double delay = kNoContact;
  };
  std::vector<Candidate> candidates;
  double farthest = end;
  mesh_->tree().for_each_within(
      farthest,
      [&](const FourExtents& extents) { return ball.free_until(extents, begin, farthest, rounding); },
      [&](std::uint32_t triangle) {
        const auto& [ia, ib, ic] = mesh_->triangles()[triangle];
        const Vec3& a = mesh_->vertices()[ia];
        const Vec3& b = mesh_->vertices()[ib];
        const Vec3& c = mesh_->vertices()[ic];
        const auto gap_at = [&](double t) {
          const Vec3 center = ball.position_at(t);
          const Vec3 apart = center - nearest_on_triangle(a, b, c, center);
          const double distance = length(apart);
          const double speed = distance > 0 ? dot(apart, ball.velocity_at(t)) / distance : 0;
          return Gap{distance - ball.radius_at(t), speed - ball.growth(), acceleration};
        };
        Extent around{a, a};
        around.enclose({b, b});
        around.enclose({c, c});
        double t = ball.free_until(around, begin, farthest, rounding);
        while (t <= farthest && t < kNoContact) {
          const Gap gap = gap_at(t);
          const double enough = rounding + 1e-9 * ball.radius_at(t);
          if (gap.width <= enough) {
            // On a line, the gap to what is convex opens for good once it does.
            const double uncertain = 4 * rounding / ball.radius_at(t) * length(ball.velocity_at(t));
            if (acceleration == 0 && gap.speed > uncertain) return;
            // On a parabola, it opens until it turns, if it is wide open by then.
            const double opening = (gap.speed - uncertain) / acceleration;
            if (gap.speed > uncertain && 0.5 * (gap.speed - uncertain) * opening > 2 * enough) {
              t += opening;
              continue;
            }
            candidates.push_back({t, triangle});
            // It is certainly touched if it soon overlaps: nothing later matters.
            const double soon = t + 2 * (std::max(gap.width, 0.0) + rounding) / -gap.speed;
            if (!(gap.speed < 0 && gap_at(soon).width < -rounding)) return;
            farthest = std::min(farthest, soon);
            // Nor does its border, if it cannot be touched until then.
            const double speed =
                length(ball.velocity_at(t)) + acceleration * (soon - t) + std::fabs(ball.growth());
            const double way = 2 * speed * (soon - t) + 2 * std::fabs(gap.width) + 4 * rounding;
            if (t > begin && mesh_->has_area(triangle) &&
                is_within({a, b, c}, ball.position_at(t), ball.radius_at(t), way))
              candidates.back().delay = soon - t;
            return;
          }
          const double next = t + safe_step({gap.width - 0.5 * rounding, gap.speed, gap.curvature});
          t = next > t ? next : std::nextafter(t, kNoContact);
        }
      });
  if (candidates.empty()) return {};
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.bound != b.bound ? a.bound < b.bound : a.triangle < b.triangle;
  });
  const Encounter encounter(*this, passage);
  const auto faces = static_cast<std::uint32_t>(mesh_->triangles().size());
  const auto edges = static_cast<std::uint32_t>(mesh_->edges().size());
  MeshContact first;
  const auto note = [&](std::uint32_t feature, double wait) {
    if (wait < first.wait || (wait == first.wait && first.happens() && feature < first.feature))
      first = {wait, feature};
  };
  for (const Candidate& candidate : candidates) {
    if (candidate.bound > first.wait) break;
    if (candidate.delay < kNoContact) {
      note(candidate.triangle,
           encounter.contact_with_face_between(candidate.triangle, candidate.bound - candidate.delay,
                                               candidate.bound + 2 * candidate.delay));
      continue;
    }
    const auto note_contact = [&](std::uint32_t feature) { note(feature, encounter.contact(feature)); };
    note_contact(candidate.triangle);
    for (const std::uint32_t edge : mesh_->edges_of(candidate.triangle)) {
      if (edge != Mesh::kNoEdge) note_contact(faces + edge);
    }
    for (const std::uint32_t vertex : mesh_->triangles()[candidate.triangle])
      note_contact(faces + edges + vertex);
  }
  return first;
}

DoubleDouble<> MeshShape::opening_speed(const Passage& passage, std::uint32_t feature) const {
  return Encounter(*this, passage).gap(feature, 0).coefficients[1];
}

Vec3 MeshShape::towards(const Passage& passage, double wait, std::uint32_t feature) const {
  return Encounter(*this, passage).towards(feature, wait);
}

double MeshShape::displaced_volume() const {
  if (thickness_ > 0) return std::numeric_limits<double>::quiet_NaN();
  return spheres_ == MeshSide::outside ? mesh_->volume() : 0;
}

double MeshShape::distance(const Vec3& position) const {
  const double distance = length(mesh_->nearest(position).point - position) - thickness_;
  if (spheres_ == MeshSide::both) return distance;
  return mesh_->contains(position) == (spheres_ == MeshSide::inside) ? distance : -std::fabs(distance);
}

}  // namespace hardball
