// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/interaction/thermal_wall.hpp"

#include <cmath>

#include "hardball/numbers/random.hpp"
#include "hardball/standard/bit_cast.hpp"

namespace hardball {
namespace {

std::uint64_t mixed(std::uint64_t key, std::uint64_t word) {
  key = (key ^ word) * 0x9e3779b97f4a7c15;
  return key ^ (key >> 29);
}

// One of the axes that is far from parallel to a unit vector.
Vec3 axis_across(const Vec3& normal) {
  const double x = std::fabs(normal.x);
  const double y = std::fabs(normal.y);
  const double z = std::fabs(normal.z);
  if (x <= y && x <= z) return {1, 0, 0};
  return y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
}

}  // namespace

Vec3 rethermalized(const Contact& contact) {
  std::uint64_t key = mixed(contact.wall_material.seed, contact.first);
  key = mixed(key, contact.second);
  key = mixed(key, bit_cast<std::uint64_t>(contact.time.high));
  key = mixed(key, bit_cast<std::uint64_t>(contact.time.low));
  Random random(key);
  const double scale = std::sqrt(*contact.wall_material.temperature / contact.first_mass);
  const double away = scale * std::sqrt(-2 * portable_log(1 - random.uniform()));
  const double along = scale * random.normal();
  const double across = scale * random.normal();
  const Vec3& normal = contact.wall_normal;
  Vec3 first = cross(normal, axis_across(normal));
  first = (1 / length(first)) * first;
  const Vec3 second = cross(normal, first);
  Vec3 velocity = contact.before.second + (along * first + across * second) - away * normal;
  // Of the two directions along a wall that is upright on the plane, one is z.
  if (contact.wall_material.is_flat) velocity.z = 0;
  return velocity;
}

}  // namespace hardball
