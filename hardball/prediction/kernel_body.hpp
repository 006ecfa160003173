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

/// How long it takes until pairs touch.
template <class Lanes>
struct Waits {
  Lanes wait;
  typename Lanes::Mask hits;    // those that touch
  typename Lanes::Mask grazes;  // those that perhaps do, then not before `wait`: they need more digits
};

/// Lanes::kWidth pairs at once, by the same operations in the same order as time_to_reach
/// (geometry/contact_time.hpp), so that every bit agrees.
template <class Lanes>
HARDBALL_ALWAYS_INLINE Waits<Lanes> waits_of(const VectorOfLanes<Lanes>& r, const VectorOfLanes<Lanes>& v,
                                             const Lanes& reach) {
  using Mask = typename Lanes::Mask;
  // More than rounding does to the square of a distance.
  constexpr double kRounding = 0x1p-44;
  const Lanes zero(0.0);
  const Lanes approach = r.x * v.x + r.y * v.y + r.z * v.z;
  const Mask approaches = approach < zero;
  const Lanes reach_squared = reach * reach;
  const Lanes distance_squared = r.x * r.x + r.y * r.y + r.z * r.z;
  const Lanes excess = distance_squared - reach_squared;
  const Lanes speed_squared = v.x * v.x + v.y * v.y + v.z * v.z;
  const Lanes closest = speed_squared * reach_squared;
  const Lanes moment_x = r.y * v.z - r.z * v.y;
  const Lanes moment_y = r.z * v.x - r.x * v.z;
  const Lanes moment_z = r.x * v.y - r.y * v.x;
  const Lanes discriminant = closest - (moment_x * moment_x + moment_y * moment_y + moment_z * moment_z);
  // More than rounding does to the discriminant.
  const Lanes noise = Lanes(kCertainMiss) * (speed_squared * distance_squared);
  const Mask apart = excess > zero;
  const Mask grazes = approaches & apart & (discriminant <= Lanes(kGrazingCosineSquared) * closest) &
                      (zero - noise <= discriminant);
  const Mask hits = approaches & ((discriminant > zero) | not_(apart)) & not_(grazes);
  // Of a graze more under the root and less above than can be: too early.
  const Lanes root =
      square_root(maximum(select(grazes, maximum(discriminant, zero) + noise, discriminant), zero));
  const Lanes distance = maximum(select(grazes, excess - Lanes(kRounding) * distance_squared, excess), zero);
  return {distance / (root - approach), hits, grazes};
}

/// A sphere and its candidates, in the form in which all lanes need it.
template <class Lanes, bool kNearest>
class PairsOfLanes {
 public:
  explicit PairsOfLanes(const KernelQuery& query)
      : query_(query), own_(query.paths[query.self]), reach_(query.radius + query.radius) {
    if constexpr (kNearest) {
      own_age_ = (query.now_high - own_.time.high) + (query.now_low - own_.time.low);
    }
  }

  Lanes reach(const std::uint32_t* others) const {
    return query_.radii == nullptr ? reach_ : Lanes(query_.radius) + Lanes::gather(query_.radii, others);
  }

  /// The displacement of the copies meant, along an axis.
  Lanes shift(std::size_t begin, std::size_t axis, const Lanes& own_place, const Lanes& place) const {
    if constexpr (kNearest) {
      return round_to_integer((own_place - place) * Lanes(query_.inverse_period[axis])) *
             Lanes(query_.period[axis]);
    } else {
      return Lanes::load(query_.shifts[axis] + begin);
    }
  }

  /// Where the sphere is when copies are the nearest, along an axis.
  Lanes own_place(double position, double velocity) const { return Lanes(position + own_age_ * velocity); }

 private:
  const KernelQuery& query_;
  const Path& own_;
  Lanes reach_;
  double own_age_ = 0;
};

/// Keeps what is earliest in each lane.
template <class Lanes>
struct Earliest {
  Lanes first, second;  // the leading and the trailing part of a time; of a wait, only the leading
  Lanes index;
  unsigned tied = 0;
};

/// The index of the earliest of all lanes; whether another is as early.
template <class Lanes>
std::uint32_t best_index(const Earliest<Lanes>& earliest, double first, double& second, bool& tied) {
  double seconds[Lanes::kWidth];
  double indices[Lanes::kWidth];
  earliest.second.store(seconds);
  earliest.index.store(indices);
  unsigned lanes = bits(earliest.first == Lanes(first));
  auto best = static_cast<unsigned>(std::countr_zero(lanes));
  for (lanes &= lanes - 1; lanes != 0; lanes &= lanes - 1) {
    const auto lane = static_cast<unsigned>(std::countr_zero(lanes));
    if (seconds[lane] == seconds[best]) tied = true;
    if (seconds[lane] < seconds[best]) best = lane;
  }
  second = seconds[best];
  return static_cast<std::uint32_t>(indices[best]);
}

/// A moment, in two parts.
template <class Lanes>
struct MomentOfLanes {
  double high, low;
};

/// The moment `wait` after a start, as in after() (geometry/time.hpp).
template <class Lanes>
MomentOfLanes<Lanes> moment_after(double start_high, double start_low, double wait) {
  constexpr double kForever = std::numeric_limits<double>::infinity();
  const double sum = start_high + wait;
  if (!(sum < kForever)) return {kForever, 0};
  const double wait_part = sum - start_high;
  const double error = (start_high - (sum - wait_part)) + (wait - wait_part);
  const double rest = error + start_low;
  const double high = sum + rest;
  return {high, rest - (high - sum)};
}

/// The contact of one candidate that the sphere grazes, with more digits.
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
  return moment_after<Lanes>(start_high, start_low,
                             grazing_time_to_reach(r[0], r[1], r[2], v[0], v[1], v[2], reach));
}

/// Looks again, with more digits, at the candidates whose contact times have bounds no later than the
/// earliest. The loops over lanes leave this to the end: a branch there that cannot be foreseen would undo
/// the work already begun on the next lanes.
template <class Lanes, bool kNearest>
void look_again(const KernelQuery& query, const double* bounds, KernelResult& result) {
  for (std::size_t begin = 0; begin < query.count; begin += Lanes::kWidth) {
    const Lanes bound = Lanes::load(bounds + begin);
    // Never is a bound, too, of those that do not graze.
    unsigned lanes = bits((bound <= Lanes(result.high)) & (bound <= Lanes(query.limit)) &
                          (bound < Lanes(std::numeric_limits<double>::infinity())));
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto index =
          static_cast<std::uint32_t>(begin) + static_cast<std::uint32_t>(std::countr_zero(lanes));
      if (bounds[index] > result.high) continue;
      const MomentOfLanes<Lanes> moment = grazing_contact<Lanes, kNearest>(query, index);
      if (moment.high > result.high || !(moment.high < std::numeric_limits<double>::infinity())) continue;
      if (moment.high == result.high && moment.low == result.low) result.is_tied = true;
      if (moment.high == result.high && moment.low >= result.low) continue;
      result.high = moment.high;
      result.low = moment.low;
      result.index = index;
    }
  }
}

/// The earliest contact of a sphere whose path has begun at any time; as contact_time does it.
template <class Lanes, bool kNearest>
KernelResult earliest_contact(const KernelQuery& query, double* bounds) {
  using Mask = typename Lanes::Mask;
  constexpr double kForever = std::numeric_limits<double>::infinity();
  const Path& own = query.paths[query.self];
  const PairsOfLanes<Lanes, kNearest> pairs(query);
  const Lanes own_high(own.time.high);
  const Lanes own_low(own.time.low);
  const Lanes zero(0.0);
  const Lanes forever(kForever);
  Earliest<Lanes> best{forever, zero, zero};
  Lanes index = Lanes::counting();
  for (std::size_t begin = 0; begin < query.count;
       begin += Lanes::kWidth, index = index + Lanes(Lanes::kWidth)) {
    PathsOfLanes<Lanes> other;
    Lanes::load(query.paths, query.others + begin, other);

    // The later of the two moments, and both centres then.
    const Mask other_later = (other.high > own_high) | ((other.high == own_high) & (other.low > own_low));
    const Lanes start_high = select(other_later, other.high, own_high);
    const Lanes start_low = select(other_later, other.low, own_low);
    const Lanes own_wait = (start_high - own_high) + (start_low - own_low);
    const Lanes other_wait = (start_high - other.high) + (start_low - other.low);
    const Lanes age = (Lanes(query.now_high) - other.high) + (Lanes(query.now_low) - other.low);
    const auto separation = [&](const Lanes& b, const Lanes& vb, double a, double va, std::size_t axis) {
      const Lanes shift = pairs.shift(begin, axis, pairs.own_place(a, va), b + age * vb);
      return ((b + other_wait * vb) - (Lanes(a) + own_wait * Lanes(va))) + shift;
    };
    const VectorOfLanes<Lanes> r{
        separation(other.position.x, other.velocity.x, own.position.x, own.velocity.x, 0),
        separation(other.position.y, other.velocity.y, own.position.y, own.velocity.y, 1),
        separation(other.position.z, other.velocity.z, own.position.z, own.velocity.z, 2)};
    const VectorOfLanes<Lanes> v{other.velocity.x - Lanes(own.velocity.x),
                                 other.velocity.y - Lanes(own.velocity.y),
                                 other.velocity.z - Lanes(own.velocity.z)};
    const Waits<Lanes> waits = waits_of(r, v, pairs.reach(query.others + begin));

    // The moment that long after the start, as in after() (geometry/time.hpp).
    const Lanes sum = start_high + waits.wait;
    const Lanes wait_part = sum - start_high;
    const Lanes error = (start_high - (sum - wait_part)) + (waits.wait - wait_part);
    const Lanes rest = error + start_low;
    const Lanes time_high = sum + rest;
    const Lanes time_low = rest - (time_high - sum);

    const Mask happens = waits.hits & (sum < forever);
    const Lanes high = select(happens, time_high, forever);
    const Mask same = happens & (high == best.first);
    const Mask earlier = (high < best.first) | (same & (time_low < best.second));
    best.tied |= bits(same & (time_low == best.second));
    best.first = select(earlier, high, best.first);
    best.second = select(earlier, time_low, best.second);
    best.index = select(earlier, index, best.index);
    select(waits.grazes, time_high, forever).store(bounds + begin);
  }
  KernelResult result{least_of(best.first), 0, 0, best.tied != 0};
  if (result.high < kForever) result.index = best_index(best, result.high, result.low, result.is_tied);
  look_again<Lanes, kNearest>(query, bounds, result);
  return result;
}

/// The same for a sphere whose path has just begun, so that all waits count from its own moment: most of the
/// predictions, with two thirds of the work.
template <class Lanes, bool kNearest>
KernelResult earliest_contact_from_now(const KernelQuery& query, double* bounds) {
  using Mask = typename Lanes::Mask;
  constexpr double kForever = std::numeric_limits<double>::infinity();
  // Waits so short against the moment itself are told apart by fewer digits than they have.
  constexpr double kShortest = 0x1p-48;
  const Path& own = query.paths[query.self];
  const PairsOfLanes<Lanes, kNearest> pairs(query);
  const Lanes own_high(own.time.high);
  const Lanes own_low(own.time.low);
  const Lanes zero(0.0);
  const Lanes forever(kForever);
  Earliest<Lanes> best{forever, zero, zero};
  Lanes index = Lanes::counting();
  for (std::size_t begin = 0; begin < query.count;
       begin += Lanes::kWidth, index = index + Lanes(Lanes::kWidth)) {
    PathsOfLanes<Lanes> other;
    Lanes::load(query.paths, query.others + begin, other);
    const Lanes age = (own_high - other.high) + (own_low - other.low);
    const auto separation = [&](const Lanes& b, const Lanes& vb, double a, std::size_t axis) {
      const Lanes place = b + age * vb;
      return (place - Lanes(a)) + pairs.shift(begin, axis, Lanes(a), place);
    };
    const VectorOfLanes<Lanes> r{separation(other.position.x, other.velocity.x, own.position.x, 0),
                                 separation(other.position.y, other.velocity.y, own.position.y, 1),
                                 separation(other.position.z, other.velocity.z, own.position.z, 2)};
    const VectorOfLanes<Lanes> v{other.velocity.x - Lanes(own.velocity.x),
                                 other.velocity.y - Lanes(own.velocity.y),
                                 other.velocity.z - Lanes(own.velocity.z)};
    const Waits<Lanes> waits = waits_of(r, v, pairs.reach(query.others + begin));
    const Mask happens = waits.hits & (waits.wait < forever);
    best.tied |= bits(happens & (waits.wait == best.first));
    const Mask earlier = happens & (waits.wait < best.first);
    best.first = select(earlier, waits.wait, best.first);
    best.index = select(earlier, index, best.index);
    // A sum rounded once is no later than the sum of a longer wait.
    select(waits.grazes, own_high + waits.wait, forever).store(bounds + begin);
  }
  KernelResult result{kForever, 0, 0, best.tied != 0};
  const double wait = least_of(best.first);
  if (wait < kForever) {
    const MomentOfLanes<Lanes> moment = moment_after<Lanes>(own.time.high, own.time.low, wait);
    double unused = 0;
    result.index = best_index(best, wait, unused, result.is_tied);
    result.high = moment.high;
    result.low = moment.low;
    const double moment_size = own.time.high < 0 ? -own.time.high : own.time.high;
    if (wait < kShortest * moment_size) result.is_tied = true;
  }
  look_again<Lanes, kNearest>(query, bounds, result);
  return result;
}

/// The kernel for all kinds of query.
template <class Lanes>
KernelResult run_kernel(const KernelQuery& query, double* bounds) {
  const Path& own = query.paths[query.self];
  const bool nearest = query.shifts[0] == nullptr;
  if (own.time.high == query.now_high && own.time.low == query.now_low) {
    return nearest ? earliest_contact_from_now<Lanes, true>(query, bounds)
                   : earliest_contact_from_now<Lanes, false>(query, bounds);
  }
  return nearest ? earliest_contact<Lanes, true>(query, bounds)
                 : earliest_contact<Lanes, false>(query, bounds);
}

}  // namespace hardball
