// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/errors/export.hpp"
#include "hardball/geometry/contact_time.hpp"
#include "hardball/world/world.hpp"

// Where spheres and their images are, as seen from the box, from each other, or from the flow of a sheared
// box.
namespace hardball {

/// The center at `moment` as if it had never been folded into the box [L]; in a sheared box it moves on with
/// the flow at the height that it has reached. Precondition: `moment` is finite.
inline Vec3 unwrapped_position(const World& world, Slot slot, const Time& moment) {
  return world.unfolded_position(slot, moment) + world.box().shift(world.folded(slot), moment);
}

/// By how many boxes the center at `moment` would lie outside the box if it had never been folded. Error:
/// `moment` is NaN or infinite.
HARDBALL_EXPORT Image image_of(const World& world, Slot slot, const Time& moment);

/// The velocity of the flow of a sheared box where the sphere is in the box [L/T]; zero where there is no
/// shear. Precondition: `moment` is finite.
inline Vec3 flow_velocity(const World& world, Slot slot, const Time& moment) {
  const Box& box = world.box();
  return {box.is_sheared() ? box.flow_speed(world.position(slot, moment).y) : 0, 0, 0};
}

/// The velocity relative to the flow of a sheared box where the sphere is [L/T], the same for all its images;
/// the velocity where there is no shear. Precondition: `moment` is finite.
inline Vec3 peculiar_velocity(const World& world, Slot slot, const Time& moment) {
  if (world.box().is_sheared()) [[unlikely]]
    return world.velocity(slot, moment) - flow_velocity(world, slot, moment);
  return world.unfolded_velocity(slot, moment);
}

/// More than the rounding error of the coordinates of a center [L], which shows in spheres very far away.
inline double coordinate_error(const World& world, Slot slot, const Time& now) {
  return 0x1p-50 * length(world.unfolded_position(slot, now));
}

/// The image of `b` nearest to `a` at `moment`.
inline Image nearest_image(const World& world, Slot a, Slot b, const Time& moment) {
  return world.box().nearest_image(world.unfolded_position(a, moment) - world.unfolded_position(b, moment),
                                   moment);
}

/// Where `image` of `b` is as seen from `a`, and how fast it moves, at `moment`. Exchanging the spheres and
/// negating the image negates the result exactly.
inline State relative_state(const World& world, Slot a, Slot b, const Image& image, const Time& moment) {
  State relative = relative_state_at(world.motion(), world.path(a), world.path(b),
                                     world.box().shift(image, moment), moment);
  if (world.box().is_sheared() && image[1] != 0) relative.velocity += world.box().image_velocity(image);
  return relative;
}

}  // namespace hardball
