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
#include "hardball/world/walls.hpp"

namespace hardball {
namespace {

// A plane or a tube stands upright on the plane of the discs, a sphere is centered in it.
void refuse_out_of_plane(const Surface& surface) {
  const std::string name = "the " + std::string(surface.name());
  refuse_out_of_plane(surface.point(), "the position of " + name, "walls");
  refuse_out_of_plane(surface.velocity(), "the velocity of " + name, "walls");
  if (surface.mesh()) throw Error("a mesh is in a box of two dimensions", "walls", "give the box three");
  if (const auto* cylinder = std::get_if<Cylinder>(&surface.shape())) {
    if (cylinder->axis().x == 0 && cylinder->axis().y == 0) return;
    throw Error("the axis of " + name + " is not z in a box of two dimensions", "walls",
                "make it (0, 0, 1): a circle around the discs");
  }
  if (const auto* pillar = std::get_if<Pillar>(&surface.shape())) {
    if (pillar->axis().x == 0 && pillar->axis().y == 0) return;
    throw Error("the axis of " + name + " is not z in a box of two dimensions", "walls",
                "make it (0, 0, 1): a circle among the discs");
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

// The images of a mesh may touch, but not overlap, and a sphere must see few of them at a time.
void refuse_mesh_in_periodic_box(const Surface& surface, const Box& box, std::size_t axis) {
  const auto refuse = [&](const std::string& what, const char* remedy) {
    throw Error(what + " along " + kAxisNames[axis], "walls", remedy);
  };
  const Extent& extent = surface.mesh()->mesh().extent();
  const double size = box.size()[axis];
  if (surface.velocity() != Vec3{}) refuse("a mesh moves in a box that is periodic", "keep it at rest");
  if (extent.high[axis] - extent.low[axis] > size * (1 + kWallTolerance)) {
    refuse("a mesh is " + to_text(extent.high[axis] - extent.low[axis]) +
               " long, and the period of the box is " + to_text(size),
           "enlarge the box, or scale the mesh");
  }
  const double begin = surface.point()[axis] + extent.low[axis];
  if (begin >= -size && begin <= 2 * size) return;
  refuse("a mesh begins at " + to_text(begin) + ", outside the box,", "move its point");
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
    if (surface.mesh()) {
      refuse_mesh_in_periodic_box(surface, box, axis);
      continue;
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
  }
  if (!box.is_flat()) return;
  refuse_out_of_plane(gravity, "gravity", "gravity");
  for (const Surface& surface : surfaces) refuse_out_of_plane(surface);
}

// Error: spheres of two species pass through each other, and have a potential.
void refuse_steps_of_passing(const Interactions& interactions) {
  if (!interactions.has_passing()) return;
  const StepTable& steps = interactions.steps();
  // Species beyond those that are named are alike.
  const std::size_t species = std::max(interactions.table().species(), steps.species()) + 1;
  const std::size_t most = std::numeric_limits<SpeciesId>::max() + std::size_t{1};
  for (std::size_t a = 0; a < std::min(species, most); ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      const auto one = static_cast<SpeciesId>(a);
      const auto other = static_cast<SpeciesId>(b);
      if (!interactions.pass(one, other) || steps.of(one, other) == StepTable::kNone) continue;
      throw Error("there are potentials of steps, and spheres of the same species pass through each other",
                  "potential", "give the potential a core of zero");
    }
  }
}

Features features_of(const Interactions& interactions) {
  Features features;
  features.add(Feature::steps, !interactions.steps().empty());
  features.add(Feature::merging, interactions.table().has_merging());
  features.add(Feature::custom_response, static_cast<bool>(interactions.function()));
  features.add(Feature::passing, interactions.has_passing());
  features.add(Feature::roughness, interactions.table().is_rough());
  return features;
}

Features features_of_walls(const Box& box, std::span<const Surface> surfaces) {
  Features features;
  const auto add = [&](const SurfaceMaterial& material, const Vec3& velocity) {
    features.add(Feature::moving_walls, velocity != Vec3{});
    features.add(Feature::thermal_walls, material.temperature.has_value());
    features.add(Feature::roughness, material.tangential_restitution.has_value());
  };
  for (Face face = 0; face < kFaces; ++face) add(box.face(face).material, box.face(face).velocity);
  for (const Surface& surface : surfaces) {
    add(surface.material(), surface.velocity());
    features.add(Feature::oscillating_walls, std::holds_alternative<OscillatingPlane>(surface.shape()));
    features.add(Feature::curved_walls, surface.normal() == nullptr);
    if (!surface.mesh()) continue;
    for (const auto& [group, material] : surface.mesh()->group_materials()) add(material, {});
  }
  return features;
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

double largest_fitting_radius(const Box& box, std::span<const Surface> surfaces) {
  double radius = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (box.is_bounded(axis)) radius = std::min(radius, box.size()[axis] / 2);
  }
  for (const Surface& surface : surfaces) radius = std::min(radius, surface.largest_sphere());
  return radius;
}

Setting::Setting(const Box& box) : box_(box) {
  derive();
}

Setting::Setting(const Box& box, const Vec3& gravity, std::vector<Surface> surfaces)
    : box_(box), motion_(gravity), surfaces_(std::move(surfaces)) {
  check_setting(box_, motion_, surfaces_);
  divide_surfaces();
  derive();
  check_exclusions(features_);
}

void Setting::divide_surfaces() {
  std::vector<ExtentTree::Item> at_rest;
  meshes_.clear();
  other_surfaces_.clear();
  std::uint32_t number = kFaces;
  for (const Surface& surface : surfaces_) {
    const auto* const obstacle = std::get_if<Obstacle>(&surface.shape());
    if (obstacle != nullptr && surface.velocity() == Vec3{}) {
      at_rest.push_back({Extent{surface.point(), surface.point()}.grown(obstacle->radius()), number});
    } else if (surface.mesh()) {
      meshes_.push_back(number);
    } else {
      other_surfaces_.push_back(number);
    }
    ++number;
  }
  obstacles_ = ExtentTree(at_rest);
}

Features Setting::features_with(const Interactions& interactions) const {
  Features features = features_of(interactions) | features_of_walls(box_, surfaces_);
  features.add(Feature::flat, box_.is_flat());
  features.add(Feature::gravity, !motion_.is_straight());
  features.add(Feature::growth, motion_.has_growth());
  features.add(Feature::shear, box_.is_sheared());
  features.add(Feature::obstacle_images, has_images_of_solids(*this));
  return features;
}

void Setting::derive() {
  features_ = features_with(interactions_);
  bounding_scale_ = std::max(motion_.largest_scale(), interactions_.steps().range());
}

void Setting::set_interactions(const Interactions& interactions) {
  refuse_steps_of_passing(interactions);
  check_exclusions(features_with(interactions));
  interactions_ = interactions;
  derive();
}

void Setting::set_growth(const Growth& growth) {
  check_growth(growth);
  motion_.set_growth(growth);
  derive();
}

void Setting::end_growth() {
  motion_.set_growth({});
  derive();
}

void Setting::set_surface(std::uint32_t number, const Surface& surface) {
  surfaces_[number - kFaces] = surface;
  divide_surfaces();
  derive();
}

bool Setting::restored() {
  check_setting(box_, motion_, surfaces_);
  refuse_steps_of_passing(interactions_);
  check_growth(motion_.growth());
  divide_surfaces();
  derive();
  check_exclusions(features_);
  return true;
}

}  // namespace hardball
