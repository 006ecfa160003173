// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

// Compiled once for each instruction set: see contact_kernel_body.hpp.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "hardball/geometry/vec3.hpp"
#include "hardball/kernels/bound_kernel.hpp"

namespace hardball {

template <class Floats>
struct CompactPathsOfLanes {
  typename Floats::Integers x, y, z, tick, revision;
  VectorOf<Floats> velocity;
};

/// A sphere in every lane.
template <class Floats>
struct BoundedSphere {
  using Integers = typename Floats::Integers;

  BoundedSphere(const BoundScale& scale, const CompactPath& path, const float* radii, std::uint32_t slot)
      : x(path.position[0]),
        y(path.position[1]),
        z(path.position[2]),
        tick(path.tick),
        self(static_cast<std::int32_t>(slot)),
        velocity{Floats(path.velocity[0]), Floats(path.velocity[1]), Floats(path.velocity[2])},
        reach(scale.are_radii_alike
                  ? scale.common_reach
                  : (radii == nullptr ? scale.radii[path.revision % CompactPath::kRadii] : radii[slot]) +
                        scale.reach_allowance) {}

  Integers x, y, z, tick, self;
  VectorOf<Floats> velocity;
  Floats reach;  // the sum of both radii if all are equal, otherwise the sphere's own
};

/// What bounds depend on besides straight paths.
enum class BoundedMotion { straight, falling, growing, sheared };

/// Coefficients of the quadratic whose first zero is a bound; see docs/bounds.md.
template <class Floats>
struct Coefficients {
  Floats approach;
  Floats speed_squared;
  Floats excess;
};

/// How the nearest image of each candidate is displaced along x in a sheared box, and how fast it moves.
/// Heights are from 0 to 2^32: where their difference and the way to the nearest image have different signs,
/// that is above or below.
template <class Floats>
struct Slides {
  using Integers = typename Floats::Integers;

  Slides(const BoundScale& scale, std::int32_t slide, const Integers& own, const Integers& other) {
    const Integers middle(std::int32_t{1}
                          << 31);  // shifts heights to where their order is that of numbers with a sign
    const Integers zero(0U);
    const auto is_ahead = other - own < zero;
    const auto is_lower = other + middle < own + middle;
    const auto is_above = is_lower && !is_ahead;
    const auto is_below = is_ahead && own + middle < other + middle;
    steps = select(is_above, Integers(slide), select(is_below, zero - Integers(slide), zero));
    const Floats speed(scale.slide_speed);
    const Floats rest(0.0F);
    velocity = select(is_above, speed, select(is_below, rest - speed, rest));
  }

  Integers steps;
  Floats velocity;
};

/// A sphere in each lane as seen from the one in all lanes, when that was copied.
template <class Floats>
struct RelativeMotion {
  VectorOf<Floats> position, velocity;
};

template <BoundedMotion kind, class Floats>
HARDBALL_ALWAYS_INLINE RelativeMotion<Floats> relative_motion(const BoundScale& scale,
                                                              const BoundedSphere<Floats>& own,
                                                              CompactPathsOfLanes<Floats>& other,
                                                              std::int32_t slide) {
  constexpr bool has_gravity = kind == BoundedMotion::falling;
  using Integers = typename Floats::Integers;
  [[maybe_unused]] Floats slide_velocity;
  if constexpr (kind == BoundedMotion::sheared) {
    const Slides<Floats> slides(scale, slide, own.y, other.y);
    other.x = other.x + slides.steps;
    slide_velocity = slides.velocity;
  }
  // Differences of positions are taken modulo 2^32, and so lead to the nearest image.
  const Floats age = to_floats(own.tick - other.tick) * Floats(scale.tick);
  // The other's velocity when it is `age` old.
  const auto at_age = [&](const Floats& velocity, const Floats& at, std::size_t axis) {
    if constexpr (has_gravity) return multiply_add(at, Floats(scale.gravity[axis]), velocity);
    return velocity;
  };
  const Floats half_age = has_gravity ? age * Floats(0.5F) : age;
  const auto apart = [&](const Integers& steps, const Floats& velocity, std::size_t axis) {
    return multiply_add(at_age(velocity, half_age, axis), age, to_floats(steps) * Floats(scale.grid[axis]));
  };
  RelativeMotion<Floats> relative{
      {apart(other.x - own.x, other.velocity.x, 0), apart(other.y - own.y, other.velocity.y, 1),
       apart(other.z - own.z, other.velocity.z, 2)},
      {at_age(other.velocity.x, age, 0) - own.velocity.x, at_age(other.velocity.y, age, 1) - own.velocity.y,
       at_age(other.velocity.z, age, 2) - own.velocity.z}};
  if constexpr (kind == BoundedMotion::sheared) relative.velocity.x = relative.velocity.x + slide_velocity;
  return relative;
}

/// a . b + addend.
template <class Floats>
HARDBALL_ALWAYS_INLINE Floats dot_plus(const VectorOf<Floats>& a, const VectorOf<Floats>& b,
                                       const Floats& addend) {
  return multiply_add(a.x, b.x, multiply_add(a.y, b.y, multiply_add(a.z, b.z, addend)));
}

/// Lower bounds of the waits until others come within `reach`, with its allowance; infinite for those that
/// will not, and where `is_left_out`. Source: docs/bounds.md, in the order of its steps.
template <BoundedMotion kind, class Floats>
HARDBALL_ALWAYS_INLINE Floats wait_to_reach(const BoundScale& scale, const RelativeMotion<Floats>& relative,
                                            Floats reach, float size, const auto& is_left_out) {
  const auto& [r, v] = relative;
  const Floats zero(0.0F);
  // Each coefficient is no larger than that of the true quadratic.
  Coefficients<Floats> p;
  if constexpr (kind == BoundedMotion::growing) {
    // From the sizes at the moment of the copy on, at the greatest rate.
    const Floats growth = reach * Floats(scale.growth);
    reach = multiply_add(reach, Floats(size), Floats(scale.reach_allowance));
    constexpr float kRoundedUp = 1 + 0x1p-20F;
    constexpr float kRoundedDown = 1 - 0x1p-20F;
    p.approach = dot_plus(r, v, zero - multiply_add(reach, growth, Floats(scale.approach_allowance)));
    const Floats overtaking = (growth * Floats(kRoundedUp)) * (growth + Floats(2 * scale.speed_error));
    p.speed_squared =
        dot_plus(v, v, zero) * Floats(kRoundedDown) - (overtaking + Floats(scale.speed_allowance));
  } else {
    p.approach = dot_plus(r, v, Floats(-scale.approach_allowance));
    p.speed_squared = dot_plus(v, v, Floats(-scale.speed_allowance));
  }
  p.excess = dot_plus(r, r, zero - multiply_add(reach, reach, Floats(scale.square_allowance)));
  const auto [approach, speed_squared, excess] = p;
  Floats allowed = Floats(scale.excess_allowance) - excess;
  if constexpr (kind == BoundedMotion::growing) {
    // Where sizes grow faster than centers part, the square is negative: less must be taken from the excess.
    allowed =
        select(speed_squared < zero, zero - Floats(scale.excess_allowance), Floats(scale.excess_allowance)) -
        excess;
  }
  const Floats discriminant = multiply_add(
      approach, approach, multiply_add(speed_squared, allowed, Floats(scale.least_discriminant)));
  // NaN, of a candidate too fast to be bounded, passes as touching at once.
  const auto never = discriminant < zero || (approach >= zero && speed_squared >= zero) || is_left_out;
  constexpr float kRoundedDown = 1 - 0x1p-21F;
  constexpr float kNotZero = 0x1p-100F;
  const Floats distance = maximum(excess * Floats(kRoundedDown), zero);
  const Floats wait =
      distance / (square_root(maximum(discriminant, Floats(kNotZero))) - minimum(approach, zero));
  return select(never, Floats(std::numeric_limits<float>::infinity()), wait);
}

/// Lower bounds of the waits until others that are within `reach` leave it, or are at rest beyond it; zero of
/// paths that are too fast to be bounded. Source: docs/bounds.md, on steps.
template <class Floats>
HARDBALL_ALWAYS_INLINE Floats wait_to_leave(const BoundScale& scale, const RelativeMotion<Floats>& relative,
                                            const Floats& reach) {
  const auto& [r, v] = relative;
  const Floats zero(0.0F);
  constexpr float kRoundedUp = 1 + 0x1p-20F;
  constexpr float kRoundedDown = 1 - 0x1p-20F;
  constexpr float kRoundedMore = 0x1p-18F;
  // Each coefficient is no less than that of the true quadratic.
  const Floats nearer = reach - Floats(scale.reach_allowance);
  const Floats recession = dot_plus(r, v, Floats(scale.approach_allowance));
  const Floats speed_squared = dot_plus(v, v, zero) * Floats(kRoundedUp);
  const Floats excess = dot_plus(r, r, Floats(scale.square_allowance) - nearer * nearer);
  const Floats square = recession * recession;
  const Floats product = speed_squared * excess;
  const Floats error = (square + maximum(product, zero - product)) * Floats(kRoundedMore);
  const Floats discriminant = square - product;
  // What comes nearer first leaves at the later root, or when it is nearest.
  const Floats later_root = (square_root(maximum(discriminant - error, zero)) - recession) / speed_squared;
  const Floats only_root =
      maximum(zero - excess, zero) / (recession + square_root(maximum(discriminant + error, zero)));
  const Floats wait = select(recession < zero, later_root, only_root);
  return maximum(wait * Floats(kRoundedDown), zero);
}

/// The waits as bits with room for the indices of candidates; infinite for the sphere itself, too.
template <BoundedMotion kind, class Floats>
HARDBALL_ALWAYS_INLINE typename Floats::Integers bound_waits(const BoundScale& scale,
                                                             const CompactPath* paths, const float* radii,
                                                             const BoundedSphere<Floats>& own,
                                                             const BoundQuery& query,
                                                             const std::uint32_t* others) {
  using Integers = typename Floats::Integers;
  CompactPathsOfLanes<Floats> other;
  Floats::load(paths, others, other);
  const RelativeMotion<Floats> relative = relative_motion<kind>(scale, own, other, query.slide);
  Floats reach = own.reach;
  if (radii != nullptr) {
    reach = reach + Floats::gather(radii, others);
  } else if (!scale.are_radii_alike) {
    reach = reach + Floats::pick(scale.radii.data(), other.revision);
  }
  const auto is_self = Integers::load(others) == own.self;
  return bits_of(wait_to_reach<kind>(scale, relative, reach, query.size, is_self)) &
         Integers(~BoundKeys::kIndex);
}

/// The keys of a sphere's candidates; `is_single` says that they fill one vector, which stays in a register.
template <class Floats, bool is_single>
struct Keys {
  typename Floats::Integers least;  // in each lane
  alignas(64) std::uint32_t all[is_single ? 1 : BoundKeys::kMax];
};

template <bool has_radii, BoundedMotion kind, class Floats, bool is_single>
HARDBALL_ALWAYS_INLINE void find_keys(const BoundScale& scale, const CompactPath* paths, const float* radii,
                                      const BoundQuery& query, Keys<Floats, is_single>& keys) {
  using Integers = typename Floats::Integers;
  if constexpr (!has_radii) radii = nullptr;
  const BoundedSphere<Floats> own(scale, paths[query.self], radii, query.self);
  Integers indices = Integers::ascending();
  if constexpr (is_single) {
    keys.least = bound_waits<kind>(scale, paths, radii, own, query, query.others) | indices;
    return;
  }
  keys.least = Integers(BoundKeys::kForever);
  for (std::size_t i = 0; i < query.count; i += Floats::kWidth) {
    const Integers key = bound_waits<kind>(scale, paths, radii, own, query, query.others + i) | indices;
    indices = indices + Integers(static_cast<std::uint32_t>(Floats::kWidth));
    key.store(keys.all + i);
    keys.least = minimum(keys.least, key);
  }
}

template <class Floats, bool is_single>
HARDBALL_ALWAYS_INLINE BoundKeys least_two(const auto& query, const Keys<Floats, is_single>& keys) {
  using Integers = typename Floats::Integers;
  const Integers forever(BoundKeys::kForever);
  const std::uint32_t first = least_of(keys.least);
  // A candidate may be repeated.
  const Integers partner(query.others[first & BoundKeys::kIndex]);
  if constexpr (is_single) {
    return {first, least_of(select(Integers::load(query.others) == partner, forever, keys.least))};
  }
  Integers second = forever;
  for (std::size_t i = 0; i < query.count; i += Floats::kWidth) {
    const auto is_partner = Integers::load(query.others + i) == partner;
    second = minimum(second, select(is_partner, forever, Integers::load(keys.all + i)));
  }
  return {first, least_of(second)};
}

template <class Floats, bool has_radii, BoundedMotion kind, bool is_single>
HARDBALL_ALWAYS_INLINE BoundKeys bound_one(const BoundScale& scale, const CompactPath* paths,
                                           const float* radii, const BoundQuery& query) {
  Keys<Floats, is_single> keys;
  find_keys<has_radii, kind>(scale, paths, radii, query, keys);
  return least_two(query, keys);
}

template <class Floats, bool has_radii, BoundedMotion kind, bool is_single>
HARDBALL_ALWAYS_INLINE std::array<BoundKeys, 2> bound_two(const BoundScale& scale, const CompactPath* paths,
                                                          const float* radii, const BoundQuery& one,
                                                          const BoundQuery& other) {
  Keys<Floats, is_single> keys_of_one;
  Keys<Floats, is_single> keys_of_other;
  find_keys<has_radii, kind>(scale, paths, radii, one, keys_of_one);
  find_keys<has_radii, kind>(scale, paths, radii, other, keys_of_other);
  return {least_two(one, keys_of_one), least_two(other, keys_of_other)};
}

template <class Floats, bool has_radii, BoundedMotion kind>
HARDBALL_ALWAYS_INLINE BoundKeys bound_any(const BoundScale& scale, const CompactPath* paths,
                                           const float* radii, const BoundQuery& query) {
  return query.count <= Floats::kWidth
             ? bound_one<Floats, has_radii, kind, true>(scale, paths, radii, query)
             : bound_one<Floats, has_radii, kind, false>(scale, paths, radii, query);
}

template <class Floats, bool has_radii, BoundedMotion kind>
HARDBALL_ALWAYS_INLINE std::array<BoundKeys, 2> bound_any_two(const BoundScale& scale,
                                                              const CompactPath* paths, const float* radii,
                                                              const BoundQuery& one,
                                                              const BoundQuery& other) {
  return (one.count <= Floats::kWidth) & (other.count <= Floats::kWidth)
             ? bound_two<Floats, has_radii, kind, true>(scale, paths, radii, one, other)
             : bound_two<Floats, has_radii, kind, false>(scale, paths, radii, one, other);
}

template <class Floats, BoundedMotion kind>
BoundKeys bound_contacts_moving(const BoundScale& scale, const CompactPath* paths, const float* radii,
                                const BoundQuery& query) {
  return radii == nullptr ? bound_any<Floats, false, kind>(scale, paths, radii, query)
                          : bound_any<Floats, true, kind>(scale, paths, radii, query);
}

template <class Floats>
BoundKeys bound_contacts(const BoundScale& scale, const CompactPath* paths, const float* radii,
                         const BoundQuery& query) {
  using enum BoundedMotion;
  if (scale.has_growth) return bound_contacts_moving<Floats, growing>(scale, paths, radii, query);
  if (scale.has_gravity) return bound_contacts_moving<Floats, falling>(scale, paths, radii, query);
  if (scale.has_shear) return bound_contacts_moving<Floats, sheared>(scale, paths, radii, query);
  return bound_contacts_moving<Floats, straight>(scale, paths, radii, query);
}

template <class Floats, BoundedMotion kind>
std::array<BoundKeys, 2> bound_contacts_of_two_moving(const BoundScale& scale, const CompactPath* paths,
                                                      const float* radii, const BoundQuery& one,
                                                      const BoundQuery& other) {
  return radii == nullptr ? bound_any_two<Floats, false, kind>(scale, paths, radii, one, other)
                          : bound_any_two<Floats, true, kind>(scale, paths, radii, one, other);
}

template <class Floats>
std::array<BoundKeys, 2> bound_contacts_of_two(const BoundScale& scale, const CompactPath* paths,
                                               const float* radii, const BoundQuery& one,
                                               const BoundQuery& other) {
  using enum BoundedMotion;
  if (scale.has_growth) return bound_contacts_of_two_moving<Floats, growing>(scale, paths, radii, one, other);
  if (scale.has_gravity)
    return bound_contacts_of_two_moving<Floats, falling>(scale, paths, radii, one, other);
  if (scale.has_shear) return bound_contacts_of_two_moving<Floats, sheared>(scale, paths, radii, one, other);
  return bound_contacts_of_two_moving<Floats, straight>(scale, paths, radii, one, other);
}

template <class Floats, BoundedMotion kind>
BoundKeys bound_each_contact_moving(const BoundScale& scale, const CompactPath* paths, const float* radii,
                                    const BoundQuery& query,
                                    std::array<std::uint32_t, BoundKeys::kMax>& each) {
  Keys<Floats, false> keys;
  find_keys<true, kind>(scale, paths, radii, query, keys);
  std::memcpy(each.data(), keys.all, sizeof keys.all);
  return least_two(query, keys);
}

template <class Floats>
BoundKeys bound_each_contact(const BoundScale& scale, const CompactPath* paths, const float* radii,
                             const BoundQuery& query, std::array<std::uint32_t, BoundKeys::kMax>& each) {
  using enum BoundedMotion;
  if (scale.has_growth) return bound_each_contact_moving<Floats, growing>(scale, paths, radii, query, each);
  if (scale.has_gravity) return bound_each_contact_moving<Floats, falling>(scale, paths, radii, query, each);
  if (scale.has_shear) return bound_each_contact_moving<Floats, sheared>(scale, paths, radii, query, each);
  return bound_each_contact_moving<Floats, straight>(scale, paths, radii, query, each);
}

template <class Floats>
std::size_t keep_between(const std::uint32_t* slots, const std::uint32_t* keys, std::size_t count,
                         std::uint32_t first, std::uint32_t end, std::uint32_t* kept) {
  using Integers = typename Floats::Integers;
  std::uint32_t* next = kept;
  for (std::size_t i = 0; i < count; i += Floats::kWidth) {
    const Integers key = Integers::load(keys + i);
    const unsigned are_between = bits(!(key < Integers(first)) && key < Integers(end));
    Integers::load(slots + i).keep(are_between, next);
    next += std::popcount(are_between);
  }
  return static_cast<std::size_t>(next - kept);
}

/// The kernel for steps.
template <class Floats>
BoundKeys bound_steps(const BoundScale& scale, const CompactPath* paths, const StepBoundQuery& query) {
  using Integers = typename Floats::Integers;
  const Floats zero(0.0F);
  const Floats forever(std::numeric_limits<float>::infinity());
  const BoundedSphere<Floats> own(scale, paths[query.self], nullptr, query.self);
  Integers indices = Integers::ascending();
  Keys<Floats, false> keys;
  keys.least = Integers(BoundKeys::kForever);
  for (std::size_t i = 0; i < query.count; i += Floats::kWidth) {
    CompactPathsOfLanes<Floats> other;
    Floats::load(paths, query.others + i, other);
    const RelativeMotion<Floats> relative = relative_motion<BoundedMotion::straight>(scale, own, other, 0);
    const Floats inner = Floats::load(query.inner + i);
    const auto has_none = inner < Floats(std::numeric_limits<float>::min());
    const Floats inward = wait_to_reach<BoundedMotion::straight>(
        scale, relative, inner + Floats(scale.reach_allowance), 1, has_none);
    const Floats outward = wait_to_leave(scale, relative, Floats::load(query.outer + i));
    const auto is_self = Integers::load(query.others + i) == own.self;
    const Floats wait = select(is_self, forever, minimum(inward, outward));
    const Integers key = (bits_of(wait) & Integers(~BoundKeys::kIndex)) | indices;
    indices = indices + Integers(static_cast<std::uint32_t>(Floats::kWidth));
    key.store(keys.all + i);
    keys.least = minimum(keys.least, key);
  }
  return least_two(query, keys);
}

}  // namespace hardball
