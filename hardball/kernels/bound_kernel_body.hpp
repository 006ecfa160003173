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

/// A sphere in every lane.
template <class Floats>
struct BoundedSphere {
  using Integers = typename Floats::Integers;

  BoundedSphere(const BoundScale& scale, const CompactPath& path, const float* radii, std::uint32_t slot)
      : x(path.place[0]),
        y(path.place[1]),
        z(path.place[2]),
        tick(path.tick),
        self(static_cast<std::int32_t>(slot)),
        velocity{Floats(path.velocity[0]), Floats(path.velocity[1]), Floats(path.velocity[2])},
        reach(radii == nullptr ? scale.common_reach : radii[slot] + scale.reach_allowance) {}

  Integers x, y, z, tick, self;
  VectorOfLanes<Floats> velocity;
  Floats reach;  // the sum of both radii if all are equal, otherwise the sphere's own
};

/// Lower bounds of the waits for Floats::kWidth candidates; infinite for those that will not touch, and for
/// the sphere itself. Source: docs/bounds.md, in the order of its steps.
template <class Floats>
HARDBALL_ALWAYS_INLINE Floats bound_waits(const BoundScale& scale, const CompactPath* paths,
                                          const float* radii, const BoundedSphere<Floats>& own,
                                          const std::uint32_t* others) {
  using Integers = typename Floats::Integers;
  const Floats zero(0.0F);
  CompactPathsOfLanes<Floats> other;
  Floats::load(paths, others, other);

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
  if (radii != nullptr) reach = reach + Floats::gather(radii, others);

  // Each coefficient is no larger than that of the true quadratic.
  const Floats approach = dot_plus(r, v, Floats(-scale.approach_allowance));
  const Floats speed_squared = dot_plus(v, v, Floats(-scale.speed_allowance));
  const Floats excess = dot_plus(r, r, zero - multiply_add(reach, reach, Floats(scale.square_allowance)));
  const Floats discriminant = multiply_add(
      approach, approach,
      multiply_add(speed_squared, Floats(scale.excess_allowance) - excess, Floats(scale.least_discriminant)));
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
HARDBALL_ALWAYS_INLINE ContactBounds least_two(const BoundScale& scale, const CompactPath* paths,
                                               const float* radii, std::uint32_t self,
                                               const std::uint32_t* others, std::size_t count) {
  const BoundedSphere<Floats> own(scale, paths[self], radii, self);
  const Floats forever(std::numeric_limits<float>::infinity());
  alignas(64) float waits[kBoundBatch];
  // In each lane, the least two.
  Floats least = forever;
  Floats second = forever;
  for (std::size_t i = 0; i < count; i += Floats::kWidth) {
    const Floats wait = bound_waits(scale, paths, radii, own, others + i);
    wait.store(waits + i);
    second = minimum(second, maximum(least, wait));
    least = minimum(least, wait);
  }
  ContactBounds found{least_of(least), 0, self};
  if (!(found.least < std::numeric_limits<float>::infinity())) return {found.least, found.least, self};
  const auto is_least = least == Floats(found.least);
  const unsigned lanes = bits(is_least);
  found.second =
      (lanes & (lanes - 1)) == 0 ? least_of(minimum(second, select(is_least, forever, least))) : found.least;
  std::uint64_t places = 0;
  for (std::size_t i = 0; i < count; i += Floats::kWidth) {
    places |= std::uint64_t{bits(Floats::load(waits + i) == Floats(found.least))} << i;
  }
  found.partner = others[std::countr_zero(places)];
  if (found.second > found.least) [[likely]]
    return found;
  // A candidate may be repeated.
  found.second = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    if (others[i] != found.partner && waits[i] < found.second) found.second = waits[i];
  }
  return found;
}

/// The kernel, for any number of candidates.
template <class Floats>
ContactBounds bound_contacts(const BoundScale& scale, const CompactPath* paths, const float* radii,
                             std::uint32_t self, const std::uint32_t* others, std::size_t count) {
  ContactBounds all{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(), self};
  for (std::size_t begin = 0;; begin += kBoundBatch) {
    const std::size_t left = count - begin;
    const ContactBounds found =
        least_two<Floats>(scale, paths, radii, self, others + begin, left < kBoundBatch ? left : kBoundBatch);
    if (count <= kBoundBatch) return found;
    const bool is_sooner = found.least < all.least;
    const ContactBounds& first = is_sooner ? found : all;
    const ContactBounds& other = is_sooner ? all : found;
    const float rest = other.partner == first.partner ? other.second : other.least;
    const float second = first.second < rest ? first.second : rest;
    all = {first.least, second, first.partner};
    if (left <= kBoundBatch) return all;
  }
}

}  // namespace hardball
