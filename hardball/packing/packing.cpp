// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/packing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/packing/crystalline_share.hpp"
#include "hardball/packing/jamming.hpp"
#include "hardball/packing/protocol.hpp"

namespace hardball {
namespace {

using Status = Packing::Status;

// Where the forces of a packing at this pressure are, gaps are smaller: they are 2 d / Z of the diameter on
// average, and wider where forces are weak.
double contact_tolerance(double pressure) {
  constexpr double kResolved = 1e3;
  constexpr double kWidest = 30;
  constexpr double kLeast = 1e-6;
  return pressure > kResolved ? std::max(kLeast, kWidest / pressure) : 0;
}

PackedSpheres spheres_of(const Packer& packer) {
  const Simulation& simulation = packer.simulation();
  PackedSpheres spheres{packer.plan().container, simulation.positions(), {}};
  const World& world = simulation.world();
  spheres.radii.resize(world.size());
  for (Slot slot = 0; slot < world.size(); ++slot)
    spheres.radii[world.id(slot)] = world.radius(slot, simulation.now());
  return spheres;
}

// Makes all lengths of a packing so many times as large.
void multiply(Packing& packing, double factor) {
  PackedSpheres& spheres = packing.spheres;
  spheres.container = spheres.container.scaled(factor);
  for (Vec3& position : spheres.positions) position = factor * position;
  for (double& radius : spheres.radii) radius *= factor;
  for (PackingContact& contact : packing.network.contacts) {
    contact.gap *= factor;
    contact.separation = factor * contact.separation;
  }
}

void round_to_singles(PackedSpheres& spheres) {
  Container& container = spheres.container;
  for (std::size_t axis = 0; axis < container.dimensions; ++axis) {
    const auto edge = static_cast<float>(container.size[axis]);
    const double center = container.size[axis] / 2;
    container.size[axis] = static_cast<double>(edge);
    for (Vec3& position : spheres.positions) {
      auto from_center = static_cast<float>(position[axis] - center);
      // Within the box also after rounding, where it is periodic.
      if (container.is_periodic(axis) && from_center >= edge / 2) from_center -= edge;
      if (container.is_periodic(axis) && from_center < -edge / 2) from_center += edge;
      position[axis] = container.size[axis] / 2 + static_cast<double>(from_center);
    }
  }
}

// The largest number of the precision that is no larger.
double rounded_down(double radius, Precision precision) {
  if (precision == Precision::doubles) return radius;
  auto diameter = static_cast<float>(2 * radius);
  if (static_cast<double>(diameter) > 2 * radius) diameter = std::nextafter(diameter, 0.0F);
  return static_cast<double>(diameter) / 2;
}

// The factor for radii with which nothing overlaps: less than one, by a few units in the last place.
double factor_without_overlap(const PackedSpheres& spheres) {
  constexpr double kUnits = 0x1p-50;
  return (1 - spheres.largest_overlap()) * (1 - kUnits);
}

// Reduces radii by a factor, until nothing overlaps either in the numbers as they are stored.
void shrink(PackedSpheres& spheres, double factor, Precision precision) {
  const std::vector<double> radii = spheres.radii;
  constexpr int kRounds = 60;
  double total = factor;
  for (int round = 0;; ++round) {
    for (std::size_t i = 0; i < radii.size(); ++i)
      spheres.radii[i] = rounded_down(total * radii[i], precision);
    if (spheres.largest_overlap() == 0) return;
    HARDBALL_CHECK(round < kRounds);
    total *= factor_without_overlap(spheres);
  }
}

// Whether spheres are not as large as wanted, where that is given besides the container.
bool are_too_small(const Packer& packer, const PackedSpheres& spheres) {
  const bool is_given = packer.plan().follows == PackingPlan::Follows::count &&
                        !std::holds_alternative<double>(packer.plan().goal);
  constexpr double kRounding = 1e-9;
  return is_given && spheres.mean_diameter() < (1 - kRounding) * packer.plan().diameter;
}

Status status_of(const Packer& packer, const PackedSpheres& spheres) {
  if (are_too_small(packer, spheres)) return Status::not_reached;
  if (packer.state() == Packer::State::reached) return Status::reached;
  return packer.state() == Packer::State::jammed ? Status::jammed : Status::not_reached;
}

std::string reason_of(const Packer& packer, const PackedSpheres& spheres) {
  const Packer::State state = packer.state();
  if (!packer.is_over()) return "packing was ended before it was finished";
  if (are_too_small(packer, spheres)) return "no number of spheres was found that fills the container";
  if (state == Packer::State::reached) return "the density wanted was reached";
  if (packer.has_no_room()) return "the largest sphere fills the container";
  return state == Packer::State::jammed ? "the spheres have jammed"
                                        : "the spheres locked before the density wanted was reached";
}

}  // namespace

Packing packing_of(const Packer& packer) {
  const PackingPlan& plan = packer.plan();
  Packing packing;
  PackedSpheres& spheres = packing.spheres;
  spheres = spheres_of(packer);
  packing.status = status_of(packer, spheres);
  packing.reason = reason_of(packer, spheres);
  packing.pressure = packer.pressure();
  packing.rate = packer.rate();
  packing.collisions = packer.collisions();
  packing.history = packer.history();
  packing.warnings = plan.warnings;
  constexpr double kSlower = 3;
  if (packer.state() == Packer::State::locked && !packer.has_no_room())
    packing.suggested_rate = packer.rate() / kSlower;
  const double tolerance = contact_tolerance(packing.pressure);
  if (tolerance > 0) packing.network = contact_network(spheres, tolerance, packer.impulses());
  packing.crystalline = crystalline_share(spheres);
  return packing;
}

void fit_numbers(PackedSpheres& spheres, Precision precision, double factor) {
  if (precision == Precision::singles) round_to_singles(spheres);
  shrink(spheres, factor * factor_without_overlap(spheres), precision);
}

void finish(Packing& packing, const PackingPlan& plan, Precision precision) {
  PackedSpheres& spheres = packing.spheres;
  double factor = 1 - plan.gap;
  if (plan.follows == PackingPlan::Follows::size) multiply(packing, plan.diameter / spheres.mean_diameter());
  if (plan.follows == PackingPlan::Follows::count)
    factor *= std::min(1.0, plan.diameter / spheres.mean_diameter());
  const double before = spheres.mean_diameter();
  fit_numbers(spheres, precision, factor);
  packing.shrink = spheres.mean_diameter() / before;
  packing.largest_overlap = spheres.largest_overlap();
}

Snapshot snapshot_of(const PackedSpheres& spheres) {
  Snapshot snapshot;
  SnapshotBox box;
  box.size = spheres.container.size;
  box.is_flat = spheres.container.dimensions == 2;
  for (std::size_t axis = 0; axis < spheres.container.dimensions; ++axis)
    box.is_periodic[axis] = spheres.container.is_periodic(axis);
  snapshot.time = 0;
  if (box.is_flat) {
    const double thickness = 2 * std::ranges::max(spheres.radii);
    box.low.z = -thickness / 2;
    box.size.z = thickness;
  }
  snapshot.box = box;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    snapshot.spheres.push_back({.position = spheres.positions[i], .radius = spheres.radii[i]});
    snapshot.ids.push_back(static_cast<std::int64_t>(i));
  }
  return snapshot;
}

World world_of(const PackedSpheres& spheres, double temperature, std::uint64_t seed) {
  World world(spheres.container.box(), {}, spheres.container.surfaces());
  Random random(seed);
  const double speed = std::sqrt(temperature);
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    world.add({.position = spheres.positions[i],
               .velocity = speed * random.normal_vector(spheres.container.dimensions),
               .radius = spheres.radii[i]});
  }
  return world;
}

std::string_view name_of(Status status) {
  constexpr std::array<std::string_view, 3> kNames{"reached", "jammed", "not reached"};
  return kNames[static_cast<std::size_t>(status)];
}

}  // namespace hardball
