// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/wall_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "hardball/errors/error.hpp"
#include "hardball/measure/units.hpp"

namespace hardball {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<const char*, kFaces> kFaceNames{"x_lower", "x_upper", "y_lower",
                                                     "y_upper", "z_lower", "z_upper"};

// The axis along which a unit vector lies, or kAxes if there is none.
std::size_t axis_along(const Vec3& direction) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (std::fabs(direction[axis]) == 1) return axis;
  }
  return kAxes;
}

double area_of(const Box& box, const Vec3& normal) {
  const std::size_t axis = axis_along(normal);
  return axis < kAxes ? box.face_area(axis) : kNone;
}
double area_of(const Box& box, const Plane& plane) {
  return area_of(box, plane.normal());
}
double area_of(const Box& box, const OscillatingPlane& plane) {
  return area_of(box, plane.normal());
}
double area_of(const Box& box, const Cylinder& cylinder) {
  if (box.is_flat()) return box.sphere_surface(cylinder.radius());
  const std::size_t axis = axis_along(cylinder.axis());
  return axis < kAxes ? 2 * std::numbers::pi * cylinder.radius() * box.size()[axis] : kNone;
}
double area_of(const Box& box, const auto& sphere) {
  return box.sphere_surface(sphere.radius());
}

bool has_only_faces(const World& world) {
  return world.motion().is_straight() && world.surfaces().empty();
}

}  // namespace

double wall_area(const World& world, std::uint32_t wall) {
  if (wall < kFaces) return world.box().face_area(axis_of(wall));
  return std::visit([&](const auto& shape) { return area_of(world.box(), shape); },
                    world.surface(wall).shape());
}

std::string wall_name(const World& world, std::uint32_t wall) {
  if (wall < kFaces) return kFaceNames[wall];
  std::string name(world.surface(wall).name());
  std::replace(name.begin(), name.end(), ' ', '_');
  return name + "_" + to_text(wall - kFaces);
}

std::vector<std::uint32_t> measured_walls(const World& world) {
  std::vector<std::uint32_t> walls;
  if (has_only_faces(world)) return walls;
  for (std::uint32_t wall = 0; wall < kFaces + world.surfaces().size(); ++wall) {
    if (wall >= kFaces || world.box().is_wall(axis_of(wall))) walls.push_back(wall);
  }
  return walls;
}

WallForces::WallForces(const Scene& scene)
    : walls_(measured_walls(scene.world())),
      begin_(scene.now()),
      last_(scene.now()),
      average_(kBins * walls_.size()) {
  places_.resize(kFaces + scene.world().surfaces().size());
  for (std::size_t i = 0; i < walls_.size(); ++i) places_[walls_[i]] = i;
}

void WallForces::advance(const Time& now) {
  average_.close_sample(duration(begin_, now), duration(last_, now));
  last_ = now;
}

void WallForces::note(const Contact& contact) {
  if (contact.is_collision() || walls_.empty()) return;
  advance(contact.time);
  const Vec3 impulse = contact.impulse();
  const Vec3& before = contact.before.first;
  const Vec3& after = contact.after.first;
  const double gained = contact.first_mass * dot(after - before, after + before) / 2;
  const double work = dot(impulse, contact.before.second);
  double* const bins = average_.open_bins(kBins * places_[contact.second]);
  bins[kForce] -= dot(impulse, contact.wall_normal);
  bins[kWork] += work;
  bins[kHeat] += gained - work;
}

Measurement WallForces::result(const Scene& scene) const {
  Measurement found{.name = std::string(kName),
                    .title = "Forces on walls",
                    .formula =
                        R"($F = \frac{1}{t} \sum p$ of the normal impulses $p$; pressure $F / A$ on an area )"
                        R"($A$; power $\frac{1}{t} \sum p u$ at velocities $u$ of the wall; heat: other )"
                        R"(energy given to spheres, over $t$)",
                    .source = "momentum and energy of each contact"};
  if (walls_.empty()) return found;
  WallForces up_to_now = *this;
  up_to_now.advance(scene.now());
  BlockAverage& average = up_to_now.average_;
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    const std::string name = wall_name(scene.world(), walls_[i]);
    const auto add = [&](const char* what, const char* unit, std::size_t bin, double per) {
      const Estimate estimate = average.ratio(kBins * i + bin);
      found.quantities.push_back({name + "_" + what, unit, estimate.value / per, estimate.error / per});
    };
    add("force", "M L T^-2", kForce, 1);
    const double area = wall_area(scene.world(), walls_[i]);
    if (std::isfinite(area)) add("pressure", pressure_unit(scene.world().box()), kForce, area);
    if (walls_[i] < kFaces) continue;
    add("power", "M L^2 T^-3", kWork, 1);
    add("heat", "M L^2 T^-3", kHeat, 1);
  }
  return found;
}

bool WallForces::restored() const {
  const auto is_place = [this](std::size_t place) { return walls_.empty() || place < walls_.size(); };
  const auto is_wall = [this](std::uint32_t wall) { return wall < places_.size(); };
  return average_.has(kBins * walls_.size()) && std::ranges::all_of(places_, is_place) &&
         std::ranges::all_of(walls_, is_wall);
}

bool WallForces::suits(const World& world) const {
  return places_.size() == kFaces + world.surfaces().size();
}

}  // namespace hardball
