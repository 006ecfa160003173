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

/// The times until pairs touch.
template <class Lanes>
struct Waits {
  Lanes wait;
  typename Lanes::Mask hits;    // those that touch
  typename Lanes::Mask grazes;  // those that may touch, not before `wait`: they need more digits
};

/// Lanes::kWidth pairs at a time, by the same operations in the same order as time_to_reach
/// (geometry/contact_time.hpp), so that every bit agrees.
template <class Lanes>
HARDBALL_ALWAYS_INLINE Waits<Lanes> waits_of(const VectorOfLanes<Lanes>& r, const VectorOfLanes<Lanes>& v,
                                             const Lanes& reach) {
  using Mask = typename Lanes::Mask;
  // More than the rounding error of a squared distance.
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
  // More than the rounding error of the discriminant.
  const Lanes noise = Lanes(kCertainMiss) * (speed_squared * distance_squared);
  const Mask apart = excess > zero;
  const Mask grazes = approaches & apart & (discriminant <= Lanes(kGrazingCosineSquared) * closest) &
                      (zero - noise <= discriminant);
  const Mask hits = approaches & ((discriminant > zero) | not_(apart)) & not_(grazes);
  // For a graze, a larger root and a smaller numerator than possible: a lower bound.
  const Lanes root =
      square_root(maximum(select(grazes, maximum(discriminant, zero) + noise, discriminant), zero));
  const Lanes distance = maximum(select(grazes, excess - Lanes(kRounding) * distance_squared, excess), zero);
  return {distance / (root - approach), hits, grazes};
}

/// A sphere and its candidates, in the form that lanes need.
template <class Lanes, bool kNearest>
class PairsOfLanes {
 public:
  explicit PairsOfLanes(const ContactQuery& query)
      : query_(query), own_(query.paths[query.self]), reach_(query.radius + query.radius) {
    if constexpr (kNearest) {
      own_age_ = (query.now_high - own_.time.high) + (query.now_low - own_.time.low);
      period_ = {Lanes(query.period->x), Lanes(query.period->y), Lanes(query.period->z)};
      inverse_period_ = {Lanes(query.inverse_period->x), Lanes(query.inverse_period->y),
                         Lanes(query.inverse_period->z)};
    }
  }

  Lanes reach(const std::uint32_t* others) const {
    return query_.radii == nullptr ? reach_ : Lanes(query_.radius) + Lanes::gather(query_.radii, others);
  }

  /// The displacement of the images along an axis.
  Lanes shift(std::size_t begin, std::size_t axis, const Lanes& own_place, const Lanes& place) const {
    if constexpr (kNearest) {
      const auto along = [axis](const VectorOfLanes<Lanes>& a) -> const Lanes& {
        return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
      };
      return round_to_integer((own_place - place) * along(inverse_period_)) * along(period_);
    } else {
      return Lanes::load(query_.shifts[axis] + begin);
    }
  }

  /// The sphere's coordinate along an axis when images are the nearest.
  Lanes own_place(double position, double velocity) const { return Lanes(position + own_age_ * velocity); }

 private:
  const ContactQuery& query_;
  const Path& own_;
  Lanes reach_;
  double own_age_ = 0;
  VectorOfLanes<Lanes> period_, inverse_period_;
};

/// The largest number of candidates in one batch.
inline constexpr std::size_t kBatch = 64;

/// When the sphere meets the candidates of a batch: a wait, or the high and low parts of a time.
template <class Lanes>
struct Contacts {
  alignas(64) double first[kBatch];  // infinite if never
  alignas(64) double second[kBatch];
  std::size_t count = 0;
  std::uint64_t grazes = 0;  // a bit for each candidate whose contact, if there is one, is not before `first`

  std::uint64_t at(double value) const {
    std::uint64_t equal = 0;
    for (std::size_t i = 0; i < count; i += Lanes::kWidth) {
      equal |= std::uint64_t{bits(Lanes::load(first + i) == Lanes(value))} << i;
    }
    return equal;
  }

  double least() const {
    Lanes least = Lanes::load(first);
    for (std::size_t i = Lanes::kWidth; i < count; i += Lanes::kWidth) {
      least = minimum(least, Lanes::load(first + i));
    }
    return least_of(least);
  }

  void settle(std::size_t index, double first_part, double second_part) {
    first[index] = first_part;
    second[index] = second_part;
    grazes &= ~(std::uint64_t{1} << index);
  }
};

/// The earliest of a batch.
struct EarliestOfBatch {
  double first;  // infinite if there is none
  std::size_t index;
  bool is_tied;  // another has the same `first`
};

/// The earliest contact no later than `limit`; `least` is the least of the first parts. Grazing contacts are
/// computed with more digits, by settle_graze(index), only if they come first. The loops over lanes leave
/// this to the end: an unpredictable branch there would discard work already begun on the next lanes.
template <class Lanes, class SettleGraze>
HARDBALL_ALWAYS_INLINE EarliestOfBatch earliest_of(const Contacts<Lanes>& contacts, double least,
                                                   double limit, const SettleGraze& settle_graze) {
  constexpr double kForever = std::numeric_limits<double>::infinity();
  for (;;) {
    if (!(least < kForever) || least > limit) return {kForever, 0, false};
    const std::uint64_t earliest = contacts.at(least);
    const std::uint64_t grazes = earliest & contacts.grazes;
    if (grazes == 0) {
      return {least, static_cast<std::size_t>(std::countr_zero(earliest)), (earliest & (earliest - 1)) != 0};
    }
    settle_graze(static_cast<std::size_t>(std::countr_zero(grazes)));
    least = contacts.least();
  }
}

/// A time in two parts.
template <class Lanes>
struct MomentOfLanes {
  double high, low;
};

/// The time `wait` after a start, as in after() (geometry/time.hpp).
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

/// A grazing contact, computed with more digits.
template <class Lanes>
struct GrazingContact {
  double start_high, start_low;  // the later start of the two paths
  double wait;                   // from there
};

template <class Lanes, bool kNearest>
GrazingContact<Lanes> grazing_contact(const ContactQuery& query, std::size_t index) {
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
  const double period[] = {query.period->x, query.period->y, query.period->z};
  const double inverse_period[] = {query.inverse_period->x, query.inverse_period->y, query.inverse_period->z};
  const auto separation = [&](std::size_t axis, double a, double va, double b, double vb) {
    double shift = 0;
    if constexpr (kNearest) {
      constexpr double kPusher = 0x1.8p52;  // adding this rounds to an integer
      const double boxes = ((a + own_age * va) - (b + other_age * vb)) * inverse_period[axis];
      shift = ((boxes + kPusher) - kPusher) * period[axis];
    } else {
      shift = query.shifts[axis][index];
    }
    return ((b + other_wait * vb) - (a + own_wait * va)) + shift;
  };
  const double reach =
      query.radius + (query.radii != nullptr ? query.radii[query.others[index]] : query.radius);
  return {
      start_high, start_low,
      grazing_time_to_reach(separation(0, own.position.x, own.velocity.x, other.position.x, other.velocity.x),
                            separation(1, own.position.y, own.velocity.y, other.position.y, other.velocity.y),
                            separation(2, own.position.z, own.velocity.z, other.position.z, other.velocity.z),
                            other.velocity.x - own.velocity.x, other.velocity.y - own.velocity.y,
                            other.velocity.z - own.velocity.z, reach)};
}

/// The earliest contact of a sphere whose path may have started at any time, as by contact_time.
/// Precondition: at most kBatch candidates.
template <class Lanes, bool kNearest>
EarliestContact earliest_moment(const ContactQuery& query) {
  using Mask = typename Lanes::Mask;
  const Path& own = query.paths[query.self];
  const PairsOfLanes<Lanes, kNearest> pairs(query);
  const Lanes own_high(own.time.high);
  const Lanes own_low(own.time.low);
  const Lanes forever(std::numeric_limits<double>::infinity());
  Contacts<Lanes> contacts;
  contacts.count = query.count;
  Lanes least = forever;
  std::uint64_t grazes = 0;
  for (std::size_t i = 0; i < query.count; i += Lanes::kWidth) {
    PathsOfLanes<Lanes> other;
    Lanes::load(query.paths, query.others + i, other);

    // The later start, and both centres at that time.
    const Mask other_later = (other.high > own_high) | ((other.high == own_high) & (other.low > own_low));
    const Lanes start_high = select(other_later, other.high, own_high);
    const Lanes start_low = select(other_later, other.low, own_low);
    const Lanes own_wait = (start_high - own_high) + (start_low - own_low);
    const Lanes other_wait = (start_high - other.high) + (start_low - other.low);
    const Lanes age = (Lanes(query.now_high) - other.high) + (Lanes(query.now_low) - other.low);
    const auto separation = [&](const Lanes& b, const Lanes& vb, double a, double va, std::size_t axis) {
      const Lanes shift = pairs.shift(i, axis, pairs.own_place(a, va), b + age * vb);
      return ((b + other_wait * vb) - (Lanes(a) + own_wait * Lanes(va))) + shift;
    };
    const VectorOfLanes<Lanes> r{
        separation(other.position.x, other.velocity.x, own.position.x, own.velocity.x, 0),
        separation(other.position.y, other.velocity.y, own.position.y, own.velocity.y, 1),
        separation(other.position.z, other.velocity.z, own.position.z, own.velocity.z, 2)};
    const VectorOfLanes<Lanes> v{other.velocity.x - Lanes(own.velocity.x),
                                 other.velocity.y - Lanes(own.velocity.y),
                                 other.velocity.z - Lanes(own.velocity.z)};
    const Waits<Lanes> waits = waits_of(r, v, pairs.reach(query.others + i));

    // The time of contact, as in after() (geometry/time.hpp).
    const Lanes sum = start_high + waits.wait;
    const Lanes wait_part = sum - start_high;
    const Lanes error = (start_high - (sum - wait_part)) + (waits.wait - wait_part);
    const Lanes rest = error + start_low;
    const Lanes time_high = sum + rest;
    const Lanes time_low = rest - (time_high - sum);

    const Lanes first = select((waits.hits | waits.grazes) & (sum < forever), time_high, forever);
    first.store(contacts.first + i);
    time_low.store(contacts.second + i);
    least = minimum(least, first);
    grazes |= std::uint64_t{bits(waits.grazes)} << i;
  }
  contacts.grazes = grazes;
  const auto settle_graze = [&](std::size_t index) {
    const auto contact = grazing_contact<Lanes, kNearest>(query, index);
    const auto moment = moment_after<Lanes>(contact.start_high, contact.start_low, contact.wait);
    contacts.settle(index, moment.high, moment.low);
  };
  const EarliestOfBatch found = earliest_of(contacts, least_of(least), query.limit, settle_graze);
  return {found.first, contacts.second[found.index], static_cast<std::uint32_t>(found.index), found.is_tied};
}

/// The later of two starts, and the time of contact `wait` after it, as in later() and after()
/// (geometry/time.hpp).
template <class Lanes>
struct MomentsOfLanes {
  Lanes high, low;
};

template <class Lanes>
HARDBALL_ALWAYS_INLINE MomentsOfLanes<Lanes> later_start(const PathsOfLanes<Lanes>& a,
                                                         const PathsOfLanes<Lanes>& b) {
  const auto b_is_later = (b.high > a.high) | ((b.high == a.high) & (b.low > a.low));
  return {select(b_is_later, b.high, a.high), select(b_is_later, b.low, a.low)};
}

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

template <class Lanes>
void contacts_of_pairs(const PairQuery& query, double* high, double* low) {
  const VectorOfLanes<Lanes> period{Lanes(query.period->x), Lanes(query.period->y), Lanes(query.period->z)};
  const VectorOfLanes<Lanes> inverse_period{Lanes(query.inverse_period->x), Lanes(query.inverse_period->y),
                                            Lanes(query.inverse_period->z)};
  const Lanes forever(std::numeric_limits<double>::infinity());
  const Lanes zero(0.0);
  for (std::size_t i = 0; i < query.count; i += Lanes::kWidth) {
    PathsOfLanes<Lanes> a;
    PathsOfLanes<Lanes> b;
    Lanes::load(query.paths, query.first + i, a);
    Lanes::load(query.paths, query.second + i, b);
    const MomentsOfLanes<Lanes> start = later_start(a, b);
    const auto age_at = [](const MomentsOfLanes<Lanes>& moment, const PathsOfLanes<Lanes>& path) {
      return (moment.high - path.high) + (moment.low - path.low);
    };
    const MomentsOfLanes<Lanes> now{Lanes(query.now_high), Lanes(query.now_low)};
    const Lanes a_age = age_at(now, a);
    const Lanes b_age = age_at(now, b);
    const Lanes a_wait = age_at(start, a);
    const Lanes b_wait = age_at(start, b);
    const auto separation = [&](const Lanes& ra, const Lanes& va, const Lanes& rb, const Lanes& vb,
                                const Lanes& length, const Lanes& inverse_length) {
      const Lanes shift = round_to_integer(((ra + a_age * va) - (rb + b_age * vb)) * inverse_length) * length;
      return ((rb + b_wait * vb) - (ra + a_wait * va)) + shift;
    };
    const VectorOfLanes<Lanes> r{
        separation(a.position.x, a.velocity.x, b.position.x, b.velocity.x, period.x, inverse_period.x),
        separation(a.position.y, a.velocity.y, b.position.y, b.velocity.y, period.y, inverse_period.y),
        separation(a.position.z, a.velocity.z, b.position.z, b.velocity.z, period.z, inverse_period.z)};
    const VectorOfLanes<Lanes> v{b.velocity.x - a.velocity.x, b.velocity.y - a.velocity.y,
                                 b.velocity.z - a.velocity.z};
    const Lanes reach = query.radii == nullptr ? Lanes(query.radius + query.radius)
                                               : Lanes::gather(query.radii, query.first + i) +
                                                     Lanes::gather(query.radii, query.second + i);
    const Waits<Lanes> waits = waits_of(r, v, reach);
    Lanes wait = select(waits.hits, waits.wait, forever);
    if (bits(waits.grazes) != 0) {
      wait = select(waits.grazes, grazing_time_to_reach(r.x, r.y, r.z, v.x, v.y, v.z, reach), wait);
    }
    const MomentsOfLanes<Lanes> contact = moments_after(start, wait);
    contact.high.store(high + i);
    contact.low.store(low + i);
  }
}

/// The same for a sphere whose path has just started, so that all waits count from its own start: most
/// predictions, at two thirds of the work.
template <class Lanes, bool kNearest>
EarliestContact earliest_wait(const ContactQuery& query) {
  constexpr double kForever = std::numeric_limits<double>::infinity();
  // Adding shorter waits to the start time may round different ones to the same time.
  constexpr double kShortest = 0x1p-48;
  const Path& own = query.paths[query.self];
  const PairsOfLanes<Lanes, kNearest> pairs(query);
  const Lanes own_high(own.time.high);
  const Lanes own_low(own.time.low);
  const Lanes forever(kForever);
  Contacts<Lanes> contacts;
  contacts.count = query.count;
  Lanes least = forever;
  std::uint64_t grazes = 0;
  for (std::size_t i = 0; i < query.count; i += Lanes::kWidth) {
    PathsOfLanes<Lanes> other;
    Lanes::load(query.paths, query.others + i, other);
    const Lanes age = (own_high - other.high) + (own_low - other.low);
    const auto separation = [&](const Lanes& b, const Lanes& vb, double a, std::size_t axis) {
      const Lanes place = b + age * vb;
      return (place - Lanes(a)) + pairs.shift(i, axis, Lanes(a), place);
    };
    const VectorOfLanes<Lanes> r{separation(other.position.x, other.velocity.x, own.position.x, 0),
                                 separation(other.position.y, other.velocity.y, own.position.y, 1),
                                 separation(other.position.z, other.velocity.z, own.position.z, 2)};
    const VectorOfLanes<Lanes> v{other.velocity.x - Lanes(own.velocity.x),
                                 other.velocity.y - Lanes(own.velocity.y),
                                 other.velocity.z - Lanes(own.velocity.z)};
    const Waits<Lanes> waits = waits_of(r, v, pairs.reach(query.others + i));
    const Lanes first = select(waits.hits | waits.grazes, waits.wait, forever);
    first.store(contacts.first + i);
    least = minimum(least, first);
    grazes |= std::uint64_t{bits(waits.grazes)} << i;
  }
  contacts.grazes = grazes;
  const auto settle_graze = [&](std::size_t index) {
    contacts.settle(index, grazing_contact<Lanes, kNearest>(query, index).wait, 0);
  };
  const EarliestOfBatch found = earliest_of(contacts, least_of(least), kForever, settle_graze);
  const auto moment = moment_after<Lanes>(own.time.high, own.time.low, found.first);
  const double moment_size = own.time.high < 0 ? -own.time.high : own.time.high;
  return {moment.high, moment.low, static_cast<std::uint32_t>(found.index),
          found.is_tied || found.first < kShortest * moment_size};
}

template <class Lanes>
EarliestContact run_batch(const ContactQuery& query) {
  const Path& own = query.paths[query.self];
  const bool nearest = query.shifts == nullptr;
  if (own.time.high == query.now_high && own.time.low == query.now_low) {
    return nearest ? earliest_wait<Lanes, true>(query) : earliest_wait<Lanes, false>(query);
  }
  return nearest ? earliest_moment<Lanes, true>(query) : earliest_moment<Lanes, false>(query);
}

template <class Lanes>
EarliestContact run_batches(const ContactQuery& query) {
  EarliestContact result{std::numeric_limits<double>::infinity(), 0, 0, false};
  for (std::size_t begin = 0; begin < query.count; begin += kBatch) {
    ContactQuery batch = query;
    batch.others += begin;
    batch.count = query.count - begin < kBatch ? query.count - begin : kBatch;
    if (result.high < batch.limit) batch.limit = result.high;
    const double* shifts[3];
    if (query.shifts != nullptr) {
      for (int axis = 0; axis < 3; ++axis) shifts[axis] = query.shifts[axis] + begin;
      batch.shifts = shifts;
    }
    EarliestContact found = run_batch<Lanes>(batch);
    found.index += static_cast<std::uint32_t>(begin);
    if (found.high < result.high) {
      result = found;
    } else if (found.high == result.high) {
      result.is_tied = true;
    }
  }
  return result;
}

/// The kernel for all kinds of query.
template <class Lanes>
EarliestContact earliest_contact(const ContactQuery& query) {
  return query.count <= kBatch ? run_batch<Lanes>(query) : run_batches<Lanes>(query);
}

}  // namespace hardball
