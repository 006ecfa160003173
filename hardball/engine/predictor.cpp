// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/engine/predictor.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "hardball/events/event.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/pair_event.hpp"

namespace hardball {

Event contact_with(const World& world, const Candidates& candidates, std::size_t i, const Time& now) {
  const Slot self = candidates.self();
  const Slot other = candidates.slot(i);
  const Image image =
      candidates.uses_minimum_image() ? nearest_image(world, self, other, now) : candidates.image(i);
  return make_collision(contact_time(world, self, other, image), world.id(self), world.id(other), image);
}

Predictor::Predictor(InstructionSet instructions) : kernels_(&kernels_of(instructions)) {}

void Predictor::compute(const World& world, const Time& now, PairContacts& pairs) const {
  if (pairs.count == 0) return;
  if (world.has_steps()) {
    for (std::size_t i = 0; i < pairs.count; ++i) {
      const Image image = nearest_image(world, pairs.first[i], pairs.second[i], now);
      const Time time = contact_time(world, pairs.first[i], pairs.second[i], image);
      pairs.high[i] = time.high;
      pairs.low[i] = time.low;
    }
    return;
  }
  // The kernel computes whole vectors.
  std::fill_n(pairs.first.begin() + static_cast<std::ptrdiff_t>(pairs.count), kWidestVector, pairs.first[0]);
  std::fill_n(pairs.second.begin() + static_cast<std::ptrdiff_t>(pairs.count), kWidestVector,
              pairs.second[0]);
  const PairQuery query{
      .paths = world.paths().data(),
      .radii = world.base_radii().is_common() ? nullptr : world.base_radii().each().data(),
      .radius = world.base_radius(0),
      .first = pairs.first.data(),
      .second = pairs.second.data(),
      .count = pairs.count,
      .period = &world.box().period(),
      .inverse_period = &world.box().inverse_period(),
      .now_high = now.high,
      .now_low = now.low,
      .gravity = gravity_of(world),
      .growth = growth_of(world),
      .images = sliding_images_of(world),
  };
  kernels_->contacts_of_pairs(query, pairs.high.data(), pairs.low.data());
}

PredictedContact Predictor::earliest(const World& world, const CompactPaths& copies,
                                     const Candidates& candidates, const Time& now) const {
  constexpr std::size_t kFew = 8;
  if (candidates.size() <= kFew || world.has_steps() || !is_usual(copies, candidates))
    return earliest(world, candidates, now);
  const Slot self = candidates.self();
  const double base = rounded_down(now);
  std::array<std::uint32_t, BoundKeys::kMax> keys;
  const BoundKeys least =
      kernels_->bound_each_contact(copies.scale(), copies.paths().data(), copies.radii_for_bounds(),
                                   query_of(copies, candidates, base, copies.slide_at(now)), keys);
  if (!BoundKeys::touches(least.first)) return {};
  std::array<Slot, BoundKeys::kMax + kWidestVector> chosen;
  const auto earliest_between = [&](std::uint32_t first, std::uint32_t end) {
    const std::size_t count =
        kernels_->keep_between(candidates.slots(), keys.data(), candidates.size(), first, end, chosen.data());
    if (count == 0) return EarliestContact{kNever.high, 0, self, false};
    std::fill_n(chosen.begin() + static_cast<std::ptrdiff_t>(count), kWidestVector, self);
    EarliestContact found = earliest_of(world, self, chosen.data(), count, nullptr, now);
    found.index = chosen[found.index];
    return found;
  };
  // First those that may come at once: where spheres nearly touch, several waits are zero.
  const std::uint32_t soon = BoundKeys::above(BoundKeys::wait(least.second));
  EarliestContact found = earliest_between(0, soon);
  // Then those whose bounds are not later, rounding included.
  constexpr double kRoundedUp = 1 + 0x1p-20;
  const double wait = kRoundedUp * (std::nextafter(found.high, kNever.high) - base) / copies.time_unit();
  const EarliestContact other = earliest_between(soon, BoundKeys::above(static_cast<float>(wait)));
  const bool is_tied = other.high == found.high;
  if (other.high < found.high) found = other;
  if (!(found.high < kNever.high)) return {};
  if (found.is_tied || is_tied) [[unlikely]]
    return earliest_in_order(world, candidates, now);
  return {{found.high, found.low}, found.index, Image{}};
}

BoundedContacts Predictor::bound_with_care(const CompactPaths& copies, const Candidates& candidates,
                                           const Time& now) const {
  const double base = rounded_down(now);
  const Slot self = candidates.self();
  const bool is_bounded = copies.is_bounded(self);
  BoundedContacts found;
  found.partner = self;
  const auto note = [&](double time, Slot other) {
    if (other == self || other == found.partner) return;
    if (time < found.least) {
      found = {time, found.least, other};
    } else {
      found.second = std::min(found.second, time);
    }
  };
  for (std::size_t begin = 0; begin < candidates.size(); begin += BoundKeys::kMax) {
    BoundQuery query = query_of(copies, candidates, base, copies.slide_at(now));
    query.others += begin;
    query.count = std::min(candidates.size() - begin, BoundKeys::kMax);
    if (!is_bounded) {
      for (std::size_t i = 0; i < query.count; ++i) note(base, query.others[i]);
      continue;
    }
    const BoundKeys keys =
        kernels_->bound_contacts(copies.scale(), copies.paths().data(), copies.radii_for_bounds(), query);
    for (const std::uint32_t key : {keys.first, keys.second}) {
      if (!BoundKeys::touches(key)) break;
      note(base + copies.time_unit() * static_cast<double>(BoundKeys::wait(key)),
           query.others[BoundKeys::index(key)]);
    }
  }
  return found;
}

PredictedContact Predictor::earliest_in_order(const World& world, const Candidates& candidates,
                                              const Time& now) {
  Event first;
  std::size_t index = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    // A sphere may be its own candidate, and never meets itself.
    if (candidates.slot(i) == candidates.self()) continue;
    const Event contact = contact_with(world, candidates, i, now);
    if (!(contact < first)) continue;
    first = contact;
    index = i;
  }
  if (!first.happens()) return {};
  return {first.time, candidates.slot(index),
          candidates.uses_minimum_image() ? Image{} : candidates.image(index)};
}

}  // namespace hardball
