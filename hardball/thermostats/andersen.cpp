// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/thermostats/andersen.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hardball/geometry/range.hpp"
#include "hardball/numbers/event_random.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/thermostats/intervals.hpp"
#include "hardball/world/images.hpp"

namespace hardball {

Andersen::Andersen(double temperature, double rate) : temperature_(temperature), rate_(rate) {
  check_positive(temperature, "temperature", "thermostat");
  check_positive(rate, "rate", "thermostat");
}

void Andersen::begin(const World& world, double now, std::uint64_t seed) {
  seed_ = seed;
  due_.clear();
  due_.reserve(world.size());
  world.for_each_by_id([&](Slot slot) { add(world.id(slot), now); });
}

void Andersen::add(SphereId sphere, double now) {
  Random random = event_random(seed_, sphere, 0);
  due_.push_back({now + wait(random), sphere, 1});
  std::push_heap(due_.begin(), due_.end(), is_later);
}

void Andersen::remove(SphereId sphere) {
  std::erase_if(due_, [&](const Due& due) { return due.sphere == sphere; });
  std::make_heap(due_.begin(), due_.end(), is_later);
}

double Andersen::next() const {
  return due_.empty() ? std::numeric_limits<double>::infinity() : due_.front().time;
}

void Andersen::act(const World& world, const Time& moment, std::vector<NewVelocity>& changes) {
  refuse_unresolved(1 / rate_, next());
  std::pop_heap(due_.begin(), due_.end(), is_later);
  Due& due = due_.back();
  const Slot slot = world.slot_of(due.sphere);
  Random random = event_random(seed_, due.sphere, due.count);
  const double spread = std::sqrt(temperature_ / world.mass(slot));
  Vec3 velocity = spread * random.normal_vector(world.box().dimensions());
  if (world.box().is_sheared()) velocity += flow_velocity(world, slot, moment);
  if (!world.is_kinematic(slot)) changes.push_back({slot, world.velocity(slot, moment), velocity});
  due.time += wait(random);
  ++due.count;
  std::push_heap(due_.begin(), due_.end(), is_later);
}

// The time from one event of a Poisson process to the next.
double Andersen::wait(Random& random) const {
  return -portable_log(1 - random.uniform()) / rate_;
}

bool Andersen::restored() const {
  return temperature_ > 0 && rate_ > 0 && ranges::is_heap(due_, is_later);
}

}  // namespace hardball
