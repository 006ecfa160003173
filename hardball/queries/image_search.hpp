// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>

#include "hardball/errors/error.hpp"
#include "hardball/events/event.hpp"
#include "hardball/geometry/contact_time.hpp"
#include "hardball/geometry/inlining.hpp"
#include "hardball/geometry/motion.hpp"
#include "hardball/queries/queries.hpp"
#include "hardball/queries/sphere_search.hpp"
#include "hardball/world/world.hpp"

/// The search for what a body on its way touches first, among all images of all spheres: in intervals of the
/// way so short that each sphere has few images in reach, most of which one axis rules out.
namespace hardball::image_search {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr Slot kNoSlot = std::numeric_limits<Slot>::max();

// More than sums and products of a few numbers are rounded by.
inline constexpr double kRounding = 0x1p-40;

// A search is given up after this many intervals, and a sphere after crossing this many boxes.
inline constexpr double kMaxIntervals = 1 << 30;

// A part of the way: its begin and end, in time after the moment of the query [T], or for rays in length [L].
struct Interval {
  double begin;
  double end;
};

// Another body as seen from the one that the query is about.
struct Relative {
  Vec3 separation;  // from it to the other, some image [L]
  Vec3 velocity;    // [L/T]
  double reach;     // their distance when they touch [L]
};

inline bool is_periodic(const Box& box) {
  return box.period() != Vec3{};
}

// Where the separation can be within reach along an axis during an interval, with a margin for rounding: this
// far from the middle.
struct Sweep {
  double middle;
  double half;
};

HARDBALL_ALWAYS_INLINE Sweep sweep_of(double separation, double velocity, double reach,
                                      const Interval& during) {
  const double speed = std::fabs(velocity);
  const double margin = kRounding * (std::fabs(separation) + speed * during.end + reach);
  return {separation + velocity * (0.5 * (during.begin + during.end)),
          speed * (0.5 * (during.end - during.begin)) + reach + margin};
}

// Whether no image comes within reach along an axis during an interval.
HARDBALL_ALWAYS_INLINE bool is_missed_along(std::size_t axis, const Box& box, const Relative& other,
                                            const Interval& during) {
  const Sweep sweep = sweep_of(other.separation[axis], other.velocity[axis], other.reach, during);
  const double boxes = round_to_integer(sweep.middle * box.inverse_period()[axis]);
  // False if the interval has no end, and products are NaN.
  return std::fabs(sweep.middle - boxes * box.period()[axis]) > sweep.half;
}

// Whether one axis shows that no image comes within reach during an interval. Most do not. Which axis does is
// hard to predict, so that asking all of them costs less than branches.
HARDBALL_ALWAYS_INLINE bool is_missed(const Box& box, const Relative& other, const Interval& during) {
  const bool along_x = is_missed_along(0, box, other, during);
  const bool along_y = is_missed_along(1, box, other, during);
  const bool along_z = is_missed_along(2, box, other, during);
  return along_x | along_y | along_z;
}

// Calls visit(separation) for all images that may come within reach during an interval.
template <class Visit>
void for_each_image(const Box& box, const Relative& other, const Interval& during, Visit&& visit) {
  Image low;
  Image high;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!box.is_periodic(axis)) continue;
    const Sweep sweep = sweep_of(other.separation[axis], other.velocity[axis], other.reach, during);
    low[axis] = static_cast<std::int32_t>(std::ceil((-sweep.half - sweep.middle) / box.size()[axis]));
    high[axis] = static_cast<std::int32_t>(std::floor((sweep.half - sweep.middle) / box.size()[axis]));
  }
  Image image;
  for (image[0] = low[0]; image[0] <= high[0]; ++image[0]) {
    for (image[1] = low[1]; image[1] <= high[1]; ++image[1]) {
      for (image[2] = low[2]; image[2] <= high[2]; ++image[2]) visit(other.separation + box.shift(image));
    }
  }
}

// What is met first: of simultaneous contacts, by the order of events.
struct First {
  Time time = kNever;
  EventKind kind = EventKind::collision;
  std::uint32_t body = kNoSphere;
  Vec3 separation;  // when it all begins, of the image that is met [L]

  void record(const First& other) {
    if (std::tie(other.time, other.kind, other.body) < std::tie(time, kind, body)) *this = other;
  }
};

// Divides the way to `end`, which may come nearer meanwhile, into intervals, in each of which nothing moves
// farther than half a periodic box, and calls search(interval) for one after the other.
template <class Stride, class Search>
void search_in_intervals(Stride&& stride, const double& end, Search&& search) {
  double begin = 0;
  for (double intervals = 0; intervals < kMaxIntervals; ++intervals) {
    const Interval during{begin, std::min(begin + stride(begin), end)};
    search(during);
    if (!(during.end < end)) return;
    begin = during.end;
  }
  throw RunFailure("a search has crossed half the periodic box 2^30 times; search less far");
}

// Calls record(wait, separation) for each image of another sphere that is touched at an end of an interval or
// before, where wait_of(other) is the time until an image is touched, if it is not later than `latest`.
template <class WaitOf, class Record>
HARDBALL_ALWAYS_INLINE void for_each_touch(const Box& box, const Relative& other, const Interval& during,
                                           const double& latest, const WaitOf& wait_of, Record&& record) {
  if (is_missed(box, other, during)) return;
  for_each_image(box, other, during, [&](const Vec3& separation) {
    const double wait = wait_of(Relative{separation, other.velocity, other.reach});
    if (wait <= latest) record(wait, separation);
  });
}

inline double time_to_touch(const Relative& other) {
  return time_to_reach(other.separation, other.velocity, other.reach);
}

inline void check_end(const Box& box, double end, const std::string& name, const char* where) {
  if (!(end >= 0)) throw Error("the " + name + " lies behind, or is NaN", where, "give one that lies ahead");
  if (std::isfinite(end) || !is_periodic(box)) return;
  throw Error("the box is periodic, and the search may have no end", where, "give a finite " + name);
}

}  // namespace hardball::image_search
