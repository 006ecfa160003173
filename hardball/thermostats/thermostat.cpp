// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/thermostats/thermostat.hpp"

#include <cmath>

#include "hardball/geometry/range.hpp"
#include "hardball/world/images.hpp"

namespace hardball {
namespace {

// Below the operating range a component is zero.
void flush(Vec3& velocity) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (std::fabs(velocity[axis]) < kSmallestMagnitude) velocity[axis] = 0;
  }
}

}  // namespace

std::string_view name_of(const ThermostatKind& kind) {
  return std::visit([](const auto& its) { return its.kName; }, kind);
}

void Thermostat::begin(const World& world, const Time& now) {
  events_ = 0;
  energy_ = 0;
  std::visit([&](auto& kind) { kind.begin(world, now.value(), seed_); }, kind_);
}

void Thermostat::note_added(SphereId sphere, const Time& now) {
  const auto add = [&](auto& kind) {
    if constexpr (requires { kind.add(sphere, now.value()); }) kind.add(sphere, now.value());
  };
  std::visit(add, kind_);
}

void Thermostat::note_removed(SphereId sphere) {
  const auto remove = [&](auto& kind) {
    if constexpr (requires { kind.remove(sphere); }) kind.remove(sphere);
  };
  std::visit(remove, kind_);
}

double Thermostat::next() const {
  return std::visit([](const auto& kind) { return kind.next(); }, kind_);
}

std::span<const NewVelocity> Thermostat::act(const World& world, const Time& moment) {
  changes_.clear();
  std::visit([&](auto& kind) { kind.act(world, moment, changes_); }, kind_);
  ++events_;
  for (NewVelocity& change : changes_) {
    flush(change.after);
    Vec3 sum = change.after + change.before;
    if (world.box().is_sheared()) sum -= 2 * flow_velocity(world, change.slot, moment);
    energy_ += world.mass(change.slot) * dot(change.after - change.before, sum) / 2;
  }
  return changes_;
}

}  // namespace hardball
