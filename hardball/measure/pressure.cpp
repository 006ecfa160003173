// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/pressure.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace hardball {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kPressureUnit = "M L^-1 T^-2";

struct Component {
  std::size_t first;
  std::size_t second;
  const char* name;
};
constexpr std::array<Component, 6> kTensor{
    {{0, 0, "xx"}, {1, 1, "yy"}, {2, 2, "zz"}, {0, 1, "xy"}, {0, 2, "xz"}, {1, 2, "yz"}}};

constexpr std::array<const char*, 2 * kAxes> kFaceNames{"x_lower", "x_upper", "y_lower",
                                                        "y_upper", "z_lower", "z_upper"};

bool has_open_axis(const Box& box) {
  return box.is_open(0) || box.is_open(1) || box.is_open(2);
}

}  // namespace

Pressure::Pressure(const World& world, const Time& now)
    : box_(world.box()),
      theory_(world, Species(world)),
      energy_(world),
      spheres_(static_cast<double>(world.size())),
      begin_(now),
      last_(now) {
  world.for_each_by_id([&](Slot slot) {
    const Vec3 velocity = world.path(slot).velocity - energy_.start().drift;
    for (std::size_t k = 0; k < kComponents; ++k) {
      kinetic_[k] += world.mass(slot) * velocity[kTensor[k].first] * velocity[kTensor[k].second];
    }
  });
}

void Pressure::advance(const Time& now) {
  const double elapsed = duration(last_, now);
  last_ = now;
  for (std::size_t k = 0; k < kComponents; ++k) average_.put(kKinetic + k, kinetic_[k] * elapsed);
  average_.close_sample(elapsed);
}

void Pressure::note(const Contact& contact) {
  advance(contact.time);
  energy_.note(contact);
  const Vec3& drift = energy_.start().drift;
  const auto change_kinetic = [&](double mass, const Vec3& before, const Vec3& after) {
    const Vec3 v = before - drift;
    const Vec3 w = after - drift;
    kinetic_[0] += mass * (w.x * w.x - v.x * v.x);
    kinetic_[1] += mass * (w.y * w.y - v.y * v.y);
    kinetic_[2] += mass * (w.z * w.z - v.z * v.z);
    kinetic_[3] += mass * (w.x * w.y - v.x * v.y);
    kinetic_[4] += mass * (w.x * w.z - v.x * v.z);
    kinetic_[5] += mass * (w.y * w.z - v.y * v.z);
  };
  change_kinetic(contact.first_mass, contact.before.first, contact.after.first);
  const Vec3 impulse = contact.impulse();
  if (!contact.is_collision()) {
    const std::size_t axis = axis_of(contact.second);
    const double force = std::fabs(impulse[axis]);
    average_.put(kFaces + contact.second, force);
    average_.put(kRadii + axis, force * contact.first_radius);
    return;
  }
  change_kinetic(contact.second_mass, contact.before.second, contact.after.second);
  const Vec3& r = contact.separation;
  average_.put(kCollisional + 0, -r.x * impulse.x);
  average_.put(kCollisional + 1, -r.y * impulse.y);
  average_.put(kCollisional + 2, -r.z * impulse.z);
  average_.put(kCollisional + 3, -(r.x * impulse.y + r.y * impulse.x) / 2);
  average_.put(kCollisional + 4, -(r.x * impulse.z + r.z * impulse.x) / 2);
  average_.put(kCollisional + 5, -(r.y * impulse.z + r.z * impulse.y) / 2);
}

Measurement Pressure::result(const Time& now) const {
  Measurement found{.name = std::string(kName),
                    .title = "Pressure",
                    .formula = "P = (sum m v v + sum over collisions r dp / t) / V, Z = 3 P V / sum m v^2",
                    .source =
                        "Allen and Tildesley, Computer Simulation of Liquids, section 2.4; theory of "
                        "equal spheres: Kolafa, Labik and Malijevsky, Phys. Chem. Chem. Phys. 6 (2004) "
                        "2335; of mixtures: Mansoori et al., J. Chem. Phys. 54 (1971) 1523"};
  if (has_open_axis(box_)) return found;
  Pressure up_to_now = *this;
  up_to_now.advance(now);
  const BlockAverage& average = up_to_now.average_;

  const auto trace = [](std::span<const double> means, std::size_t begin) {
    return means[begin] + means[begin + 1] + means[begin + 2];
  };
  const double volume = box_.volume();
  const auto compressibility = [&](std::span<const double> means) {
    return 1 + trace(means, kCollisional) / trace(means, kKinetic);
  };
  const auto pressure = [&](std::span<const double> means) {
    return (trace(means, kKinetic) + trace(means, kCollisional)) / (3 * volume);
  };
  // With the total momentum fixed n spheres have n - 1 times three degrees of freedom, and meet a little
  // faster than their mean energy says.
  const double excess = (theory_.compressibility() - 1) * spheres_ / (spheres_ - 1);
  const double expected = energy_.is_conserved() ? 1 + excess : kNone;
  const double kinetic_pressure = 2 * energy_.start().energy / (3 * volume);
  const auto add = [&](std::string name, const char* unit, const FunctionOfMeans& quantity, double theory) {
    const Estimate estimate = average.estimate(quantity);
    found.quantities.push_back({std::move(name), unit, estimate.value, estimate.error, theory});
  };
  add("compressibility", "1", compressibility, expected);
  add("pressure", kPressureUnit, pressure, expected * kinetic_pressure);
  for (std::size_t k = 0; k < kComponents; ++k) {
    const bool is_diagonal = kTensor[k].first == kTensor[k].second;
    add(
        std::string("pressure_") + kTensor[k].name, kPressureUnit,
        [&](std::span<const double> means) {
          return (means[kKinetic + k] + means[kCollisional + k]) / volume;
        },
        is_diagonal ? expected * kinetic_pressure : expected * 0);
  }
  add_walls(found, average);

  found.columns = {
      {"time", "T", ColumnRole::argument, average.middles()},
      {"compressibility", "1", ColumnRole::value, average.history(compressibility)},
      {"pressure", kPressureUnit, ColumnRole::value, average.history(pressure)},
  };
  for (double& time : found.columns.front().values) time += begin_.value();
  return found;
}

// The virial theorem: along an axis with walls, what spheres carry and collisions hand on equals the force on
// a face times the length open to the centres, in the mean over those that hit it.
void Pressure::add_walls(Measurement& found, const BlockAverage& average) const {
  using Means = std::span<const double>;
  const auto area = [&](std::size_t axis) { return box_.volume() / box_.size()[axis]; };
  const auto force = [](Means means, std::size_t axis) {
    return (means[kFaces + face_of(axis, false)] + means[kFaces + face_of(axis, true)]) / 2;
  };
  const auto open_length = [&](Means means, std::size_t axis) {
    const double hits = force(means, axis);
    return box_.size()[axis] - (hits > 0 ? means[kRadii + axis] / hits : 0);
  };
  const auto inside = [](Means means, std::size_t axis) {
    return means[kKinetic + axis] + means[kCollisional + axis];
  };
  const auto sum_over_walls = [&](const auto& of_axis) {
    double sum = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (box_.is_wall(axis)) sum += of_axis(axis);
    }
    return sum;
  };
  const double axes = sum_over_walls([](std::size_t) { return 1; });
  if (axes == 0) return;
  const double areas = sum_over_walls(area);
  const auto add = [&](std::string name, const char* unit, const FunctionOfMeans& at_walls,
                       const FunctionOfMeans& from_inside) {
    const Estimate estimate = average.estimate(at_walls);
    const double expected = average.estimate(from_inside).value;
    found.quantities.push_back({std::move(name), unit, estimate.value, estimate.error, expected});
  };
  const auto kinetic = [](Means means) {
    return means[kKinetic] + means[kKinetic + 1] + means[kKinetic + 2];
  };
  add(
      "compressibility_from_walls", "1",
      [&](Means means) {
        const auto virial = [&](std::size_t axis) { return force(means, axis) * open_length(means, axis); };
        return 3 / axes * sum_over_walls(virial) / kinetic(means);
      },
      [&](Means means) {
        return 3 / axes * sum_over_walls([&](std::size_t axis) { return inside(means, axis); }) /
               kinetic(means);
      });
  add(
      "wall_pressure", kPressureUnit,
      [&](Means means) {
        return sum_over_walls([&](std::size_t axis) { return force(means, axis); }) / areas;
      },
      [&](Means means) {
        const auto expected = [&](std::size_t axis) {
          return inside(means, axis) / open_length(means, axis);
        };
        return sum_over_walls(expected) / areas;
      });
  for (Face face = 0; face < 2 * kAxes; ++face) {
    const std::size_t axis = axis_of(face);
    if (!box_.is_wall(axis)) continue;
    add(
        std::string("wall_pressure_") + kFaceNames[face], kPressureUnit,
        [&](Means means) { return means[kFaces + face] / area(axis); },
        [&](Means means) { return inside(means, axis) / (open_length(means, axis) * area(axis)); });
  }
}

}  // namespace hardball
