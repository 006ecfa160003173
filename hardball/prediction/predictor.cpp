// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/prediction/predictor.hpp"

#include "hardball/errors/error.hpp"
#include "hardball/events/event.hpp"

namespace hardball {
namespace {

Kernel kernel_of(InstructionSet instructions) {
  if (!is_available(instructions)) {
    throw Error("this machine does not have the vector instructions asked for", "instructions",
                "let the widest be chosen, or take the portable ones");
  }
#if defined(__x86_64__) && defined(__GNUC__)
  if (instructions == InstructionSet::avx512) return avx512_kernel;
  if (instructions == InstructionSet::avx2) return avx2_kernel;
#endif
  return portable_kernel;
}

// As in the kernels: adding this number pushes the fraction out.
double round_to_integer(double number) {
  constexpr double kPusher = 0x1.8p52;
  return (number + kPusher) - kPusher;
}

// The contact time of one candidate, its copy and the place of both in the order of events.
Event contact_with(const World& world, const Candidates& candidates, std::size_t i, const Time& now) {
  const Slot self = candidates.self();
  const Slot other = candidates.slot(i);
  const Image image = candidates.are_nearest() ? nearest_image(world, self, other, now) : candidates.image(i);
  return make_collision(contact_time(world, self, other, image), world.id(self), world.id(other), image);
}

}  // namespace

Image nearest_image(const World& world, Slot a, Slot b, const Time& moment) {
  const Vec3 apart = position_at(world.path(a), moment) - position_at(world.path(b), moment);
  Image image;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    image[axis] =
        static_cast<std::int32_t>(round_to_integer(apart[axis] * world.box().inverse_period()[axis]));
  }
  return image;
}

Predictor::Predictor(InstructionSet instructions) : kernel_(kernel_of(instructions)) {}

Prospect Predictor::earliest(const World& world, const Candidates& candidates, const Time& now,
                             const Time& limit) const {
  if (candidates.size() == 0) return {};
  const Slot self = candidates.self();
  const bool listed = !candidates.are_nearest();
  const double* shifts[kAxes];
  if (listed) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) shifts[axis] = candidates.shifts(axis);
  }
  const KernelQuery query{
      .paths = world.paths().data(),
      .radii = world.radii().is_common() ? nullptr : world.radii().each().data(),
      .radius = world.radius(self),
      .self = self,
      .others = candidates.slots(),
      .count = candidates.size(),
      .shifts = listed ? shifts : nullptr,
      .period = &world.box().period(),
      .inverse_period = &world.box().inverse_period(),
      .now_high = now.high,
      .now_low = now.low,
      .limit = limit.high,
  };
  const KernelResult found = kernel_(query);
  if (!(found.high < kNever.high)) return {};
  Time time{found.high, found.low};
  std::size_t index = found.index;
  if (found.is_tied) [[unlikely]] {
    Event first;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const Event contact = contact_with(world, candidates, i, now);
      if (!(contact < first)) continue;
      first = contact;
      index = i;
    }
    time = first.time;
  }
  return {time, candidates.slot(index), listed ? candidates.image(index) : Image{}};
}

}  // namespace hardball
