// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hardball/errors/export.hpp"
#include "hardball/events/event.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

class Simulation;

/// One sphere of a simulation: as light as a pointer, copied freely. It must not outlive the simulation, and
/// stays with it when that is moved from or assigned to. Error, from all but id() and exists(): the sphere
/// has been removed; and as the members of Simulation do.
class HARDBALL_EXPORT SphereHandle {
 public:
  SphereHandle(Simulation& simulation, SphereId id) : simulation_(&simulation), id_(id) {}

  SphereId id() const { return id_; }
  /// Whether the sphere is still there.
  bool exists() const;
  Vec3 position() const;  ///< See Simulation::position [L].
  Vec3 velocity() const;  ///< [L/T]
  double radius() const;  ///< [L]
  double mass() const;    ///< [M]
  /// See Simulation::change_velocity.
  void change_velocity(const Vec3& velocity) const;
  /// See Simulation::user_data.
  std::uint64_t user_data() const;
  void set_user_data(std::uint64_t data) const;

 private:
  Simulation* simulation_;
  SphereId id_;
};

}  // namespace hardball
