// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/velocities.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hardball {
namespace {

bool is_maxwell(const SphereGroup& group) {
  if (group.is_kinematic) return false;
  return group.velocity_rule == VelocityRule::mean_speed || group.velocity_rule == VelocityRule::temperature;
}

// The standard deviation of each component of a sphere's Maxwell velocity.
double spread(const SphereGroup& group, std::size_t index) {
  if (group.velocity_rule == VelocityRule::temperature) {
    return std::sqrt(group.velocity_scale / group.mass_of(index));
  }
  // The mean speed is sqrt(8 / pi) times that, of discs sqrt(pi / 2) times.
  return group.velocity_scale *
         std::sqrt(group.dimensions == 2 ? 2 / std::numbers::pi : std::numbers::pi / 8);
}

Vec3 draw(const SphereGroup& group, std::size_t index, Random& random) {
  switch (group.velocity_rule) {
    case VelocityRule::listed:
      return group.velocities[index];
    case VelocityRule::speed:
      return group.velocity_scale *
             (group.dimensions == 2 ? random.direction_in_plane() : random.direction());
    case VelocityRule::mean_speed:
    case VelocityRule::temperature:
      break;
  }
  return spread(group, index) * random.normal_vector(group.dimensions);
}

// Calls visit(group, velocities of its spheres) for every group.
template <class Visit>
void for_each_group(std::span<const SphereGroup> groups, std::span<Vec3> velocities, Visit&& visit) {
  for (const SphereGroup& group : groups) {
    visit(group, velocities.first(group.count));
    velocities = velocities.subspan(group.count);
  }
}

double total_mass(const SphereGroup& group) {
  if (!group.density) return group.mass * static_cast<double>(group.count);
  double mass = 0;
  for (std::size_t i = 0; i < group.count; ++i) mass += group.mass_of(i);
  return mass;
}

void remove_drift(std::span<const SphereGroup> groups, std::span<Vec3> velocities) {
  Vec3 momentum;
  double mass = 0;
  for_each_group(groups, velocities, [&](const SphereGroup& group, std::span<Vec3> own) {
    for (std::size_t i = 0; i < own.size(); ++i) momentum += group.mass_of(i) * own[i];
    mass += total_mass(group);
  });
  const Vec3 drift = (1 / mass) * momentum;
  for (Vec3& velocity : velocities) velocity -= drift;
}

// Gives a group of Maxwell velocities exactly the mean it should have.
void scale_to_rule(const SphereGroup& group, std::span<Vec3> velocities) {
  const auto count = static_cast<double>(velocities.size());
  double speeds = 0;
  double squares = 0;  // weighted by the masses relative to that of the first
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    speeds += length(velocities[i]);
    squares += group.mass_of(i) / group.mass_of(0) * dot(velocities[i], velocities[i]);
  }
  if (!(speeds > 0)) return;
  const double factor = group.velocity_rule == VelocityRule::mean_speed
                            ? group.velocity_scale / (speeds / count)
                            : std::sqrt(group.velocity_scale / (group.mass_of(0) * squares / count /
                                                                static_cast<double>(group.dimensions)));
  for (Vec3& velocity : velocities) velocity = factor * velocity;
}

}  // namespace

std::vector<Vec3> draw_velocities(std::span<const SphereGroup> groups, bool without_drift, Random& random) {
  std::size_t count = 0;
  for (const SphereGroup& group : groups) count += group.count;
  std::vector<Vec3> velocities;
  velocities.reserve(count);
  for (const SphereGroup& group : groups) {
    for (std::size_t i = 0; i < group.count; ++i) velocities.push_back(draw(group, i, random));
  }
  const bool removes_drift =
      without_drift && velocities.size() >= 2 && std::all_of(groups.begin(), groups.end(), is_maxwell);
  // Scaling several groups by different factors brings back some momentum, far less in each round.
  const int rounds = removes_drift && groups.size() > 1 ? 20 : 1;
  for (int round = 0; round < rounds; ++round) {
    if (removes_drift) remove_drift(groups, velocities);
    for_each_group(groups, velocities, [](const SphereGroup& group, std::span<Vec3> own) {
      if (is_maxwell(group)) scale_to_rule(group, own);
    });
  }
  return velocities;
}

}  // namespace hardball
