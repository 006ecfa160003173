// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hardball/geometry/growth.hpp"
#include "hardball/interaction/contact.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/velocity_change.hpp"

namespace hardball {

/// An observer of a run, which cannot change it; see Simulation::observe. Each function may be empty.
struct Observer {
  /// Called with every contact, in their order, but perhaps when later ones have happened already.
  Function<void(const Contact&)> contact = {};
  /// Called after every change of a velocity without a contact.
  Function<void(const VelocityChange&)> change = {};
  /// Called when an epoch of growth has begun, after the changes of velocities that belong to it, and with
  /// the last sizes when growth has been stopped.
  Function<void(const Growth&)> epoch = {};
  /// Called when a surface goes on otherwise than before, with its number.
  Function<void(std::uint32_t, const Surface&)> surface = {};
};

}  // namespace hardball
