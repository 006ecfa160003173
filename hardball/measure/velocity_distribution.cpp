// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/velocity_distribution.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace hardball {
namespace {

// The chance of a component, or of a speed, below c.
double component_below(double c) {
  return std::erfc(-c / std::numbers::sqrt2) / 2;
}
double speed_below(double c) {
  return std::erf(c / std::numbers::sqrt2) - std::sqrt(2 / std::numbers::pi) * c * std::exp(-c * c / 2);
}

}  // namespace

VelocityDistribution::VelocityDistribution(const Scene& scene)
    : spheres_(static_cast<double>(scene.world().size())),
      degrees_of_freedom_(scene.motion().degrees_of_freedom) {}

void VelocityDistribution::sample(const Scene& scene) {
  const World& world = scene.world();
  const ThermalMotion& motion = scene.motion();
  const double temperature = motion.temperature();
  if (!(temperature > 0)) return;
  const double share = 1 / spheres_;
  double square_sum = 0;
  double fourth_sum = 0;
  double speed_sum = 0;
  double expected_sum = 0;
  world.for_each_by_id([&](Slot slot) {
    const Vec3 velocity = world.path(slot).velocity - motion.drift;
    const double unit = std::sqrt(temperature / world.mass(slot));
    const Vec3 c = (1 / unit) * velocity;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double bin = (c[axis] + kEdge) / kWidth;
      if (bin >= 0 && bin < kBins) {
        average_.put(kComponents + static_cast<std::size_t>(bin), share / kAxes / kWidth);
      }
    }
    const double square = dot(c, c);
    const double speed = std::sqrt(square);
    if (speed < kEdge) average_.put(kSpeeds + static_cast<std::size_t>(speed / kWidth), share / kWidth);
    square_sum += square;
    fourth_sum += square * square;
    speed_sum += speed * unit;
    expected_sum += unit;
  });
  average_.put(kSquare, square_sum * share);
  average_.put(kFourth, fourth_sum * share);
  average_.put(kMeanSpeed, speed_sum * share);
  average_.put(kExpectedSpeed, std::sqrt(8 / std::numbers::pi) * expected_sum * share);
  average_.close_sample();
}

Measurement VelocityDistribution::result(const Scene& /*scene*/) const {
  Measurement found{
      .name = std::string(kName),
      .title = "Velocity distribution",
      .formula =
          "Densities of the components and of the size of c = v / sqrt(kT / m); theory: "
          "Maxwell's, exp(-c^2 / 2) / sqrt(2 pi) and sqrt(2 / pi) c^2 exp(-c^2 / 2)",
      .source = "Chapman and Cowling, The Mathematical Theory of Non-Uniform Gases, section 4.1"};
  const Estimate kurtosis = average_.estimate(
      [](std::span<const double> means) { return means[kFourth] / (means[kSquare] * means[kSquare]); });
  // 5/3 for many spheres; exact where the energy is fixed.
  const double freedom = degrees_of_freedom_;
  found.quantities = {
      {"speed_kurtosis", "1", kurtosis.value, kurtosis.error, 5.0 / 3 * freedom / (freedom + 2)},
      {"mean_speed", "L T^-1", average_.mean(kMeanSpeed), average_.error(kMeanSpeed),
       average_.mean(kExpectedSpeed)}};
  Column argument{"reduced_velocity", "1", ColumnRole::argument, {}};
  Column component{"component_density", "1", ColumnRole::value, {}};
  Column component_error{"component_density_error", "1", ColumnRole::error, {}};
  Column component_theory{"component_density_theory", "1", ColumnRole::theory, {}};
  Column speed{"speed_density", "1", ColumnRole::value, {}};
  Column speed_error{"speed_density_error", "1", ColumnRole::error, {}};
  Column speed_theory{"speed_density_theory", "1", ColumnRole::theory, {}};
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    const double low = (static_cast<double>(bin) - kBins / 2) * kWidth;
    const double high = (static_cast<double>(bin + 1) - kBins / 2) * kWidth;
    argument.values.push_back((low + high) / 2);
    component.values.push_back(average_.mean(kComponents + bin));
    component_error.values.push_back(average_.error(kComponents + bin));
    component_theory.values.push_back((component_below(high) - component_below(low)) / kWidth);
    const bool is_speed = bin >= kBins / 2;
    speed.values.push_back(is_speed ? average_.mean(kSpeeds + bin - kBins / 2) : kNone);
    speed_error.values.push_back(is_speed ? average_.error(kSpeeds + bin - kBins / 2) : kNone);
    speed_theory.values.push_back(is_speed ? (speed_below(high) - speed_below(low)) / kWidth : kNone);
  }
  found.columns = {std::move(argument),         std::move(component), std::move(component_error),
                   std::move(component_theory), std::move(speed),     std::move(speed_error),
                   std::move(speed_theory)};
  return found;
}

}  // namespace hardball
