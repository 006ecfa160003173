// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/simulation/sphere_handle.hpp"

#include "hardball/simulation/simulation.hpp"

namespace hardball {

bool SphereHandle::exists() const {
  return simulation_->contains(id_);
}

Vec3 SphereHandle::position() const {
  return simulation_->position(id_);
}

Vec3 SphereHandle::velocity() const {
  return simulation_->velocity(id_);
}

double SphereHandle::radius() const {
  return simulation_->world().radius(simulation_->world().slot_of(id_), simulation_->now());
}

double SphereHandle::mass() const {
  return simulation_->world().mass(simulation_->world().slot_of(id_));
}

void SphereHandle::change_velocity(const Vec3& velocity) const {
  simulation_->change_velocity(id_, velocity);
}

std::uint64_t SphereHandle::user_data() const {
  return simulation_->user_data(id_);
}

void SphereHandle::set_user_data(std::uint64_t data) const {
  simulation_->set_user_data(id_, data);
}

}  // namespace hardball
