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
#include "hardball/standard/ranges.hpp"

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
  PackedSpheres spheres{packer.plan().container, simulation.positions(), {}, packer.plan().labels};
  const World& world = simulation.world();
  spheres.radii.resize(world.size());
  for (Slot slot = 0; slot < world.size(); ++slot)
    spheres.radii[world.id(slot)] = world.radius(slot, simulation.now());
  return spheres;
}

// Multiplies all lengths by a factor.
void multiply(PackedSpheres& spheres, double factor) {
  spheres.container = spheres.container.scaled(factor);
  for (Vec3& position : spheres.positions) position = factor * position;
  for (double& radius : spheres.radii) radius *= factor;
}

// What numbers resolve everywhere along an axis of a box whose corner is not the origin: a power of two [L].
double resolution(const PackedSpheres& spheres, std::size_t axis) {
  const double low = spheres.labels.low[axis];
  const double high = low + spheres.container.size[axis];
  constexpr int kBits = 51;
  return std::ldexp(1, std::ilogb(std::max(std::fabs(low), std::fabs(high))) - kBits);
}

// What files add to positions: the corner of the box, as far as it is resolved.
Vec3 origin_of(const PackedSpheres& spheres) {
  Vec3 origin;
  for (std::size_t axis = 0; axis < spheres.container.dimensions; ++axis) {
    const double low = spheres.labels.low[axis];
    if (low == 0) continue;
    const double unit = resolution(spheres, axis);
    origin[axis] = unit * std::floor(low / unit);
  }
  return origin;
}

// Adjusts positions so that adding the origin rounds nothing, and edges to those that readers find. Returns a
// factor for radii that makes up for the corner, where that is not resolved.
double round_to_origin(PackedSpheres& spheres) {
  Container& container = spheres.container;
  double lost = 0;
  for (std::size_t axis = 0; axis < container.dimensions; ++axis) {
    const double low = spheres.labels.low[axis];
    if (low == 0) continue;
    const double unit = resolution(spheres, axis);
    container.size[axis] = (low + container.size[axis]) - low;
    for (Vec3& position : spheres.positions) position[axis] = unit * std::floor(position[axis] / unit);
    if (!container.is_periodic(axis)) lost = std::max(lost, 2 * unit);
  }
  return 1 - lost / ranges::min(spheres.radii);
}

void round_to_singles(PackedSpheres& spheres) {
  Container& container = spheres.container;
  for (std::size_t axis = 0; axis < container.dimensions; ++axis) {
    const auto edge = static_cast<float>(container.size[axis]);
    double center = container.low[axis] + container.size[axis] / 2;
    container.size[axis] = static_cast<double>(edge);
    if (container.mesh) {
      // So that nothing is rounded where a reader adds it.
      center = static_cast<double>(static_cast<float>(center));
      container.low[axis] = center - container.size[axis] / 2;
    }
    for (Vec3& position : spheres.positions) {
      auto from_center = static_cast<float>(position[axis] - center);
      // Within the box also after rounding, where it is periodic.
      if (container.is_periodic(axis) && from_center >= edge / 2) from_center -= edge;
      if (container.is_periodic(axis) && from_center < -edge / 2) from_center += edge;
      position[axis] = (container.low[axis] + container.size[axis] / 2) + static_cast<double>(from_center);
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

// By how many boxes each sphere has been moved since it was there.
std::vector<Image> crossings(const Box& box, const std::vector<Vec3>& before,
                             const std::vector<Vec3>& after) {
  std::vector<Image> images(before.size());
  for (std::size_t i = 0; i < before.size(); ++i) images[i] = box.nearest_image(before[i] - after[i]);
  return images;
}

// The forces of a network by contact, for spheres that have been moved by these numbers of boxes.
std::unordered_map<ContactKey, double> forces_of(const ContactNetwork& network,
                                                 const std::vector<Image>& moved) {
  std::unordered_map<ContactKey, double> forces;
  for (const PackingContact& contact : network.contacts) {
    ContactKey bodies = contact.bodies;
    if (!bodies.is_wall) bodies.image = bodies.image + moved[bodies.second] - moved[bodies.first];
    forces[bodies] = contact.force;
  }
  return forces;
}

// The widest gap between bodies that touched before their numbers changed, of those within a gap, and no less
// than what counts as a contact anyway; over the sum of the radii [1].
double widest_contact(const PackedSpheres& spheres, const std::unordered_map<ContactKey, double>& touched,
                      double tolerance, double within) {
  spheres.for_each_near(within, [&](const NearPair& pair) {
    if (touched.contains(pair.bodies)) tolerance = std::max(tolerance, pair.gap / pair.reach);
  });
  return tolerance;
}

// The contacts of a packing whose positions were other ones, with its forces.
ContactNetwork network_now(const Packing& packing, const std::vector<Vec3>& positions, Precision precision) {
  const PackedSpheres& spheres = packing.spheres;
  const ContactNetwork& before = packing.network;
  const auto forces = forces_of(before, crossings(spheres.container.box(), positions, spheres.positions));
  const double reduced = 1 - packing.shrink;
  double within = (before.tolerance + reduced) / packing.shrink;
  if (precision == Precision::singles) {
    // Each position is rounded by no more than this along each axis.
    const Vec3& size = spheres.container.size;
    constexpr double kUnit = 0x1p-24;
    within += 4 * kUnit * std::max({size.x, size.y, size.z}) / ranges::min(spheres.radii);
  }
  // More than the rounding of any program that computes gaps.
  constexpr double kRounding = 1e-9;
  double widest = widest_contact(spheres, forces, before.tolerance, within * (1 + kRounding));
  if (widest > before.tolerance) widest *= 1 + kRounding;
  const bool are_known = !before.contacts.empty() && !std::isnan(before.contacts.front().force);
  return contact_network(spheres, widest, are_known ? forces : std::unordered_map<ContactKey, double>());
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
  const bool is_pressure = std::holds_alternative<PackingRequest::Pressure>(packer.plan().goal);
  if (are_too_small(packer, spheres)) {
    return is_pressure ? "spheres of this diameter have less than the pressure wanted, or one more jams"
                       : "no number of spheres was found that fills the container";
  }
  if (state == Packer::State::reached)
    return is_pressure ? "the pressure wanted was reached" : "the density wanted was reached";
  if (packer.has_no_room()) return "the largest sphere fills the container";
  if (state == Packer::State::jammed) return "the spheres have jammed";
  if (std::holds_alternative<PackingRequest::Densest>(packer.plan().goal))
    return "the spheres still rearrange, and have not jammed";
  return is_pressure ? "the pressure that was reached differs from that wanted"
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
  if (packer.state() == Packer::State::locked && !packer.has_no_room() &&
      std::holds_alternative<double>(plan.goal))
    packing.suggested_rate = packer.rate() / kSlower;
  const double tolerance = contact_tolerance(packing.pressure);
  if (tolerance > 0) packing.network = contact_network(spheres, tolerance, packer.impulses());
  packing.crystalline = crystalline_share(spheres);
  return packing;
}

void fit_numbers(PackedSpheres& spheres, Precision precision, double factor) {
  if (precision == Precision::singles) {
    round_to_singles(spheres);
    spheres.labels.low = {};  // such files have the center of the box as their origin
  }
  factor *= round_to_origin(spheres);
  shrink(spheres, factor * factor_without_overlap(spheres), precision);
}

void finish(Packing& packing, const PackingPlan& plan, Precision precision) {
  PackedSpheres& spheres = packing.spheres;
  if (plan.follows == PackingPlan::Follows::size) multiply(spheres, plan.diameter / spheres.mean_diameter());
  double factor = 1;
  if (plan.follows == PackingPlan::Follows::count)
    factor = std::min(1.0, plan.diameter / spheres.mean_diameter());
  factor *= 1 - plan.gap;
  const double before = spheres.mean_diameter();
  const std::vector<Vec3> positions = spheres.positions;
  fit_numbers(spheres, precision, factor);
  packing.shrink = spheres.mean_diameter() / before;
  packing.largest_overlap = spheres.largest_overlap();
  packing.smallest_gap = spheres.smallest_gap();
  if (packing.network.tolerance > 0) packing.network = network_now(packing, positions, precision);
  constexpr double kNoticed = 1e-3;
  if (packing.status == Status::jammed && packing.shrink < 1 - kNoticed) {
    packing.reason +=
        "; their diameters are reduced to " + to_text(packing.shrink) + " of those at which they did";
  }
}

Snapshot snapshot_of(const PackedSpheres& spheres) {
  Snapshot snapshot;
  SnapshotBox box;
  const SphereLabels& labels = spheres.labels;
  box.low = labels.low + spheres.container.low;
  box.size = spheres.container.size;
  box.is_flat = spheres.container.dimensions == 2;
  for (std::size_t axis = 0; axis < spheres.container.dimensions; ++axis)
    box.is_periodic[axis] = spheres.container.is_periodic(axis);
  snapshot.time = 0;
  if (box.is_flat) {
    const double thickness = 2 * ranges::max(spheres.radii);
    box.low.z = -thickness / 2;
    box.size.z = thickness;
  }
  snapshot.box = box;
  const Vec3 origin = origin_of(spheres);
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    snapshot.spheres.push_back({.position = origin + spheres.positions[i],
                                .radius = spheres.radii[i],
                                .mass = labels.masses.empty() ? 1 : labels.masses[i],
                                .species = labels.species.empty() ? SpeciesId{0} : labels.species[i]});
    snapshot.ids.push_back(labels.ids.empty() ? static_cast<std::int64_t>(i) : labels.ids[i]);
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

}  // namespace hardball
