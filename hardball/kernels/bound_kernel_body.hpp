// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

// Compiled once for each instruction set: see contact_kernel_body.hpp.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "hardball/geometry/always_inline.hpp"
#include "hardball/kernels/bound_kernel.hpp"
#include "hardball/kernels/vector_of_lanes.hpp"

namespace hardball {

template <class Floats>
struct CompactPathsOfLanes {
  typename Floats::Integers x, y, z, tick;
  VectorOfLanes<Floats> velocity;
};

/// The sphere of a query in every lane.
template <class Floats>
struct BoundedSphere {
  using Integers = typename Floats::Integers;

  explicit BoundedSphere(const BoundQuery& query)
      : x(query.own->place[0]),
        y(query.own->place[1]),
        z(query.own->place[2]),
        tick(query.own->tick),
        self(static_cast<std::int32_t>(query.self)),
        velocity{Floats(query.own->velocity[0]), Floats(query.own->velocity[1]),
                 Floats(query.own->velocity[2])},
        reach(query.radius + (query.radii == nullptr ? query.radius : 0) + query.scale->reach_allowance) {}

  Integers x, y, z, tick, self;
  VectorOfLanes<Floats> velocity;
  Floats reach;  // the sum of both radii if all are equal, otherwise the sphere's own
};

/// Lower bounds of the waits for Floats::kWidth candidates; infinite for those that will not touch, and for
/// the sphere itself. Source: docs/bounds.md, in the order of its steps.
template <class Floats>
HARDBALL_ALWAYS_INLINE Floats bound_waits(const BoundQuery& query, const BoundedSphere<Floats>& own,
                                          const std::uint32_t* others) {
  using Integers = typename Floats::Integers;
  const BoundScale& scale = *query.scale;
  const Floats zero(0.0F);
  CompactPathsOfLanes<Floats> other;
  Floats::load(query.paths, others, other);

  // Differences of places are taken modulo 2^32, and so lead to the nearest image.
  const Floats age = to_floats(own.tick - other.tick) * Floats(scale.tick);
  const VectorOfLanes<Floats> r{
      multiply_add(other.velocity.x, age, to_floats(other.x - own.x) * Floats(scale.grid[0])),
      multiply_add(other.velocity.y, age, to_floats(other.y - own.y) * Floats(scale.grid[1])),
      multiply_add(other.velocity.z, age, to_floats(other.z - own.z) * Floats(scale.grid[2]))};
  const VectorOfLanes<Floats> v{other.velocity.x - own.velocity.x, other.velocity.y - own.velocity.y,
                                other.velocity.z - own.velocity.z};
  const auto dot_plus = [](const VectorOfLanes<Floats>& a, const VectorOfLanes<Floats>& b,
                           const Floats& addend) {
    return multiply_add(a.x, b.x, multiply_add(a.y, b.y, multiply_add(a.z, b.z, addend)));
  };
  Floats reach = own.reach;
  if (query.radii != nullptr) reach = reach + Floats::gather(query.radii, others);

  // Each coefficient is no larger than that of the true quadratic.
  const Floats approach = dot_plus(r, v, Floats(-scale.approach_allowance));
  const Floats speed_squared = dot_plus(v, v, Floats(-scale.speed_allowance));
  const Floats excess = dot_plus(r, r, zero - multiply_add(reach, reach, Floats(scale.square_allowance)));
  const Floats discriminant =
      multiply_add(approach, approach,
                   multiply_add(speed_squared, Floats(scale.excess_allowance) - excess,
                                Floats(scale.least_discriminant)));
  // NaN, of a candidate too fast to be bounded, passes as touching at once.
  const auto never = (discriminant < zero) | ((approach >= zero) & (speed_squared >= zero));
  const Floats root = square_root(maximum(discriminant, zero));
  const Floats wait = maximum(excess, zero) / (root - minimum(approach, zero));
  constexpr float kRoundedDown = 1 - 0x1p-21F;
  return select(never | (Integers::load(others) == own.self), Floats(std::numeric_limits<float>::infinity()),
                maximum(wait * Floats(kRoundedDown), zero));
}

/// The least two of up to kBoundBatch waits.
inline constexpr std::size_t kBoundBatch = 64;

template <class Floats>
ContactBounds least_two(const BoundQuery& query) {
  const BoundedSphere<Floats> own(query);
  const Floats forever(std::numeric_limits<float>::infinity());
  alignas(64) float waits[kBoundBatch];
  // In each lane, the least two.
  Floats least = forever;
  Floats second = forever;
  for (std::size_t i = 0; i < query.count; i += Floats::kWidth) {
    const Floats wait = bound_waits(query, own, query.others + i);
    wait.store(waits + i);
    second = minimum(second, maximum(least, wait));
    least = minimum(least, wait);
  }
  ContactBounds found{least_of(least), 0, query.self};
  if (!(found.least < std::numeric_limits<float>::infinity())) return {found.least, found.least, query.self};
  const unsigned at_least = bits(least == Floats(found.least));
  const bool is_single = (at_least & (at_least - 1)) == 0;
  found.second = is_single ? least_of(minimum(second, select(least == Floats(found.least), forever, least)))
                           : found.least;
  std::uint64_t places = 0;
  for (std::size_t i = 0; i < query.count; i += Floats::kWidth) {
    places |= std::uint64_t{bits(Floats::load(waits + i) == Floats(found.least))} << i;
  }
  found.partner = query.others[std::countr_zero(places)];
  return found;
}

/// The kernel, for any number of candidates.
template <class Floats>
ContactBounds bound_contacts(const BoundQuery& query) {
  if (query.count <= kBoundBatch) return least_two<Floats>(query);
  ContactBounds all{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(),
                    query.self};
  for (std::size_t begin = 0; begin < query.count; begin += kBoundBatch) {
    BoundQuery batch = query;
    batch.others += begin;
    batch.count = query.count - begin < kBoundBatch ? query.count - begin : kBoundBatch;
    const ContactBounds found = least_two<Floats>(batch);
    const bool is_sooner = found.least < all.least;
    const ContactBounds& first = is_sooner ? found : all;
    const ContactBounds& other = is_sooner ? all : found;
    const float second = first.second < other.least ? first.second : other.least;
    all = {first.least, second, first.partner};
  }
  return all;
}

}  // namespace hardball
