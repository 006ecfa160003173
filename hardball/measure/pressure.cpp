// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/pressure.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "hardball/measure/units.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/theory/kinetic_theory.hpp"
#include "hardball/world/walls.hpp"

namespace hardball {
namespace {

struct Component {
  std::size_t first;
  std::size_t second;
  const char* name;
};
constexpr std::array<Component, 6> kTensor{
    {{0, 0, "xx"}, {1, 1, "yy"}, {2, 2, "zz"}, {0, 1, "xy"}, {0, 2, "xz"}, {1, 2, "yz"}}};

double trace(Means means, std::size_t begin) {
  return means[begin] + means[begin + 1] + means[begin + 2];
}

// A component that there is not in two dimensions.
bool is_along_z(const Component& component) {
  return component.second == 2;
}

}  // namespace

Pressure::Pressure(const Scene& scene)
    : box_(scene.world().box()),
      dimensions_(static_cast<double>(box_.dimensions())),
      is_homogeneous_(!box_.is_any(Boundary::open) && is_uniform(scene.world())),
      theory_(scene.fluid()),
      motion_(scene.thermal_motion()),
      spheres_(static_cast<double>(scene.world().size())),
      mean_free_time_(mean_free_time(scene.statistics())),
      begin_(scene.now()),
      last_(scene.now()),
      kinetic_(scene) {}

void Pressure::advance(const Time& now) {
  const double elapsed = duration(last_, now);
  last_ = now;
  kinetic_.advance(box_, elapsed, average_.open_bins(kKinetic));
  average_.close_sample(duration(begin_, now), elapsed);
}

void Pressure::record(const VelocityChange& change) {
  if (last_ < change.time) advance(change.time);
  kinetic_.record(box_, change);
}

void Pressure::record(const Contact& contact) {
  advance(contact.time);
  kinetic_.record(box_, contact);
  const Vec3 impulse = contact.impulse();
  if (contact.is_collision()) {
    add_symmetric_product(average_.open_bins(kCollisional), impulse, -1 * contact.separation);
    return;
  }
  if (contact.second >= kFaces) return;
  const std::size_t axis = axis_of(contact.second);
  const double force = std::fabs(impulse[axis]);
  average_.put(kFaceForces + contact.second, force);
  average_.put(kRadii + axis, force * contact.first_radius);
  average_.put(kHits, 1);
}

void Pressure::add_results(const Scene& scene, Measurement& found) const {
  if (!is_homogeneous_) return;
  Pressure up_to_now = *this;
  up_to_now.advance(scene.now());
  const BlockAverage& whole = up_to_now.average_;

  const double volume = box_.volume();
  const char* const unit_of_pressure = pressure_unit(box_);
  const FunctionOfMeans compressibility = [&](Means means) {
    return 1 + trace(means, kCollisional) / trace(means, kKinetic);
  };
  const auto pressure = [&](Means means) {
    return (trace(means, kKinetic) + trace(means, kCollisional)) / (dimensions_ * volume);
  };
  const BlockAverage average = without_transient(whole, std::array{compressibility}, scene, found);
  const double expected =
      is_energy_conserved(motion_, scene.thermal_motion()) ? theory_.compressibility() : kNoNumber;
  const double tolerance = theory_.tolerance() * (expected - 1);
  const double kinetic_pressure = 2 * motion_.energy / (dimensions_ * volume);
  const auto add = [&](std::string name, const char* unit, const Estimate& estimate, double scale) {
    found.add(std::move(name), unit, estimate, scale * expected, scale * tolerance);
  };
  add("compressibility", "1", average.estimate(compressibility), 1);
  add("pressure", unit_of_pressure, average.estimate(pressure), kinetic_pressure);
  if (theory_.is_ideal()) {
    for (Quantity& of_energy_alone : found.quantities) of_energy_alone.error = 0;
  }
  std::optional<Estimate> of_shear;
  for (std::size_t k = 0; k < kComponents; ++k) {
    if (box_.is_flat() && is_along_z(kTensor[k])) continue;
    const bool is_diagonal = kTensor[k].first == kTensor[k].second;
    Estimate estimate = average.estimate(
        [&](Means means) { return (means[kKinetic + k] + means[kCollisional + k]) / volume; });
    const Estimate collisional =
        average.estimate([&](Means means) { return means[kCollisional + k] / volume; });
    const double collisional_error = collisional.value == 0 ? 0 : collisional.error;
    const double elapsed = average.total(BlockAverage::kWeight);
    estimate.error =
        std::fmax(estimate.error, std::hypot(collisional_error, kinetic_error(k, elapsed) / volume));
    add(std::string("pressure_") + kTensor[k].name, unit_of_pressure, estimate,
        is_diagonal ? kinetic_pressure : 0);
    if (k == kXy && box_.shear().rate != 0) of_shear = estimate;
  }
  if (of_shear) add_viscosity(found, average, *of_shear, scene.world().interactions().are_elastic());
  add_walls(found, average);

  found.add_argument("time", "T", whole.middles(begin_.value()));
  found.add("compressibility", "1", whole.history(compressibility));
  found.add("pressure", unit_of_pressure, whole.history(pressure));
}

// The shear stress over the rate of the shear.
void Pressure::add_viscosity(Measurement& found, const BlockAverage& average, const Estimate& pressure_xy,
                             bool is_elastic) const {
  const double rate = box_.shear().rate;
  const double kinetic = average.mean(kKinetic) + average.mean(kKinetic + 1) + average.mean(kKinetic + 2);
  const double expected = is_elastic ? theory_.viscosity(kinetic / (dimensions_ * spheres_)) : kNoNumber;
  found.add("viscosity", viscosity_unit(box_),
            Estimate{-pressure_xy.value / rate, pressure_xy.error / std::fabs(rate)}, expected,
            kForComparison);
}

// The standard deviation of a component of the kinetic part, averaged over some time [M L^2 T^-2]. At one
// time it is that of independent spheres that share a fixed energy; it is forgotten within 5/4 mean free
// times, in two dimensions within one: the ratio of viscosity to pressure of a dilute gas. Source: Chapman
// and Cowling, The Mathematical Theory of Non-Uniform Gases, section 10.2.
double Pressure::kinetic_error(std::size_t component, double elapsed) const {
  const bool is_diagonal = kTensor[component].first == kTensor[component].second;
  const double variance = spheres_ * (is_diagonal ? 2 * (1 - 1 / dimensions_) : 1);
  // Spheres that pass through each other forget nothing.
  const double x = theory_.is_ideal() ? 0 : elapsed / ((box_.is_flat() ? 1 : 1.25) * mean_free_time_);
  const double forgotten = x > 1e-3 ? 2 * (x + std::expm1(-x)) / (x * x) : 1;
  return motion_.temperature() * std::sqrt(variance * forgotten);
}

// The virial theorem: along an axis with walls, the kinetic and collisional parts equal the force on a face
// times the length open to the centers, averaged over those that hit it.
void Pressure::add_walls(Measurement& found, const BlockAverage& average) const {
  const auto area = [&](std::size_t axis) { return box_.face_area(axis); };
  const auto force = [](Means means, std::size_t axis) {
    return (means[kFaceForces + face_of(axis, false)] + means[kFaceForces + face_of(axis, true)]) / 2;
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
    found.add(std::move(name), unit, average.estimate(at_walls), average.estimate(from_inside).value);
  };
  add(
      "compressibility_from_walls", "1",
      [&](Means means) {
        const auto virial = [&](std::size_t axis) { return force(means, axis) * open_length(means, axis); };
        return dimensions_ / axes * sum_over_walls(virial) / trace(means, kKinetic);
      },
      [&](Means means) {
        return dimensions_ / axes * sum_over_walls([&](std::size_t axis) { return inside(means, axis); }) /
               trace(means, kKinetic);
      });
  add(
      "wall_pressure", pressure_unit(box_),
      [&](Means means) {
        return sum_over_walls([&](std::size_t axis) { return force(means, axis); }) / areas;
      },
      [&](Means means) {
        const auto expected = [&](std::size_t axis) {
          return inside(means, axis) / open_length(means, axis);
        };
        return sum_over_walls(expected) / areas;
      });
  double impulse = 0;
  for (Face face = 0; face < 2 * kAxes; ++face) impulse += average.total(kFaceForces + face);
  for (Face face = 0; face < 2 * kAxes; ++face) {
    const std::size_t axis = axis_of(face);
    if (!box_.is_wall(axis)) continue;
    add(
        "wall_pressure_" + std::string(kFaceNames[face]), pressure_unit(box_),
        [&](Means means) { return means[kFaceForces + face] / area(axis); },
        [&](Means means) { return inside(means, axis) / (open_length(means, axis) * area(axis)); });
    // One more hit is allowed for: see BlockAverage::histogram.
    const double of_one = impulse / average.total(kHits) / area(axis) / average.total(BlockAverage::kWeight);
    found.quantities.back().error = std::hypot(found.quantities.back().error, of_one);
  }
}

}  // namespace hardball
