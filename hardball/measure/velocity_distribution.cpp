// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/velocity_distribution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "hardball/numbers/no_number.hpp"
#include "hardball/statistics/transient.hpp"
#include "hardball/world/images.hpp"

namespace hardball {
namespace {

// The probability of a component, or of a speed, below c.
double component_below(double c) {
  return std::erfc(-c / std::numbers::sqrt2) / 2;
}
double speed_below(double c, std::size_t dimensions) {
  if (dimensions == 2) return -std::expm1(-c * c / 2);
  return std::erf(c / std::numbers::sqrt2) - std::sqrt(2 / std::numbers::pi) * c * std::exp(-c * c / 2);
}

}  // namespace

VelocityDistribution::VelocityDistribution(const Scene& scene)
    : spheres_(static_cast<double>(scene.world().size())),
      dimensions_(scene.world().box().dimensions()),
      motion_(scene.thermal_motion()),
      begin_(scene.now()),
      average_(kAllBins, kSphereGroups) {}

void VelocityDistribution::sample(const Scene& scene) {
  const World& world = scene.world();
  const ThermalMotion& motion = scene.thermal_motion();
  const double temperature = motion.temperature();
  if (!(temperature > 0)) return;
  // What a sphere has of the motion of the center of mass, along the axes on which it counts as drift, is
  // missing in its own.
  const double drifting = 1 - motion.degrees_of_freedom / (static_cast<double>(dimensions_) * spheres_);
  double mass = 0;
  world.for_each_by_id([&](Slot slot) { mass += world.mass(slot); });
  std::size_t rank = 0;
  world.for_each_by_id([&](Slot slot) {
    const Vec3 velocity = peculiar_velocity(world, slot, scene.now()) - motion.drift;
    const double unit = std::sqrt(temperature / world.mass(slot));
    const Vec3 c = (1 / unit) * velocity;
    double* const sums = average_.open_bins(0, group_of(rank++));
    for (std::size_t axis = 0; axis < dimensions_; ++axis) {
      const double bin = (c[axis] + kEdge) / kWidth;
      if (bin >= 0 && bin < kBins) ++sums[kComponents + static_cast<std::size_t>(bin)];
    }
    const double square = dot(c, c);
    const double speed = std::sqrt(square);
    if (speed < kEdge) ++sums[kSpeeds + static_cast<std::size_t>(speed / kWidth)];
    ++sums[kSpheres];
    sums[kSquare] += square;
    sums[kFourth] += square * square;
    sums[kSpeed] += speed * unit;
    const double own = drifting > 0 ? 1 - drifting * spheres_ * world.mass(slot) / mass : 1;
    sums[kExpectedSpeed] += unit * std::sqrt(own);
  });
  average_.close_sample(duration(begin_, scene.now()));
}

Measurement VelocityDistribution::result(const Scene& scene) const {
  Measurement found{
      .name = std::string(kName),
      .title = "Velocity distribution",
      .formula =
          R"(densities of the components and the magnitude of $\mathbf{c} = \mathbf{v} / \sqrt{kT / m}$; )"
          R"(theory: Maxwell's, $\frac{1}{\sqrt{2\pi}} \, e^{-c^2 / 2}$ and $\sqrt{2 / \pi} \, c^2 )"
          R"(e^{-c^2 / 2}$, in two dimensions $c \, e^{-c^2 / 2}$)",
      .source = "Chapman and Cowling, The Mathematical Theory of Non-Uniform Gases, section 4.1"};
  using Means = std::span<const double>;
  const FunctionOfMeans kurtosis_of = [](Means means) {
    return means[kFourth] * means[kSpheres] / (means[kSquare] * means[kSquare]);
  };
  const Transient transient =
      find_transient(average_, std::array{kurtosis_of}, scene.settled(), BlockAverage::Groups::exchanging);
  const BlockAverage average = transient.left_out_of(average_);
  const bool is_conserved = is_energy_conserved(motion_, scene.thermal_motion());
  // 5/3 for many spheres, 2 for many discs; exact where the energy is fixed.
  const double freedom = motion_.degrees_of_freedom;
  const auto dimensions = static_cast<double>(dimensions_);
  const double of_many = (dimensions + 2) / dimensions;
  const double mean_of_maxwell = dimensions_ == 2 ? std::numbers::pi / 2 : 8 / std::numbers::pi;
  // Faces that heat or drag the spheres keep them out of equilibrium.
  const double theory = scene.world().box().has_plain_faces() ? 1 : kNoNumber;
  const double tolerance = scene.has_equilibrium(motion_) ? 0 : kForComparison;
  found.add("speed_kurtosis", "1", average.estimate(kurtosis_of, BlockAverage::Groups::exchanging),
            theory * of_many * freedom / (freedom + 2), tolerance);
  found.add("mean_speed", "L T^-1", mean_speed(average, kSpeed, kSquare, kSpheres, is_conserved),
            theory * std::sqrt(mean_of_maxwell) * mean_over_normal(freedom) *
                average.ratio(kExpectedSpeed, kSpheres).value,
            tolerance);
  std::vector<Estimate> components = average.histogram(kComponents, kBins, kSpheres);
  // There are no negative speeds.
  std::vector<Estimate> speeds(kBins / 2);
  std::ranges::copy(average.histogram(kSpeeds, kBins / 2, kSpheres), std::back_inserter(speeds));
  std::vector<double> argument;
  std::vector<double> component_theory;
  std::vector<double> speed_theory;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    const double low = (static_cast<double>(bin) - kBins / 2) * kWidth;
    const double high = (static_cast<double>(bin + 1) - kBins / 2) * kWidth;
    argument.push_back((low + high) / 2);
    components[bin] = components[bin] / dimensions / kWidth;
    component_theory.push_back(theory * (component_below(high) - component_below(low)) / kWidth);
    speeds[bin] = speeds[bin] / kWidth;
    const double of_speed = speed_below(high, dimensions_) - speed_below(low, dimensions_);
    speed_theory.push_back(bin >= kBins / 2 ? theory * of_speed / kWidth : kNoNumber);
  }
  found.add_argument("reduced_velocity", "1", std::move(argument));
  found.add_estimates("component_density", "1", components);
  found.add_theory(std::move(component_theory));
  found.add_estimates("speed_density", "1", speeds);
  found.add_theory(std::move(speed_theory));
  transient.note_in(found);
  return found;
}

}  // namespace hardball
