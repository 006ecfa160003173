// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/engine/predictor.hpp"

#include "hardball/events/event.hpp"

namespace hardball {
namespace {

// The contact with one candidate, as an event.
Event contact_with(const World& world, const Candidates& candidates, std::size_t i, const Time& now) {
  const Slot self = candidates.self();
  const Slot other = candidates.slot(i);
  const Image image = candidates.are_nearest() ? nearest_image(world, self, other, now) : candidates.image(i);
  return make_collision(contact_time(world, self, other, image), world.id(self), world.id(other), image);
}

}  // namespace

Image nearest_image(const World& world, Slot a, Slot b, const Time& moment) {
  return world.box().nearest_image(position_at(world.path(a), moment) - position_at(world.path(b), moment));
}

Predictor::Predictor(InstructionSet instructions) : kernel_(kernels_of(instructions).earliest_contact) {}

Prospect Predictor::earliest_in_order(const World& world, const Candidates& candidates, const Time& now) {
  Event first;
  std::size_t index = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Event contact = contact_with(world, candidates, i, now);
    if (!(contact < first)) continue;
    first = contact;
    index = i;
  }
  return {first.time, candidates.slot(index), candidates.are_nearest() ? Image{} : candidates.image(index)};
}

}  // namespace hardball
