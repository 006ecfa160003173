// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

// Compiled once for each instruction set, with the compiler's options for it. Only templates on Lanes, a type
// that each of those files has for itself, may stand here, and what is always inlined: an ordinary inline
// function could be taken from the file with the widest instructions for the whole program.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "hardball/geometry/grazing_time.hpp"
#include "hardball/prediction/kernel.hpp"

namespace hardball {

template <class Lanes>
struct VectorOfLanes {
  Lanes x, y, z;
};

template <class Lanes>
struct PathsOfLanes {
  VectorOfLanes<Lanes> position, velocity;
  Lanes high, low;  // of the time
};

/// A moment of one pair.
template <class Lanes>
struct MomentOfLanes {
  double high, low;
};

/// The moment `wait` after `start`, as in after() (geometry/time.hpp), of a contact that needs more digits.
template <class Lanes, bool kNearest>
MomentOfLanes<Lanes> grazing_contact(const KernelQuery& query, std::uint32_t index) {
  const Path& own = query.paths[query.self];
  const Path& other = query.paths[query.others[index]];
  const bool other_later =
      other.time.high > own.time.high || (other.time.high == own.time.high && other.time.low > own.time.low);
  const double start_high = other_later ? other.time.high : own.time.high;
  const double start_low = other_later ? other.time.low : own.time.low;
  const double own_wait = (start_high - own.time.high) + (start_low - own.time.low);
  const double other_wait = (start_high - other.time.high) + (start_low - other.time.low);
  const double own_age = (query.now_high - own.time.high) + (query.now_low - own.time.low);
  const double other_age = (query.now_high - other.time.high) + (query.now_low - other.time.low);
  const double own_position[] = {own.position.x, own.position.y, own.position.z};
  const double own_velocity[] = {own.velocity.x, own.velocity.y, own.velocity.z};
  const double other_position[] = {other.position.x, other.position.y, other.position.z};
  const double other_velocity[] = {other.velocity.x, other.velocity.y, other.velocity.z};
  double r[3];
  double v[3];
  for (int axis = 0; axis < 3; ++axis) {
    const double a = own_position[axis];
    const double va = own_velocity[axis];
    const double b = other_position[axis];
    const double vb = other_velocity[axis];
    double shift = 0;
    if constexpr (kNearest) {
      constexpr double kPusher = 0x1.8p52;  // adding this number pushes the fraction out
      const double boxes = ((a + own_age * va) - (b + other_age * vb)) * query.inverse_period[axis];
      shift = ((boxes + kPusher) - kPusher) * query.period[axis];
    } else {
      shift = query.shifts[axis][index];
    }
    r[axis] = ((b + other_wait * vb) - (a + own_wait * va)) + shift;
    v[axis] = vb - va;
  }
  const double reach =
      query.radius + (query.radii != nullptr ? query.radii[query.others[index]] : query.radius);
  const double wait = grazing_time_to_reach(r[0], r[1], r[2], v[0], v[1], v[2], reach);
  const double sum = start_high + wait;
  if (!(sum < std::numeric_limits<double>::infinity())) return {std::numeric_limits<double>::infinity(), 0};
  const double wait_part = sum - start_high;
  const double error = (start_high - (sum - wait_part)) + (wait - wait_part);
  const double rest = error + start_low;
  const double high = sum + rest;
  return {high, rest - (high - sum)};
}

/// The contact times of Lanes::kWidth candidates at once, by the same operations in the same order as
/// contact_time and time_to_reach (geometry/contact_time.hpp), so that every bit agrees.
template <class Lanes, bool kNearest>
KernelResult earliest_contact(const KernelQuery& query, const KernelNotes& notes) {
  using Mask = typename Lanes::Mask;
  constexpr double kForever = std::numeric_limits<double>::infinity();
  // More than rounding does to the wait, as a fraction of it.
  constexpr double kRounding = 0x1p-44;

  const Path& own = query.paths[query.self];
  const Lanes own_high(own.time.high);
  const Lanes own_low(own.time.low);
  const VectorOfLanes<Lanes> own_position{Lanes(own.position.x), Lanes(own.position.y), Lanes(own.position.z)};
  const VectorOfLanes<Lanes> own_velocity{Lanes(own.velocity.x), Lanes(own.velocity.y), Lanes(own.velocity.z)};
  const Lanes zero(0.0);
  const Lanes forever(kForever);
  const Lanes limit(query.limit);
  Lanes reach(query.radius + query.radius);
  const double own_age = kNearest ? (query.now_high - own.time.high) + (query.now_low - own.time.low) : 0;
  const VectorOfLanes<Lanes> own_place{Lanes(own.position.x + own_age * own.velocity.x),
                                       Lanes(own.position.y + own_age * own.velocity.y),
                                       Lanes(own.position.z + own_age * own.velocity.z)};

  Lanes best_high = forever;
  Lanes best_low = zero;
  Lanes best_index = zero;
  Lanes index = Lanes::counting();
  unsigned tied = 0;
  std::uint32_t grazing_count = 0;

  for (std::size_t begin = 0; begin < query.count; begin += Lanes::kWidth, index = index + Lanes(Lanes::kWidth)) {
    const std::uint32_t* others = query.others + begin;
    PathsOfLanes<Lanes> other;
    Lanes::load(query.paths, others, other);
    if (query.radii != nullptr) reach = Lanes(query.radius) + Lanes::gather(query.radii, others);

    // The later of the two moments, and both centres then.
    const Mask other_later = (other.high > own_high) | ((other.high == own_high) & (other.low > own_low));
    const Lanes start_high = select(other_later, other.high, own_high);
    const Lanes start_low = select(other_later, other.low, own_low);
    const Lanes own_wait = (start_high - own_high) + (start_low - own_low);
    const Lanes other_wait = (start_high - other.high) + (start_low - other.low);

    Lanes shift_x = zero;
    Lanes shift_y = zero;
    Lanes shift_z = zero;
    if constexpr (kNearest) {
      const Lanes age = (Lanes(query.now_high) - other.high) + (Lanes(query.now_low) - other.low);
      const auto nearest = [&](const Lanes& place, const Lanes& position, const Lanes& velocity, int axis) {
        const Lanes apart = place - (position + age * velocity);
        return round_to_integer(apart * Lanes(query.inverse_period[axis])) * Lanes(query.period[axis]);
      };
      shift_x = nearest(own_place.x, other.position.x, other.velocity.x, 0);
      shift_y = nearest(own_place.y, other.position.y, other.velocity.y, 1);
      shift_z = nearest(own_place.z, other.position.z, other.velocity.z, 2);
    } else {
      shift_x = Lanes::load(query.shifts[0] + begin);
      shift_y = Lanes::load(query.shifts[1] + begin);
      shift_z = Lanes::load(query.shifts[2] + begin);
    }
    const auto separation = [&](const Lanes& b, const Lanes& vb, const Lanes& a, const Lanes& va,
                                const Lanes& shift) { return ((b + other_wait * vb) - (a + own_wait * va)) + shift; };
    const Lanes rx = separation(other.position.x, other.velocity.x, own_position.x, own_velocity.x, shift_x);
    const Lanes ry = separation(other.position.y, other.velocity.y, own_position.y, own_velocity.y, shift_y);
    const Lanes rz = separation(other.position.z, other.velocity.z, own_position.z, own_velocity.z, shift_z);
    const Lanes vx = other.velocity.x - own_velocity.x;
    const Lanes vy = other.velocity.y - own_velocity.y;
    const Lanes vz = other.velocity.z - own_velocity.z;

    const Lanes approach = rx * vx + ry * vy + rz * vz;
    const Mask approaches = approach < zero;
    const Lanes reach_squared = reach * reach;
    const Lanes distance_squared = rx * rx + ry * ry + rz * rz;
    const Lanes excess = distance_squared - reach_squared;
    const Lanes speed_squared = vx * vx + vy * vy + vz * vz;
    const Lanes closest = speed_squared * reach_squared;
    const Lanes moment_x = ry * vz - rz * vy;
    const Lanes moment_y = rz * vx - rx * vz;
    const Lanes moment_z = rx * vy - ry * vx;
    const Lanes discriminant = closest - (moment_x * moment_x + moment_y * moment_y + moment_z * moment_z);

    // More than rounding does to the discriminant.
    const Lanes noise = Lanes(kCertainMiss) * (speed_squared * distance_squared);

    const Mask apart = excess > zero;
    const Mask grazes = approaches & apart & (discriminant <= Lanes(kGrazingCosineSquared) * closest) &
                        (zero - noise <= discriminant);
    const Mask hits = approaches & ((discriminant > zero) | not_(apart)) & not_(grazes);

    // For a graze: more under the root and less above than can be, so that the time comes out too early.
    const Lanes root =
        square_root(maximum(select(grazes, maximum(discriminant, zero) + noise, discriminant), zero));
    const Lanes distance = select(grazes, maximum(excess - Lanes(kRounding) * distance_squared, zero),
                                  maximum(excess, zero));
    const Lanes wait = distance / (root - approach);

    const Lanes sum = start_high + wait;
    const Lanes wait_part = sum - start_high;
    const Lanes error = (start_high - (sum - wait_part)) + (wait - wait_part);
    const Lanes rest = error + start_low;
    const Lanes time_high = sum + rest;
    const Lanes time_low = rest - (time_high - sum);

    const Mask happens = hits & (sum < forever);
    const Lanes high = select(happens, time_high, forever);
    const Mask same = happens & (high == best_high);
    const Mask earlier = (high < best_high) | (same & (time_low < best_low));
    tied |= bits(same & (time_low == best_low));
    best_high = select(earlier, high, best_high);
    best_low = select(earlier, time_low, best_low);
    best_index = select(earlier, index, best_index);

    // Those to be looked at again, if they may come before the earliest so far.
    const Mask again = grazes & (time_high <= best_high) & (time_high <= limit);
    if (unsigned lanes = bits(again); lanes != 0) {
      double bounds[Lanes::kWidth];
      time_high.store(bounds);
      for (; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
        notes.grazing[grazing_count] = static_cast<std::uint32_t>(begin) + lane;
        notes.bounds[grazing_count++] = bounds[lane];
      }
    }
  }

  KernelResult result{least_of(best_high), 0, 0, tied != 0};
  if (result.high < kForever) {
    double lows[Lanes::kWidth];
    double indices[Lanes::kWidth];
    best_low.store(lows);
    best_index.store(indices);
    unsigned lanes = bits(best_high == Lanes(result.high));
    unsigned best = static_cast<unsigned>(std::countr_zero(lanes));
    for (lanes &= lanes - 1; lanes != 0; lanes &= lanes - 1) {
      const unsigned lane = static_cast<unsigned>(std::countr_zero(lanes));
      if (lows[lane] == lows[best]) result.is_tied = true;
      if (lows[lane] < lows[best]) best = lane;
    }
    result.low = lows[best];
    result.index = static_cast<std::uint32_t>(indices[best]);
  }
  for (std::uint32_t i = 0; i < grazing_count; ++i) {
    if (notes.bounds[i] > result.high) continue;
    const MomentOfLanes<Lanes> moment = grazing_contact<Lanes, kNearest>(query, notes.grazing[i]);
    if (moment.high > result.high || moment.high == kForever) continue;
    if (moment.high == result.high && moment.low == result.low) result.is_tied = true;
    if (moment.high == result.high && moment.low >= result.low) continue;
    result.high = moment.high;
    result.low = moment.low;
    result.index = notes.grazing[i];
  }
  return result;
}

/// The kernel for both kinds of query.
template <class Lanes>
KernelResult run_kernel(const KernelQuery& query, const KernelNotes& notes) {
  return query.shifts[0] == nullptr ? earliest_contact<Lanes, true>(query, notes)
                                    : earliest_contact<Lanes, false>(query, notes);
}

}  // namespace hardball
