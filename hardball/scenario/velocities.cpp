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

double total_mass(const SphereGroup& group) {
  if (!group.density && group.masses.empty()) return group.mass * static_cast<double>(group.count);
  double mass = 0;
  for (std::size_t i = 0; i < group.count; ++i) mass += group.mass_of(i);
  return mass;
}

}  // namespace

DrawnVelocities::DrawnVelocities(std::span<const SphereGroup> groups, bool without_drift, Random& random,
                                 Memory memory)
    : groups_(groups), before_(random), are_kept_(memory == Memory::all) {
  std::size_t count = 0;
  for (const SphereGroup& group : groups) count += group.count;
  if (are_kept_) kept_.reserve(count);
  for (const SphereGroup& group : groups) {
    for (std::size_t i = 0; i < group.count; ++i) {
      const Vec3 velocity = draw(group, i, random);
      if (are_kept_) kept_.push_back(velocity);
    }
  }
  const bool removes_drift =
      without_drift && count >= 2 && std::all_of(groups.begin(), groups.end(), is_maxwell);
  // Scaling several groups by different factors brings back some momentum, far less in each round.
  const int rounds = removes_drift && groups.size() > 1 ? 20 : 1;
  for (int round = 0; round < rounds; ++round) {
    if (removes_drift) remove_drift();
    for (const SphereGroup& group : groups) {
      if (is_maxwell(group)) scale_to_rule(group);
    }
  }
}

std::vector<Vec3> draw_velocities(std::span<const SphereGroup> groups, bool without_drift, Random& random) {
  const DrawnVelocities drawn(groups, without_drift, random, DrawnVelocities::Memory::all);
  std::vector<Vec3> velocities;
  drawn.for_each(
      [&](const SphereGroup&, std::size_t, const Vec3& velocity) { velocities.push_back(velocity); });
  return velocities;
}

void DrawnVelocities::for_each(
    const Function<void(const SphereGroup&, std::size_t, const Vec3&)>& visit) const {
  Random random = before_;
  std::size_t next = 0;
  for (const SphereGroup& group : groups_) {
    for (std::size_t i = 0; i < group.count; ++i, ++next) {
      if (are_kept_) {
        visit(group, i, kept_[next]);
        continue;
      }
      Vec3 velocity = draw(group, i, random);
      for (const Adjustment& adjustment : adjustments_) adjustment.apply_to(group, velocity);
      visit(group, i, velocity);
    }
  }
}

void DrawnVelocities::Adjustment::apply_to(const SphereGroup& its_group, Vec3& velocity) const {
  if (!group) {
    velocity -= drift;
  } else if (group == &its_group) {
    velocity = factor * velocity;
  }
}

void DrawnVelocities::adjust(const Adjustment& adjustment) {
  if (!are_kept_) return adjustments_.push_back(adjustment);
  std::size_t next = 0;
  for (const SphereGroup& group : groups_) {
    for (std::size_t i = 0; i < group.count; ++i, ++next) adjustment.apply_to(group, kept_[next]);
  }
}

void DrawnVelocities::remove_drift() {
  Vec3 momentum;
  for_each([&](const SphereGroup& group, std::size_t i, const Vec3& velocity) {
    momentum += group.mass_of(i) * velocity;
  });
  double mass = 0;
  for (const SphereGroup& group : groups_) mass += total_mass(group);
  adjust({nullptr, (1 / mass) * momentum, 1});
}

// Gives a group of Maxwell velocities exactly the mean it should have.
void DrawnVelocities::scale_to_rule(const SphereGroup& group) {
  double speeds = 0;
  double squares = 0;  // weighted by the masses relative to that of the first
  for_each([&](const SphereGroup& its_group, std::size_t i, const Vec3& velocity) {
    if (&its_group != &group) return;
    speeds += length(velocity);
    squares += group.mass_of(i) / group.mass_of(0) * dot(velocity, velocity);
  });
  if (!(speeds > 0)) return;
  const auto count = static_cast<double>(group.count);
  const double factor = group.velocity_rule == VelocityRule::mean_speed
                            ? group.velocity_scale / (speeds / count)
                            : std::sqrt(group.velocity_scale / (group.mass_of(0) * squares / count /
                                                                static_cast<double>(group.dimensions)));
  adjust({&group, {}, factor});
}

}  // namespace hardball
