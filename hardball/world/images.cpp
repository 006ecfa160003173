// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/images.hpp"

#include "hardball/geometry/range.hpp"

namespace hardball {

Image image_of(const World& world, Slot slot, const Time& moment) {
  check_finite(moment, "image");
  return world.folded(slot) + world.box().boxes_beyond(world.unfolded_position(slot, moment), moment);
}

}  // namespace hardball
