// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

// Compiled once for each instruction set, with its compiler options. This file may contain only templates on
// Lanes, a type local to each of those files, and functions that are always inlined: of an ordinary inline
// function the linker could take the copy with the widest instructions for the whole program. It loads and
// stores; the arithmetic is that of single pairs (geometry/contact_time.hpp), compiled for Lanes.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "hardball/geometry/contact_time.hpp"
#include "hardball/geometry/exit_time.hpp"
#include "hardball/kernels/contact_kernel.hpp"

namespace hardball {

template <class Lanes>
HARDBALL_ALWAYS_INLINE VectorOf<Lanes> in_all_lanes(const Vec3& vector) {
  return {Lanes(vector.x), Lanes(vector.y), Lanes(vector.z)};
}

/// Calls `compute` with the kind of motion that a query names.
template <class Lanes, class Compute>
HARDBALL_ALWAYS_INLINE auto for_motion(const auto& query, const Compute& compute) {
  if (query.growth != nullptr) return compute(GrowingMotion<Lanes>(*query.growth));
  if (query.gravity != nullptr) return compute(FallingMotion<Lanes>{in_all_lanes<Lanes>(*query.gravity)});
  return compute(StraightMotion{});
}

/// The displacements of the images that are nearest when a query says.
template <class Lanes, class AnyMotion>
class NearestShifts {
 public:
  NearestShifts(const auto& query, const AnyMotion& motion)
      : period_(in_all_lanes<Lanes>(*query.period)),
        inverse_period_(in_all_lanes<Lanes>(*query.inverse_period)),
        now_(Lanes(query.now_high), Lanes(query.now_low)),
        motion_(motion) {}

  HARDBALL_ALWAYS_INLINE VectorOf<Lanes> operator()(const PathOf<Lanes>& a, const PathOf<Lanes>& b) const {
    const VectorOf<Lanes> boxes = nearest_boxes(
        motion_.state_at(a, now_).position - motion_.state_at(b, now_).position, inverse_period_);
    return {boxes.x * period_.x, boxes.y * period_.y, boxes.z * period_.z};
  }

 private:
  VectorOf<Lanes> period_, inverse_period_;
  TimeOf<Lanes> now_;
  AnyMotion motion_;
};

/// Contact times of nearest images when a query says.
template <class Lanes, class AnyMotion>
class NearestContacts {
 public:
  NearestContacts(const auto& query, const AnyMotion& motion) : shift_(query, motion), motion_(motion) {}

  HARDBALL_ALWAYS_INLINE TimeOf<Lanes> operator()(const PathOf<Lanes>& a, const PathOf<Lanes>& b,
                                                  const Lanes& reach) const {
    return contact_time(motion_, a, b, shift_(a, b), reach);
  }

 private:
  NearestShifts<Lanes, AnyMotion> shift_;
  AnyMotion motion_;
};

/// Contacts with the nearest images of a sheared box.
template <class Lanes>
class NearestSlidingContacts {
 public:
  explicit NearestSlidingContacts(const auto& query)
      : images_(*query.images),
        period_(in_all_lanes<Lanes>(*query.period)),
        inverse_period_(in_all_lanes<Lanes>(*query.inverse_period)),
        now_(Lanes(query.now_high), Lanes(query.now_low)) {}

  HARDBALL_ALWAYS_INLINE TimeOf<Lanes> operator()(const PathOf<Lanes>& a, const PathOf<Lanes>& b,
                                                  const Lanes& reach) const {
    const StraightMotion motion;
    const VectorOf<Lanes> apart = motion.state_at(a, now_).position - motion.state_at(b, now_).position;
    VectorOf<Lanes> image = nearest_boxes(apart, inverse_period_);
    image.x = round_to_integer(images_.beyond(apart.x, image.y, now_) * inverse_period_.x);
    return contact_time_of_sliding(images_, period_, a, b, image, reach);
  }

 private:
  SlidingImages images_;
  VectorOf<Lanes> period_, inverse_period_;
  TimeOf<Lanes> now_;
};

/// Calls `compute` with the contact times of nearest images that a query means.
template <class Lanes, class Compute>
HARDBALL_ALWAYS_INLINE auto for_nearest(const auto& query, const Compute& compute) {
  if (query.images != nullptr) return compute(NearestSlidingContacts<Lanes>(query));
  return for_motion<Lanes>(query, [&]<class AnyMotion>(const AnyMotion& motion) {
    return compute(NearestContacts<Lanes, AnyMotion>(query, motion));
  });
}

/// The kernel for pairs.
template <class Lanes>
void contacts_of_pairs(const PairQuery& query, double* high, double* low) {
  for_nearest<Lanes>(query, [&](const auto& contact_of) {
    for (std::size_t i = 0; i < query.count; i += Lanes::kWidth) {
      PathOf<Lanes> a;
      PathOf<Lanes> b;
      Lanes::load(query.paths, query.first + i, a);
      Lanes::load(query.paths, query.second + i, b);
      const Lanes reach = query.radii == nullptr ? Lanes(query.radius + query.radius)
                                                 : Lanes::gather(query.radii, query.first + i) +
                                                       Lanes::gather(query.radii, query.second + i);
      const TimeOf<Lanes> contact = contact_of(a, b, reach);
      contact.high.store(high + i);
      contact.low.store(low + i);
    }
  });
}

/// The largest number of candidates in one batch.
inline constexpr std::size_t kBatch = 64;

/// The earliest of up to kBatch times: time(i, self, other) gives those with the spheres from the i-th on, if
/// `self` is the path of the sphere and `other` are theirs.
template <class Lanes, class Query, class TimeWith>
HARDBALL_ALWAYS_INLINE EarliestContact earliest_of_batch(const Query& query, std::size_t begin,
                                                         std::size_t count, const TimeWith& time) {
  const Path& own = query.paths[query.self];
  const PathOf<Lanes> self{in_all_lanes<Lanes>(own.position),
                           in_all_lanes<Lanes>(own.velocity),
                           {Lanes(own.time.high), Lanes(own.time.low)}};
  alignas(64) double high[kBatch];
  alignas(64) double low[kBatch];
  Lanes least(std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < count; i += Lanes::kWidth) {
    PathOf<Lanes> other;
    Lanes::load(query.paths, query.others + begin + i, other);
    const TimeOf<Lanes> contact = time(begin + i, self, other);
    contact.high.store(high + i);
    contact.low.store(low + i);
    least = minimum(least, contact.high);
  }
  const double earliest = least_of(least);
  if (!(earliest < std::numeric_limits<double>::infinity())) return {earliest, 0, 0, false};
  std::uint64_t earliest_lanes = 0;
  for (std::size_t i = 0; i < count; i += Lanes::kWidth) {
    earliest_lanes |= std::uint64_t{bits(Lanes::load(high + i) == Lanes(earliest))} << i;
  }
  const auto first = static_cast<std::uint32_t>(std::countr_zero(earliest_lanes));
  return {earliest, low[first], static_cast<std::uint32_t>(begin) + first,
          (earliest_lanes & (earliest_lanes - 1)) != 0};
}

template <class Lanes, class Query, class TimeWith>
EarliestContact earliest_of_all(const Query& query, const TimeWith& time) {
  EarliestContact result{std::numeric_limits<double>::infinity(), 0, 0, false};
  for (std::size_t begin = 0; begin < query.count; begin += kBatch) {
    const std::size_t left = query.count - begin;
    const EarliestContact found = earliest_of_batch<Lanes>(query, begin, left < kBatch ? left : kBatch, time);
    if (found.high < result.high) {
      result = found;
    } else if (found.high == result.high) {
      result.is_tied = true;
    }
  }
  return result;
}

/// The kernel for steps.
template <class Lanes>
EarliestContact earliest_step(const StepQuery& query) {
  using Paths = PathOf<Lanes>;
  const StraightMotion motion;
  const NearestShifts<Lanes, StraightMotion> nearest(query, motion);
  return earliest_of_all<Lanes>(query, [&](std::size_t i, const Paths& self, const Paths& other) {
    return time_between<Lanes>(self, other, nearest(self, other), Lanes::load(query.inner + i),
                               Lanes::load(query.outer + i));
  });
}

/// The kernel for all kinds of query.
template <class Lanes>
EarliestContact earliest_contact(const ContactQuery& query) {
  using Paths = PathOf<Lanes>;
  const auto reach_of = [&](std::size_t i) {
    return query.radii == nullptr ? Lanes(query.radius + query.radius)
                                  : Lanes(query.radius) + Lanes::gather(query.radii, query.others + i);
  };
  if (query.shifts == nullptr) {
    return for_nearest<Lanes>(query, [&](const auto& contact_of) {
      return earliest_of_all<Lanes>(query, [&](std::size_t i, const Paths& self, const Paths& other) {
        return contact_of(self, other, reach_of(i));
      });
    });
  }
  return for_motion<Lanes>(query, [&](const auto& motion) {
    return earliest_of_all<Lanes>(query, [&](std::size_t i, const Paths& self, const Paths& other) {
      const VectorOf<Lanes> shift{Lanes::load(query.shifts[0] + i), Lanes::load(query.shifts[1] + i),
                                  Lanes::load(query.shifts[2] + i)};
      return contact_time(motion, self, other, shift, reach_of(i));
    });
  });
}

}  // namespace hardball
