// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/scene.hpp"
#include "hardball/world/images.hpp"

namespace hardball {
namespace {

// The stored value, computed first if there is none.
template <class Found, class Find>
const Found& once(std::recursive_mutex& mutex, std::optional<Found>& found, const Find& find) {
  const std::scoped_lock lock(mutex);
  if (!found) found.emplace(find());
  return *found;
}

}  // namespace

double mean_radius(const World& world) {
  double sum = 0;
  world.for_each_by_id([&](Slot slot) { sum += world.base_radius(slot); });
  return sum / static_cast<double>(world.size());
}

const SpeciesList& Scene::species() const {
  return once(mutex_, species_, [&] { return SpeciesList(world_); });
}

const FluidTheory& Scene::fluid() const {
  return once(mutex_, fluid_, [&] { return FluidTheory(world_, species()); });
}

const GasStatistics& Scene::statistics() const {
  return once(mutex_, statistics_, [&] { return gas_statistics(world_, now_); });
}

const ThermalMotion& Scene::thermal_motion() const {
  return once(mutex_, motion_, [&] {
    ThermalMotion motion = hardball::thermal_motion(world_, now_);
    motion.is_driven |= is_driven_ || world_.has_steps();
    return motion;
  });
}

const std::vector<Vec3>& Scene::centers() const {
  return once(mutex_, centers_, [&] {
    std::vector<Vec3> centers;
    centers.reserve(world_.size());
    world_.for_each_by_id([&](Slot slot) { centers.push_back(world_.position(slot, now_)); });
    return centers;
  });
}

const NeighborQuery& Scene::surroundings() const {
  return once(mutex_, surroundings_,
              [&] { return NeighborQuery(world_, centers(), statistics().volume(), now_); });
}

bool Scene::has_equilibrium(const ThermalMotion& begin) const {
  return is_energy_conserved(begin, thermal_motion()) && !world_.box().is_any(Boundary::open) &&
         world_.box().has_plain_faces() && !fluid().is_ideal();
}

Vec3 Scene::unfolded_center(Slot slot) const {
  return world_.position(slot, now_) + world_.box().shift(image_of(world_, slot, now_), now_);
}

}  // namespace hardball
