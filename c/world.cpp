// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "c/arrays.hpp"
#include "c/guard.hpp"
#include "c/handles.hpp"
#include "c/hardball.h"
#include "hardball/responses.hpp"
#include "hardball/surfaces.hpp"
#include "hardball/world.hpp"

namespace hardball::c {
namespace {

// The unit vector along a vector of any length, as in scenarios: components along an axis stay exact.
Vec3 direction_of(const double* numbers, const char* argument) {
  const Vec3 vector = vector_of(numbers);
  const double largest = std::max({std::fabs(vector.x), std::fabs(vector.y), std::fabs(vector.z)});
  if (!(largest > 0 && std::isfinite(largest)))
    throw Error("it has no direction", argument, "give a vector that is finite and not zero");
  const Vec3 scaled{vector.x / largest, vector.y / largest, vector.z / largest};
  const double norm = length(scaled);
  return {scaled.x / norm, scaled.y / norm, scaled.z / norm};
}

Shape shape_of(const hb_surface& surface) {
  switch (surface.shape) {
    case HB_SHAPE_PLANE:
      return oscillating(Plane(direction_of(surface.normal, "normal")), surface.amplitude, surface.frequency);
    case HB_SHAPE_CYLINDER:
      return Cylinder(direction_of(surface.axis, "axis"), surface.radius);
    case HB_SHAPE_SPHERE:
      return HollowSphere(surface.radius);
    case HB_SHAPE_OBSTACLE:
      return Obstacle(surface.radius);
    case HB_SHAPE_PILLAR:
      return Pillar(direction_of(surface.axis, "axis"), surface.radius);
    case HB_SHAPE_CONE:
      return Cone(direction_of(surface.axis, "axis"), surface.slope);
    default:
      throw Error("its shape is " + to_text(surface.shape), "surface", "give one of HB_SHAPE_");
  }
}

std::optional<double> if_given(double number) {
  return number == HB_ABSENT ? std::nullopt : std::optional(number);
}

Surface surface_of(const hb_surface& surface) {
  return {shape_of(surface),
          vector_of(surface.point),
          vector_of(surface.velocity),
          {.restitution = if_given(surface.restitution),
           .tangential_restitution = if_given(surface.tangential_restitution),
           .temperature = if_given(surface.temperature),
           .seed = surface.seed}};
}

// The size of the structs is the distance between them.
std::vector<Surface> surfaces_of(const hb_setting& setting) {
  std::vector<Surface> surfaces;
  const hb_surface defaults = HB_SURFACE_INIT;
  const auto* next =
      reinterpret_cast<const char*>(given_array(setting.surfaces, setting.surface_count, "surfaces"));
  for (std::size_t k = 0; k < setting.surface_count; ++k) {
    const auto* surface = reinterpret_cast<const hb_surface*>(next);
    surfaces.push_back(surface_of(completed(surface, defaults, "surfaces")));
    next += surface->struct_size;
  }
  return surfaces;
}

Box box_of(const hb_setting& setting) {
  std::array<Boundary, kAxes> boundary;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const hb_boundary value = setting.boundary[axis];
    if (value < HB_BOUNDARY_WALL || value > HB_BOUNDARY_FLAT)
      throw Error("a boundary is " + to_text(value), "setting", "give one of HB_BOUNDARY_");
    boundary[axis] = static_cast<Boundary>(value);
  }
  return {boundary, vector_of(setting.size)};
}

World world_of(const hb_setting& setting) {
  World world(box_of(setting), vector_of(setting.gravity), surfaces_of(setting));
  world.set_interactions(Restitution(setting.restitution, setting.elastic_below));
  return world;
}

// The caller's arrays of spheres.
class SphereRows {
 public:
  explicit SphereRows(const hb_spheres& spheres)
      : positions_(spheres.positions, HB_F64, spheres.count > 0, "positions"),
        velocities_(spheres.velocities, HB_F64, false, "velocities"),
        radii_(spheres.radii, HB_F64, false, "radii"),
        masses_(spheres.masses, HB_F64, false, "masses"),
        spins_(spheres.spins, HB_F64, false, "spins"),
        inertia_factors_(spheres.inertia_factors, HB_F64, false, "inertia_factors"),
        species_(spheres.species, HB_U32, false, "species") {}

  Sphere operator[](std::size_t row) const {
    return {.position = positions_.vector(row),
            .velocity = velocities_.vector(row),
            .radius = radii_.number(row, 1),
            .mass = masses_.number(row, 1),
            .spin = spins_.vector(row),
            .species = species_of(species_.integer(row)),
            .inertia_factor = inertia_factors_.number(row, kSphereInertiaFactor)};
  }

 private:
  Rows positions_;
  Rows velocities_;
  Rows radii_;
  Rows masses_;
  Rows spins_;
  Rows inertia_factors_;
  Rows species_;
};

// Error: as for World::check, with the row of the sphere as its place.
void check_row(const World& world, const SphereRows& rows, std::size_t row) {
  try {
    world.check(rows[row]);
  } catch (const Error& error) {
    throw Error(error.problem(), "row " + to_text(row) + ": " + error.where(), error.remedy());
  }
}

}  // namespace

SpeciesId species_of(std::uint32_t species) {
  constexpr std::uint32_t kMost = std::numeric_limits<SpeciesId>::max();
  if (species > kMost) throw Error("it is " + to_text(species), "species", "give 0 to " + to_text(kMost));
  return static_cast<SpeciesId>(species);
}

Sphere sphere_of(const hb_sphere* description) {
  const hb_sphere defaults = HB_SPHERE_INIT;
  const hb_sphere sphere = completed(description, defaults, "sphere");
  return {.position = vector_of(sphere.position),
          .velocity = vector_of(sphere.velocity),
          .radius = sphere.radius,
          .mass = sphere.mass,
          .spin = vector_of(sphere.spin),
          .species = species_of(sphere.species),
          .inertia_factor = sphere.inertia_factor};
}

}  // namespace hardball::c

using namespace hardball::c;

hb_status hb_world_new(const hb_setting* setting, hb_world** out) {
  return guarded([&] {
    const hb_setting defaults = HB_SETTING_INIT;
    check_given(out, "out");
    *out = std::make_unique<hb_world>(hb_world{world_of(completed(setting, defaults, "setting"))}).release();
  });
}

void hb_world_free(hb_world* world) {
  delete world;
}

hb_status hb_world_add(hb_world* world, const hb_sphere* sphere, hb_id* id) {
  return guarded([&] {
    const hb_id added = given(world, "world").world.add(sphere_of(sphere));
    if (id != nullptr) *id = added;
  });
}

hb_status hb_world_add_many(hb_world* world, const hb_spheres* spheres, hb_id* first_id) {
  return guarded([&] {
    hardball::World& to = given(world, "world").world;
    const hb_spheres defaults = HB_SPHERES_INIT;
    const hb_spheres arrays = completed(spheres, defaults, "spheres");
    const SphereRows rows(arrays);
    for (std::size_t row = 0; row < arrays.count; ++row) check_row(to, rows, row);
    to.reserve(to.size() + arrays.count);
    hb_id last = 0;
    for (std::size_t row = 0; row < arrays.count; ++row) last = to.add(rows[row]);
    if (arrays.count > 0 && first_id != nullptr) *first_id = static_cast<hb_id>(last - (arrays.count - 1));
  });
}

std::size_t hb_world_size(const hb_world* world) {
  return value_or<std::size_t>(0, [&] { return given(world, "world").world.size(); });
}
