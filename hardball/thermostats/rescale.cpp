// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/thermostats/rescale.hpp"

#include <algorithm>
#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/theory/thermal_motion.hpp"
#include "hardball/world/images.hpp"

namespace hardball {

Rescale::Rescale(double temperature, double every, std::size_t slabs)
    : temperature_(temperature), times_(every), slabs_(slabs) {
  check_positive(temperature, "temperature", "thermostat");
}

void Rescale::begin(const World& world, double now, std::uint64_t /*seed*/) {
  if (slabs_ > 0 && !world.box().is_bounded(1)) {
    throw Error("the box is open along y, across which there are slabs", "thermostat",
                "leave the slabs out, or give the box an extent");
  }
  times_.begin(now);
}

void Rescale::act(const World& world, const Time& moment, std::vector<NewVelocity>& changes) {
  times_.advance();
  if (slabs_ > 0) return act_in_slabs(world, moment, changes);
  const ThermalMotion motion = thermal_motion(world, moment);
  if (!(motion.energy > 0) || !(motion.degrees_of_freedom > 0)) return;
  const double factor = std::sqrt(temperature_ * motion.degrees_of_freedom / (2 * motion.energy));
  world.for_each_by_id([&](Slot slot) {
    if (world.is_kinematic(slot)) return;
    const Vec3 before = world.velocity(slot, moment);
    const Vec3 peculiar = peculiar_velocity(world, slot, moment);
    Vec3 after = motion.drift + factor * (peculiar - motion.drift);
    if (world.box().is_sheared()) after += flow_velocity(world, slot, moment);
    changes.push_back({slot, before, after});
  });
}

void Rescale::act_in_slabs(const World& world, const Time& moment, std::vector<NewVelocity>& changes) const {
  struct Slab {
    double mass = 0;
    Vec3 momentum;  // relative to the flow of the box
    Vec3 drift() const { return (1 / mass) * momentum; }
  };
  std::vector<Slab> slabs(slabs_);
  const auto slab_of = [&](Slot slot) -> Slab& {
    const double height = world.position(slot, moment).y / world.box().size().y;
    return slabs[static_cast<std::size_t>(std::clamp(height, 0.0, 1 - 0x1p-53) *
                                          static_cast<double>(slabs_))];
  };
  const auto for_each = [&](auto&& visit) {
    world.for_each_by_id([&](Slot slot) {
      if (!world.is_kinematic(slot)) visit(slot, slab_of(slot), peculiar_velocity(world, slot, moment));
    });
  };
  std::size_t spheres = 0;
  for_each([&](Slot slot, Slab& slab, const Vec3& velocity) {
    slab.mass += world.mass(slot);
    slab.momentum += world.mass(slot) * velocity;
    ++spheres;
  });
  double energy = 0;
  for_each([&](Slot slot, const Slab& slab, const Vec3& velocity) {
    const Vec3 thermal = velocity - slab.drift();
    energy += world.mass(slot) * dot(thermal, thermal) / 2;
  });
  const auto means =
      static_cast<std::size_t>(ranges::count_if(slabs, [](const Slab& slab) { return slab.mass > 0; }));
  const auto freedom = static_cast<double>(world.box().dimensions() * (spheres - means));
  if (!(energy > 0) || !(freedom > 0)) return;
  const double factor = std::sqrt(temperature_ * freedom / (2 * energy));
  for_each([&](Slot slot, const Slab& slab, const Vec3& velocity) {
    const Vec3 before = world.velocity(slot, moment);
    changes.push_back({slot, before, before + (factor - 1) * (velocity - slab.drift())});
  });
}

}  // namespace hardball
