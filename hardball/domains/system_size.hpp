// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "hardball/domains/division.hpp"
#include "hardball/domains/halo.hpp"
#include "hardball/domains/window_settings.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// What the depth of halos and the length of windows follow from. Its parts may be in several places.
struct SystemSize {
  std::uint64_t spheres = 0;
  double speeds = 0;   ///< Sum of the speeds of all spheres [L/T].
  double contact = 0;  ///< The largest distance of two centers at a contact [L].

  /// The size of a world as it is at `moment`. Cost: O(n).
  static SystemSize of(const World& world, const Time& moment) {
    SystemSize size{.spheres = world.size(),
                    .contact = 2 * world.largest_bounding_radius() * world.room_to_grow()};
    for (Slot slot = 0; slot < world.size(); ++slot) size.speeds += length(world.velocity(slot, moment));
    return size;
  }
  /// Adds a sphere with this speed [L/T] and radius [L].
  void record(double speed, double radius) {
    ++spheres;
    speeds += speed;
    contact = std::max(contact, 2 * radius);
  }
  void add(const SystemSize& other) {
    spheres += other.spheres;
    speeds += other.speeds;
    contact = std::max(contact, other.contact);
  }

  Halo halo(const Division& division) const { return {division.halo * contact, 0.5 * contact, contact}; }
  /// The windows for this many domains. Small domains have longer windows: with few contacts, the fixed cost
  /// of a window does not pay, and domains do not finish at the same time. But longer windows fail more
  /// often.
  WindowSettings windows(const Division& division, std::size_t domains) const {
    constexpr double kContactsOfDomain = 256;
    constexpr double kLongest = 2;
    const auto count = static_cast<double>(std::max<std::uint64_t>(spheres, 1));
    const double usual = division.window * count / 2;
    const double wanted = kContactsOfDomain * static_cast<double>(domains);
    const double more = std::clamp(wanted, usual, kLongest * usual);
    const double mean_speed = speeds > 0 ? speeds / count : 1;
    const double radius = contact > 0 ? contact / 2 : 1;
    return {std::max(1.0, usual), std::max(1.0, more), division.first_window * radius / mean_speed,
            2 * radius / mean_speed};
  }
};

}  // namespace hardball
