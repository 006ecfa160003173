// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/wall_forces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "hardball/errors/error.hpp"
#include "hardball/measure/energy_gain.hpp"
#include "hardball/measure/units.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/world/walls.hpp"

namespace hardball {
namespace {

// The part of the momentum that a contact gives to its wall along the wall [M L/T]; zero if it is no more
// than rounding, as of smooth spheres on a plane that is not along the axes.
Vec3 tangential_impulse(const Contact& contact) {
  constexpr double kRounding = 1e-12;
  const Vec3 impulse = contact.impulse();
  const Vec3 along = dot(impulse, contact.wall_normal) * contact.wall_normal - impulse;
  return dot(along, along) <= kRounding * kRounding * dot(impulse, impulse) ? Vec3{} : along;
}

}  // namespace

double wall_area(const World& world, std::uint32_t wall) {
  if (wall < kFaces) return world.box().face_area(axis_of(wall));
  return std::visit(
      [&](const auto& shape) {
        if constexpr (requires { shape.area(world.box()); }) return shape.area(world.box());
        return kNoNumber;
      },
      world.surface(wall).shape());
}

std::string wall_name(const World& world, std::uint32_t wall) {
  if (wall < kFaces) return std::string(kFaceNames[wall]);
  std::string name(world.surface(wall).name());
  std::replace(name.begin(), name.end(), ' ', '_');
  return name + "_" + to_text(wall - kFaces);
}

std::vector<std::uint32_t> measured_walls(const World& world) {
  std::vector<std::uint32_t> walls;
  if (is_uniform(world)) return walls;
  for (std::uint32_t wall = 0; wall < kFaces + world.surfaces().size(); ++wall) {
    if (wall >= kFaces || world.box().is_wall(axis_of(wall))) walls.push_back(wall);
  }
  return walls;
}

WallForces::WallForces(const Scene& scene)
    : walls_(measured_walls(scene.world())),
      begin_(scene.now()),
      last_(scene.now()),
      average_(kBins * walls_.size() + 1),
      along_(kAxes * walls_.size()) {
  indices_.resize(kFaces + scene.world().surfaces().size());
  for (std::size_t i = 0; i < walls_.size(); ++i) indices_[walls_[i]] = i;
}

void WallForces::advance(const Time& now) {
  average_.close_sample(duration(begin_, now), duration(last_, now));
  along_.close_sample(duration(begin_, now), duration(last_, now));
  last_ = now;
}

void WallForces::record(const VelocityChange& change) {
  if (!walls_.empty()) average_.put(stored_bin(), energy_gain(change.mass, change.before, change.after));
}

void WallForces::record(const Contact& contact) {
  if (walls_.empty()) return;
  if (contact.is_collision()) {
    average_.put(stored_bin(), energy_gain_of_both(contact));
    return;
  }
  advance(contact.time);
  const double gained = energy_gain_of_first(contact);
  average_.put(stored_bin(), gained);
  const Vec3 impulse = contact.impulse();
  const double work = dot(impulse, contact.before.second);
  double* const bins = average_.open_bins(kBins * indices_[contact.second]);
  bins[kForce] -= dot(impulse, contact.wall_normal);
  bins[kWork] += work;
  bins[kHeat] += gained - work;
  const Vec3 tangential = tangential_impulse(contact);
  double* const along = along_.open_bins(kAxes * indices_[contact.second]);
  for (std::size_t axis = 0; axis < kAxes; ++axis) along[axis] += tangential[axis];
}

void WallForces::add_results(const Scene& scene, Measurement& found) const {
  if (walls_.empty()) return;
  WallForces up_to_now = *this;
  up_to_now.advance(scene.now());
  const BlockAverage& average = up_to_now.average_;
  const BlockAverage& along = up_to_now.along_;
  const Box& box = scene.world().box();
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    const std::string name = wall_name(scene.world(), walls_[i]);
    const auto add = [&](const std::string& what, const char* unit, const Estimate& estimate) {
      found.add(name + "_" + what, unit, estimate);
    };
    const Estimate force = average.ratio(kBins * i + kForce);
    const double area = wall_area(scene.world(), walls_[i]);
    add("force", "M L T^-2", force);
    if (std::isfinite(area)) add("pressure", pressure_unit(box), force / area);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const Estimate tangential = along.ratio(kAxes * i + axis);
      if (tangential.value == 0) continue;  // smooth
      const std::string suffix = std::string("_") + kAxisNames[axis];
      add("tangential_force" + suffix, "M L T^-2", tangential);
      if (std::isfinite(area)) add("shear_stress" + suffix, pressure_unit(box), tangential / area);
    }
    if (walls_[i] < kFaces && !box.has_own_properties(walls_[i])) continue;
    add("power", "M L^2 T^-3", average.exchange(kBins * i + kWork, stored_bin()));
    add("heat", "M L^2 T^-3", average.exchange(kBins * i + kHeat, stored_bin()));
  }
}

bool WallForces::restored() const {
  const auto is_index = [this](std::size_t index) { return walls_.empty() || index < walls_.size(); };
  const auto is_wall = [this](std::uint32_t wall) { return wall < indices_.size(); };
  return average_.has(kBins * walls_.size() + 1) && along_.has(kAxes * walls_.size()) &&
         std::ranges::all_of(indices_, is_index) && std::ranges::all_of(walls_, is_wall);
}

}  // namespace hardball
