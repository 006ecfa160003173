// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <limits>

#include "hardball/geometry/time.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// Identifies a sphere for its whole life; never reused in one world.
using SphereId = std::uint32_t;

/// Index at which a sphere is stored, 0 to size-1. Changes when spheres are removed or reordered.
using Slot = std::uint32_t;

/// What happens at an event. Simultaneous events happen in this order: a sphere that enters a cell is
/// registered there before any sphere in it is touched.
enum class EventKind : std::uint8_t {
  enter,      ///< A sphere reaches the edge of its region, within which the broad phase knows its candidates.
  leave,      ///< A sphere has left a cell.
  collision,  ///< Two spheres touch.
  wall,       ///< A sphere touches a face of the box, or another surface.
};

/// A face of the box: 2 * axis, plus one for the upper face. Other surfaces have the numbers from kFaces on.
using Face = std::uint32_t;

inline constexpr Face kFaces = 6;

inline constexpr Face face_of(std::size_t axis, bool upper) {
  return static_cast<Face>(2 * axis + (upper ? 1 : 0));
}
inline constexpr std::size_t axis_of(Face face) {
  return face / 2;
}
inline constexpr bool is_upper(Face face) {
  return face % 2 == 1;
}

/// Something that happens, or would happen if nothing came before it.
///
/// Events have one total order: by time, kind, lower id, higher id and image. Members are declared in that
/// order, so that memberwise comparison gives it.
struct Event {
  Time time = kNever;
  EventKind kind = EventKind::wall;
  SphereId first = 0;        ///< The sphere; for a collision, the one with the lower id.
  std::uint32_t second = 0;  ///< Collision: the sphere with the higher id. Otherwise the Face or surface.
  Image image;               ///< Collision: the image of `second` that `first` meets.

  bool happens() const { return time.high < std::numeric_limits<double>::infinity(); }

  friend bool operator==(const Event&, const Event&) = default;
  friend std::partial_ordering operator<=>(const Event&, const Event&) = default;
  static void persist(auto& archive, auto& self) {
    archive(self.time, self.kind, self.first, self.second, self.image);
  }
};

/// The collision of spheres `a` and `b`, lower id first; `image` is the image of `b` that `a` meets.
inline Event make_collision(const Time& time, SphereId a, SphereId b, const Image& image) {
  // Branchless: which id is lower is unpredictable.
  const std::int32_t sign = 1 - 2 * static_cast<std::int32_t>(b < a);
  return {time, EventKind::collision, a < b ? a : b, a < b ? b : a, sign * image};
}

}  // namespace hardball
