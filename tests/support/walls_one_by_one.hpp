// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <variant>

#include "hardball/world/walls.hpp"

namespace hardball::support {

/// Calls visit(image) for all images up to so many boxes away along periodic axes.
template <class Visit>
void for_each_image(const Box& box, std::int32_t boxes, Visit&& visit) {
  Image most;
  for (std::size_t axis = 0; axis < kAxes; ++axis) most[axis] = box.is_periodic(axis) ? boxes : 0;
  Image image;
  for (image[0] = -most[0]; image[0] <= most[0]; ++image[0]) {
    for (image[1] = -most[1]; image[1] <= most[1]; ++image[1]) {
      for (image[2] = -most[2]; image[2] <= most[2]; ++image[2]) visit(image);
    }
  }
}

/// The next contact of a sphere with a face of the box or any surface: each obstacle by itself, in all images
/// up to so many boxes away from the sphere.
inline Event wall_event_one_by_one(const World& world, Slot slot, const Time& now, std::int32_t boxes) {
  Event first = next_wall_event(world, slot, now);
  const Path& path = world.path(slot);
  std::uint32_t number = kFaces;
  for (const Surface& surface : world.surfaces()) {
    const bool has_images = std::holds_alternative<Obstacle>(surface.shape()) || surface.mesh() != nullptr;
    const Image nearest =
        has_images ? world.box().nearest_image(world.unfolded_position(slot, now) - surface.point())
                   : Image{};
    for_each_image(world.box(), has_images ? boxes : 0, [&](const Image& image) {
      const Path seen{path.position - world.box().shift(nearest + image), path.velocity, path.time};
      const Event event{surface.contact_time(world.motion(), seen, world.base_radius(slot)),
                        EventKind::wall,
                        world.id(slot),
                        number,
                        {}};
      if (event < first) first = event;
    });
    ++number;
  }
  return first;
}

}  // namespace hardball::support
