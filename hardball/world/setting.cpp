// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/setting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <variant>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"

namespace hardball {
namespace {

// A plane or a tube stands upright on the plane of the discs, a sphere is centered in it.
void refuse_out_of_plane(const Surface& surface) {
  const std::string name = "the " + std::string(surface.name());
  refuse_out_of_plane(surface.point(), "the position of " + name, "walls");
  refuse_out_of_plane(surface.velocity(), "the velocity of " + name, "walls");
  if (const auto* cylinder = std::get_if<Cylinder>(&surface.shape())) {
    if (cylinder->axis().x == 0 && cylinder->axis().y == 0) return;
    throw Error("the axis of " + name + " is not z in a box of two dimensions", "walls",
                "make it (0, 0, 1): a circle around the discs");
  }
  if (const auto* cone = std::get_if<Cone>(&surface.shape()))
    refuse_out_of_plane(cone->axis(), "the axis of " + name, "walls");
  if (const Vec3* const normal = surface.normal())
    refuse_out_of_plane(*normal, "the normal of " + name, "walls");
}

// All images of an obstacle that reach into a box are visited.
void refuse_far_or_large(const Obstacle& obstacle, double center, double size, std::size_t axis) {
  constexpr double kMaxBoxes = 16;
  if (!(center >= -size && center <= 2 * size)) {
    throw Error(
        "an obstacle at " + to_text(center) + " along " + kAxisNames[axis] + " is outside the periodic box",
        "walls", "place it between 0 and " + to_text(size));
  }
  if (2 * obstacle.radius() <= kMaxBoxes * size) return;
  throw Error("the diameter " + to_text(2 * obstacle.radius()) + " of an obstacle exceeds " +
                  to_text(kMaxBoxes) + " times the period " + to_text(size) + " along " + kAxisNames[axis],
              "walls", "enlarge the box or shrink the obstacle");
}

// A plane or a tube must be the same in every image of the box; what encloses spheres must lie inside it.
void refuse_in_periodic_box(const Surface& surface, const Box& box) {
  const auto refuse = [&](std::size_t axis, const char* remedy) {
    throw Error("the " + std::string(surface.name()) + " is not periodic along " + kAxisNames[axis], "walls",
                remedy);
  };
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!box.is_periodic(axis)) continue;
    if (const auto* obstacle = std::get_if<Obstacle>(&surface.shape())) {
      refuse_far_or_large(*obstacle, surface.point()[axis], box.size()[axis], axis);
      if (surface.velocity() == Vec3{}) continue;
      // Its images would come from any distance.
      throw Error("an obstacle moves in a periodic box", "walls",
                  "keep it at rest, or use a kinematic sphere");
    }
    const char* const remedy =
        std::visit([&](const auto& shape) { return shape.remedy_for_period(axis); }, surface.shape());
    if (remedy) refuse(axis, remedy);
    const Extent room = std::visit([](const auto& shape) { return shape.room(); }, surface.shape());
    if (!std::isfinite(room.high[axis])) continue;
    const double center = surface.point()[axis];
    const bool is_inside = center >= -room.low[axis] && center <= box.size()[axis] - room.high[axis];
    if (surface.velocity()[axis] != 0 || !is_inside)
      refuse(axis, "keep it inside the box and at rest, or make the axis open");
  }
}

// A plane that recedes, or is at rest, is not met if no corner of the box lies beyond it.
void refuse_behind_faces(const Surface& surface, const Box& box) {
  const Vec3* const normal = surface.normal();
  if (normal == nullptr || dot(surface.velocity(), *normal) > 0) return;
  double gap = 0;  // of the corner that comes closest
  double scale = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double n = (*normal)[axis];
    if (n == 0) continue;
    if (!box.is_wall(axis)) return;
    const double coordinate = surface.point()[axis];
    gap += n * ((n > 0 ? 0 : box.size()[axis]) - coordinate);
    scale += std::fabs(n) * (box.size()[axis] + std::fabs(coordinate));
  }
  if (const auto* plane = std::get_if<OscillatingPlane>(&surface.shape())) gap -= plane->amplitude();
  if (gap < -kWallTolerance * scale) return;
  throw Error("no sphere can reach the " + std::string(surface.name()) +
                  ": faces of the box that are walls are in front of it, or where it is",
              "walls", "give the face properties of its own, in scenarios in [box.faces], or open the axis");
}

// Error: gravity is outside the operating range; a surface does not fit into the box, or no sphere can reach
// it; or, in two dimensions, either leaves the plane.
void check_setting(const Box& box, const Motion& motion, std::span<const Surface> surfaces) {
  const Vec3& gravity = motion.gravity();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double g = gravity[axis];
    check_finite(g, "gravity", "gravity");
    if (g != 0 && std::fabs(g) < kSmallestMagnitude) {
      throw Error("gravity is " + to_text(g), "gravity", "give zero, or a magnitude of at least 1e-60");
    }
  }
  for (const Surface& surface : surfaces) {
    refuse_in_periodic_box(surface, box);
    refuse_behind_faces(surface, box);
    if (!box.is_sheared() || surface.normal() != nullptr) continue;
    const bool is_obstacle = std::holds_alternative<Obstacle>(surface.shape());
    throw Error("the box is sheared, and there is " +
                    (is_obstacle ? "an obstacle" : "a " + std::string(surface.name())),
                "walls", "use planes across z, or no surfaces");
  }
  if (!box.is_flat()) return;
  refuse_out_of_plane(gravity, "gravity", "gravity");
  for (const Surface& surface : surfaces) refuse_out_of_plane(surface);
}

}  // namespace

void refuse_out_of_plane(const Vec3& vector, const std::string& what, const std::string& where) {
  if (vector.z == 0) return;
  throw Error(what + " along z is " + to_text(vector.z) + " in a box of two dimensions", where,
              "make it zero, or give the box three dimensions");
}

void check_growth(const Growth& growth) {
  const auto refuse = [](const std::string& what, const char* remedy) {
    throw Error(what, "growth", remedy);
  };
  if (growth == Growth()) return;
  check_moment(growth.begin, "growth");
  check_positive(growth.scale, "scale", "growth");
  check_finite(growth.rate, "rate", "growth");
  if (growth.rate != 0) check_moment(growth.end, "growth");
  if (growth.end < growth.begin) refuse("an epoch ends before it begins", "give a later end");
  if (growth.rate != 0 && !(growth.scale_at(growth.end) >= kSmallestMagnitude)) {
    refuse("spheres shrink to the scale " + to_text(growth.scale_at(growth.end)),
           "end the epoch while they have a size");
  }
}

void check_walls_for_growth(const Box& box, std::span<const Surface> surfaces) {
  const auto check = [](const SurfaceMaterial& material, const Vec3& velocity) {
    if (velocity != Vec3{}) throw Error("spheres grow, and a wall moves", "growth", "keep it at rest");
    if (!material.temperature) return;
    throw Error("spheres grow, and a wall has a temperature", "growth", "let it reflect them");
  };
  for (Face face = 0; face < kFaces; ++face) {
    if (box.is_wall(axis_of(face))) check(box.face(face).material, box.face(face).velocity);
  }
  for (const Surface& surface : surfaces) {
    check(surface.material(), surface.velocity());
    if (!std::holds_alternative<OscillatingPlane>(surface.shape())) continue;
    throw Error("spheres grow, and a wall oscillates", "growth", "keep it at rest");
  }
}

double largest_fitting_radius(const Box& box, std::span<const Surface> surfaces) {
  double radius = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (box.is_bounded(axis)) radius = std::min(radius, box.size()[axis] / 2);
  }
  for (const Surface& surface : surfaces) radius = std::min(radius, surface.largest_sphere());
  return radius;
}

Setting::Setting(const Box& box, const Vec3& gravity, std::vector<Surface> surfaces)
    : box_(box), motion_(gravity), surfaces_(std::move(surfaces)) {
  check_setting(box_, motion_, surfaces_);
  refuse_shear_with_others();
  divide_surfaces();
}

void Setting::divide_surfaces() {
  std::vector<ObstacleTree::Obstacle> at_rest;
  other_surfaces_.clear();
  std::uint32_t number = kFaces;
  for (const Surface& surface : surfaces_) {
    const auto* const obstacle = std::get_if<Obstacle>(&surface.shape());
    if (obstacle != nullptr && surface.velocity() == Vec3{}) {
      at_rest.push_back({surface.point(), obstacle->radius(), number});
    } else {
      other_surfaces_.push_back(number);
    }
    ++number;
  }
  obstacles_ = ObstacleTree(std::move(at_rest));
}

void Setting::derive() {
  has_steps_ = !interactions_.steps().empty();
  bounding_scale_ = std::max(motion_.largest_scale(), interactions_.steps().range());
}

void Setting::set_interactions(const Interactions& interactions) {
  const Interactions before = std::exchange(interactions_, interactions);
  derive();
  try {
    refuse_steps_with_others();
    if (motion_.has_growth()) refuse_growth_with_others();
    refuse_shear_with_others();
  } catch (...) {
    interactions_ = before;
    derive();
    throw;
  }
}

void Setting::set_growth(const Growth& growth) {
  check_growth(growth);
  refuse_growth_with_others();
  motion_.set_growth(growth);
  derive();
}

void Setting::end_growth() {
  motion_.set_growth({});
  derive();
}

void Setting::refuse_growth_with_others() const {
  const auto refuse = [](const char* what, const char* remedy) {
    throw Error(std::string("spheres grow, and ") + what, "growth", remedy);
  };
  if (!motion_.is_straight()) refuse("there is gravity", "remove one of them");
  if (interactions_.table().is_rough()) refuse("some are rough, or spin", "make them smooth");
  if (interactions_.table().has_merging()) refuse("some merge", "let them bounce");
  if (interactions_.has_passing()) refuse("some pass through each other", "let them bounce");
  if (has_steps_) refuse("there are potentials of steps", "remove one of them");
  if (box_.is_sheared()) refuse("the box is sheared", "remove one of them");
  check_walls_for_growth(box_, surfaces_);
}

void Setting::refuse_shear_with_others() const {
  if (!box_.is_sheared()) return;
  const auto refuse = [](const char* what, const char* remedy) {
    throw Error(std::string("the box is sheared, and ") + what, "shear", remedy);
  };
  if (!motion_.is_straight()) refuse("there is gravity", "remove one of them");
  if (has_steps_) refuse("there are potentials of steps", "remove one of them");
}

void Setting::refuse_steps_with_others() const {
  if (!has_steps_) return;
  const auto refuse = [](const char* what, const char* remedy) {
    throw Error(std::string("there are potentials of steps, and ") + what, "potential", remedy);
  };
  if (!motion_.is_straight()) refuse("there is gravity", "remove one of them");
  if (motion_.has_growth()) refuse("spheres grow", "remove one of them");
  if (interactions_.table().has_merging()) refuse("some spheres merge", "let them bounce");
  if (!interactions_.has_passing()) return;
  const StepTable& steps = interactions_.steps();
  // Species beyond those that are named are alike.
  const std::size_t species = std::max(interactions_.table().species(), steps.species()) + 1;
  const std::size_t most = std::numeric_limits<SpeciesId>::max() + std::size_t{1};
  for (std::size_t a = 0; a < std::min(species, most); ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      const auto one = static_cast<SpeciesId>(a);
      const auto other = static_cast<SpeciesId>(b);
      if (interactions_.pass(one, other) && steps.of(one, other) != StepTable::kNone)
        refuse("spheres of the same species pass through each other", "give the potential a core of zero");
    }
  }
}

bool Setting::restored() {
  derive();
  refuse_steps_with_others();
  check_setting(box_, motion_, surfaces_);
  divide_surfaces();
  check_growth(motion_.growth());
  if (motion_.has_growth()) refuse_growth_with_others();
  refuse_shear_with_others();
  return true;
}

}  // namespace hardball
