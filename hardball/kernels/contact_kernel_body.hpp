// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

// Compiled once for each instruction set, with its compiler options. This file may contain only templates on
// Lanes, a type local to each of those files, and functions that are always inlined: of an ordinary inline
// function the linker could take the copy with the widest instructions for the whole program.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "hardball/geometry/grazing_time.hpp"
#include "hardball/kernels/contact_kernel.hpp"
#include "hardball/kernels/vector_of_lanes.hpp"

namespace hardball {

template <class Lanes>
struct PathsOfLanes {
  VectorOfLanes<Lanes> position, velocity;
  Lanes high, low;  // of the time
};

/// Times in two parts.
template <class Lanes>
struct MomentsOfLanes {
  Lanes high, low;
};

/// The times until pairs touch, infinite if never, by the same operations in the same order as time_to_reach
/// (geometry/contact_time.hpp), so that every bit agrees.
template <class Lanes>
HARDBALL_ALWAYS_INLINE Lanes waits_of(const VectorOfLanes<Lanes>& r, const VectorOfLanes<Lanes>& v,
                                      const Lanes& reach) {
  using Mask = typename Lanes::Mask;
  const Lanes zero(0.0);
  const Lanes approach = r.x * v.x + r.y * v.y + r.z * v.z;
  const Lanes reach_squared = reach * reach;
  const Lanes distance_squared = r.x * r.x + r.y * r.y + r.z * r.z;
  const Lanes excess = distance_squared - reach_squared;
  const Lanes speed_squared = v.x * v.x + v.y * v.y + v.z * v.z;
  const Lanes closest = speed_squared * reach_squared;
  const Lanes moment_x = r.y * v.z - r.z * v.y;
  const Lanes moment_y = r.z * v.x - r.x * v.z;
  const Lanes moment_z = r.x * v.y - r.y * v.x;
  const Lanes discriminant = closest - (moment_x * moment_x + moment_y * moment_y + moment_z * moment_z);
  // More than the rounding error of the discriminant.
  const Lanes noise = Lanes(kCertainMiss) * (speed_squared * distance_squared);
  const Mask approaches = approach < zero;
  const Mask apart = excess > zero;
  const Mask grazes = approaches & apart & (discriminant <= Lanes(kGrazingCosineSquared) * closest) &
                      (zero - noise <= discriminant);
  const Mask hits = approaches & ((discriminant > zero) | not_(apart)) & not_(grazes);
  const Lanes root = square_root(maximum(discriminant, zero));
  const Lanes wait =
      select(hits, maximum(excess, zero) / (root - approach), Lanes(std::numeric_limits<double>::infinity()));
  if (bits(grazes) == 0) return wait;
  return select(grazes, grazing_time_to_reach(r.x, r.y, r.z, v.x, v.y, v.z, reach), wait);
}

/// As later() (geometry/time.hpp), of the starts of two paths.
template <class Lanes>
HARDBALL_ALWAYS_INLINE MomentsOfLanes<Lanes> later_start(const PathsOfLanes<Lanes>& a,
                                                         const PathsOfLanes<Lanes>& b) {
  const auto b_is_later = (b.high > a.high) | ((b.high == a.high) & (b.low > a.low));
  return {select(b_is_later, b.high, a.high), select(b_is_later, b.low, a.low)};
}

/// As duration() (geometry/time.hpp), from the start of a path.
template <class Lanes>
HARDBALL_ALWAYS_INLINE Lanes age_at(const MomentsOfLanes<Lanes>& moment, const PathsOfLanes<Lanes>& path) {
  return (moment.high - path.high) + (moment.low - path.low);
}

/// As after() (geometry/time.hpp).
template <class Lanes>
HARDBALL_ALWAYS_INLINE MomentsOfLanes<Lanes> moments_after(const MomentsOfLanes<Lanes>& start,
                                                           const Lanes& wait) {
  const Lanes forever(std::numeric_limits<double>::infinity());
  const Lanes sum = start.high + wait;
  const Lanes wait_part = sum - start.high;
  const Lanes error = (start.high - (sum - wait_part)) + (wait - wait_part);
  const Lanes rest = error + start.low;
  const Lanes high = sum + rest;
  const auto happens = sum < forever;
  return {select(happens, high, forever), select(happens, rest - (high - sum), Lanes(0.0))};
}

/// Where a center is on its path, and how fast, bit for bit as Motion (geometry/motion.hpp), along one axis.
template <class Lanes>
struct StraightOfLanes {
  explicit StraightOfLanes(const Vec3*) {}

  HARDBALL_ALWAYS_INLINE Lanes place(const Lanes& r, const Lanes& v, const Lanes& age, std::size_t) const {
    return r + age * v;
  }
  HARDBALL_ALWAYS_INLINE Lanes velocity(const Lanes& v, const Lanes&, std::size_t) const { return v; }
};

template <class Lanes>
struct FallingOfLanes {
  explicit FallingOfLanes(const Vec3* acceleration)
      : gravity{Lanes(acceleration->x), Lanes(acceleration->y), Lanes(acceleration->z)} {}

  HARDBALL_ALWAYS_INLINE Lanes place(const Lanes& r, const Lanes& v, const Lanes& age,
                                     std::size_t axis) const {
    return r + age * (v + (Lanes(0.5) * age) * gravity[axis]);
  }
  HARDBALL_ALWAYS_INLINE Lanes velocity(const Lanes& v, const Lanes& age, std::size_t axis) const {
    return v + age * gravity[axis];
  }

  Lanes gravity[kAxes];
};

/// When pairs touch, bit for bit as contact_time (geometry/contact_time.hpp). `shifts(a, b)` are the
/// displacements of the images of the second spheres that are meant.
template <class Lanes, class Motion, class Shifts>
HARDBALL_ALWAYS_INLINE MomentsOfLanes<Lanes> contacts_of(const PathsOfLanes<Lanes>& a,
                                                         const PathsOfLanes<Lanes>& b, const Lanes& reach,
                                                         const Motion& motion, const Shifts& shifts) {
  const MomentsOfLanes<Lanes> start = later_start(a, b);
  const Lanes a_age = age_at(start, a);
  const Lanes b_age = age_at(start, b);
  const VectorOfLanes<Lanes> shift = shifts(a, b);
  const auto separation = [&](const Lanes& ra, const Lanes& va, const Lanes& rb, const Lanes& vb,
                              std::size_t axis, const Lanes& displacement) {
    return (motion.place(rb, vb, b_age, axis) - motion.place(ra, va, a_age, axis)) + displacement;
  };
  const VectorOfLanes<Lanes> r{
      separation(a.position.x, a.velocity.x, b.position.x, b.velocity.x, 0, shift.x),
      separation(a.position.y, a.velocity.y, b.position.y, b.velocity.y, 1, shift.y),
      separation(a.position.z, a.velocity.z, b.position.z, b.velocity.z, 2, shift.z)};
  const auto relative = [&](const Lanes& va, const Lanes& vb, std::size_t axis) {
    return motion.velocity(vb, b_age, axis) - motion.velocity(va, a_age, axis);
  };
  const VectorOfLanes<Lanes> v{relative(a.velocity.x, b.velocity.x, 0),
                               relative(a.velocity.y, b.velocity.y, 1),
                               relative(a.velocity.z, b.velocity.z, 2)};
  return moments_after(start, waits_of(r, v, reach));
}

/// The displacements of nearest images at one moment.
template <class Lanes, class Motion>
class NearestShifts {
 public:
  NearestShifts(const Vec3& period, const Vec3& inverse_period, double now_high, double now_low,
                const Motion& motion)
      : period_{Lanes(period.x), Lanes(period.y), Lanes(period.z)},
        inverse_period_{Lanes(inverse_period.x), Lanes(inverse_period.y), Lanes(inverse_period.z)},
        now_{Lanes(now_high), Lanes(now_low)},
        motion_(motion) {}

  HARDBALL_ALWAYS_INLINE VectorOfLanes<Lanes> operator()(const PathsOfLanes<Lanes>& a,
                                                         const PathsOfLanes<Lanes>& b) const {
    const Lanes a_age = age_at(now_, a);
    const Lanes b_age = age_at(now_, b);
    const auto along = [&](const Lanes& ra, const Lanes& va, const Lanes& rb, const Lanes& vb,
                           std::size_t axis, const Lanes& length, const Lanes& inverse_length) {
      const Lanes apart = motion_.place(ra, va, a_age, axis) - motion_.place(rb, vb, b_age, axis);
      return round_to_integer(apart * inverse_length) * length;
    };
    return {along(a.position.x, a.velocity.x, b.position.x, b.velocity.x, 0, period_.x, inverse_period_.x),
            along(a.position.y, a.velocity.y, b.position.y, b.velocity.y, 1, period_.y, inverse_period_.y),
            along(a.position.z, a.velocity.z, b.position.z, b.velocity.z, 2, period_.z, inverse_period_.z)};
  }

 private:
  VectorOfLanes<Lanes> period_, inverse_period_;
  MomentsOfLanes<Lanes> now_;
  Motion motion_;
};

/// The kernel for pairs, for one kind of motion.
template <class Lanes, class Motion>
void contacts_of_moving_pairs(const PairQuery& query, double* high, double* low) {
  const Motion motion(query.gravity);
  const NearestShifts<Lanes, Motion> shifts(*query.period, *query.inverse_period, query.now_high,
                                            query.now_low, motion);
  for (std::size_t i = 0; i < query.count; i += Lanes::kWidth) {
    PathsOfLanes<Lanes> a;
    PathsOfLanes<Lanes> b;
    Lanes::load(query.paths, query.first + i, a);
    Lanes::load(query.paths, query.second + i, b);
    const Lanes reach = query.radii == nullptr ? Lanes(query.radius + query.radius)
                                               : Lanes::gather(query.radii, query.first + i) +
                                                     Lanes::gather(query.radii, query.second + i);
    const MomentsOfLanes<Lanes> contact = contacts_of(a, b, reach, motion, shifts);
    contact.high.store(high + i);
    contact.low.store(low + i);
  }
}

/// The kernel for pairs.
template <class Lanes>
void contacts_of_pairs(const PairQuery& query, double* high, double* low) {
  if (query.gravity == nullptr) {
    contacts_of_moving_pairs<Lanes, StraightOfLanes<Lanes>>(query, high, low);
  } else {
    contacts_of_moving_pairs<Lanes, FallingOfLanes<Lanes>>(query, high, low);
  }
}

/// The largest number of candidates in one batch.
inline constexpr std::size_t kBatch = 64;

/// The earliest contact with up to kBatch candidates. `shifts_at(i)` gives their shifts from candidate i on.
template <class Lanes, class Motion, class ShiftsAt>
EarliestContact earliest_of_batch(const ContactQuery& query, std::size_t begin, std::size_t count,
                                  const Motion& motion, const ShiftsAt& shifts_at) {
  const Path& own = query.paths[query.self];
  const auto in_all_lanes = [](const Vec3& vector) {
    return VectorOfLanes<Lanes>{Lanes(vector.x), Lanes(vector.y), Lanes(vector.z)};
  };
  const PathsOfLanes<Lanes> self{in_all_lanes(own.position), in_all_lanes(own.velocity), Lanes(own.time.high),
                                 Lanes(own.time.low)};
  alignas(64) double high[kBatch];
  alignas(64) double low[kBatch];
  Lanes least(std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < count; i += Lanes::kWidth) {
    const std::uint32_t* const others = query.others + begin + i;
    PathsOfLanes<Lanes> other;
    Lanes::load(query.paths, others, other);
    const Lanes reach = query.radii == nullptr ? Lanes(query.radius + query.radius)
                                               : Lanes(query.radius) + Lanes::gather(query.radii, others);
    const MomentsOfLanes<Lanes> contact = contacts_of(self, other, reach, motion, shifts_at(begin + i));
    contact.high.store(high + i);
    contact.low.store(low + i);
    least = minimum(least, contact.high);
  }
  const double earliest = least_of(least);
  if (!(earliest < std::numeric_limits<double>::infinity())) return {earliest, 0, 0, false};
  std::uint64_t places = 0;
  for (std::size_t i = 0; i < count; i += Lanes::kWidth) {
    places |= std::uint64_t{bits(Lanes::load(high + i) == Lanes(earliest))} << i;
  }
  const auto place = static_cast<std::uint32_t>(std::countr_zero(places));
  return {earliest, low[place], static_cast<std::uint32_t>(begin) + place, (places & (places - 1)) != 0};
}

template <class Lanes, class Motion, class ShiftsAt>
EarliestContact earliest_of_all(const ContactQuery& query, const Motion& motion, const ShiftsAt& shifts_at) {
  EarliestContact result{std::numeric_limits<double>::infinity(), 0, 0, false};
  for (std::size_t begin = 0; begin < query.count; begin += kBatch) {
    const std::size_t left = query.count - begin;
    const EarliestContact found =
        earliest_of_batch<Lanes>(query, begin, left < kBatch ? left : kBatch, motion, shifts_at);
    if (found.high < result.high) {
      result = found;
    } else if (found.high == result.high) {
      result.is_tied = true;
    }
  }
  return result;
}

/// The kernel for all kinds of query, for one kind of motion.
template <class Lanes, class Motion>
EarliestContact earliest_contact_of_moving(const ContactQuery& query) {
  const Motion motion(query.gravity);
  if (query.shifts == nullptr) {
    const NearestShifts<Lanes, Motion> nearest(*query.period, *query.inverse_period, query.now_high,
                                               query.now_low, motion);
    return earliest_of_all<Lanes>(
        query, motion, [&](std::size_t) -> const NearestShifts<Lanes, Motion>& { return nearest; });
  }
  return earliest_of_all<Lanes>(query, motion, [&query](std::size_t i) {
    return [&query, i](const PathsOfLanes<Lanes>&, const PathsOfLanes<Lanes>&) {
      return VectorOfLanes<Lanes>{Lanes::load(query.shifts[0] + i), Lanes::load(query.shifts[1] + i),
                                  Lanes::load(query.shifts[2] + i)};
    };
  });
}

/// The kernel for all kinds of query.
template <class Lanes>
EarliestContact earliest_contact(const ContactQuery& query) {
  return query.gravity == nullptr ? earliest_contact_of_moving<Lanes, StraightOfLanes<Lanes>>(query)
                                  : earliest_contact_of_moving<Lanes, FallingOfLanes<Lanes>>(query);
}

}  // namespace hardball
