// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/kinetic_tensor.hpp"
#include "hardball/world/images.hpp"

#include <cmath>

namespace hardball {
namespace {

// The velocity of the flow at the place of a center, zero where there is no shear.
Vec3 flow_at(const Box& box, const Vec3& position) {
  return {box.is_sheared() ? box.flow_speed(position.y) : 0, 0, 0};
}

}  // namespace

void add_symmetric_product(double* components, const Vec3& a, const Vec3& b) {
  components[0] += a.x * b.x;
  components[1] += a.y * b.y;
  components[2] += a.z * b.z;
  components[3] += (a.x * b.y + a.y * b.x) / 2;
  components[4] += (a.x * b.z + a.z * b.x) / 2;
  components[5] += (a.y * b.z + a.z * b.y) / 2;
}

KineticTensor::KineticTensor(const Scene& scene)
    : drift_(scene.thermal_motion().drift),
      gravity_(scene.world().motion().gravity()),
      has_drift_(drift_axes(scene.world())) {
  const World& world = scene.world();
  world.for_each_by_id([&](Slot slot) {
    if (world.is_kinematic(slot)) return;
    const double mass = world.mass(slot);
    const Vec3 velocity = peculiar_velocity(world, slot, scene.now()) - drift_;
    mass_ += mass;
    momentum_ += mass * velocity;
    add_symmetric_product(components_.data(), mass * velocity, velocity);
  });
}

// While spheres fall, velocities change by g t. Relative to the flow of a sheared box a sphere that rises
// falls behind, so v_x changes at the rate -g v_y. Either way the components are polynomials in time.
void KineticTensor::advance(const Box& box, double elapsed, double* integral) {
  for (std::size_t k = 0; k < components_.size(); ++k) integral[k] += components_[k] * elapsed;
  if (box.is_sheared()) {
    const double turned = box.shear().rate * elapsed;
    auto& [xx, yy, zz, xy, xz, yz] = components_;
    integral[0] += (turned * yy / 3 - xy) * turned * elapsed;
    integral[3] -= yy * turned * elapsed / 2;
    integral[4] -= yz * turned * elapsed / 2;
    xx += (turned * yy - 2 * xy) * turned;
    xy -= yy * turned;
    xz -= yz * turned;
    drift_.x -= drift_.y * turned;
  }
  if (!(gravity_ == Vec3{})) {
    const Vec3 gained = elapsed * gravity_;
    add_symmetric_product(integral, elapsed * momentum_, gained);
    add_symmetric_product(integral, mass_ * elapsed / 3 * gained, gained);
    add_symmetric_product(components_.data(), 2 * momentum_ + mass_ * gained, gained);
    momentum_ += mass_ * gained;
  }
}

// A velocity that changes from v to w changes m v v by m (w - v) (v + w), symmetrized.
void KineticTensor::change(double mass, const Vec3& before, const Vec3& after) {
  if (std::isinf(mass)) return;
  const Vec3 impulse = mass * (after - before);
  momentum_ += impulse;
  add_symmetric_product(components_.data(), impulse, (before + after) - 2 * drift_);
}

void KineticTensor::record(const Box& box, const Contact& contact) {
  const Vec3 flow = flow_at(box, contact.position);
  change(contact.first_mass, contact.before.first - flow, contact.after.first - flow);
  if (!contact.is_collision()) return;
  const Vec3 flow_at_second = flow_at(box, contact.position + contact.separation);
  change(contact.second_mass, contact.before.second - flow_at_second, contact.after.second - flow_at_second);
}

// Along axes on which nothing else acts, what changes the total momentum changes the drift.
void KineticTensor::record(const Box& box, const VelocityChange& change_of_one) {
  const Vec3 flow = flow_at(box, change_of_one.position);
  change(change_of_one.mass, change_of_one.before - flow, change_of_one.after - flow);
  Vec3 drift;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (has_drift_[axis]) drift[axis] = momentum_[axis] / mass_;
  }
  drift_ += drift;
  momentum_ -= mass_ * drift;
  add_symmetric_product(components_.data(), -mass_ * drift, drift);
}

}  // namespace hardball
