// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hardball/geometry/growth.hpp"
#include "hardball/geometry/path.hpp"
#include "hardball/geometry/sliding_images.hpp"

namespace hardball {

/// One sphere and its candidates, as plain arrays.
struct ContactQuery {
  const Path* paths;            ///< By slot.
  const double* radii;          ///< Base radii by slot; null if all are `radius`.
  double radius;                ///< The base radius of the sphere [L].
  std::uint32_t self;           ///< Slot of the sphere.
  const std::uint32_t* others;  ///< Slots of the candidates, padded with the sphere itself.
  std::size_t count;            ///< Number of the candidates.
  const double* const* shifts;  ///< Displacement of each candidate's image along each axis [L]; null for the
                                ///< nearest, which is the only choice in a sheared box.
  const Vec3* period;           ///< Periods of the box [L]; zero along axes that are not periodic.
  const Vec3* inverse_period;   ///< Zero along axes that are not periodic.
  double now_high;              ///< When images are the nearest; any time if they are given.
  double now_low;
  const Vec3* gravity;          ///< Acceleration of all spheres [L/T^2]; null if paths are straight.
  const Growth* growth;         ///< Growth of all spheres; null if radii are base radii.
  const SlidingImages* images;  ///< Images of a sheared box; null if images rest.
};

/// The earliest contact of a sphere with its candidates.
struct EarliestContact {
  double high;  ///< Time of the earliest contact; infinite if there is none.
  double low;
  std::uint32_t index;  ///< The candidate.
  bool is_tied;         ///< Another contact may be as early: `high` does not decide.
};

/// Pairs of spheres, whose nearest images are meant, as plain arrays.
struct PairQuery {
  const Path* paths;            ///< By slot.
  const double* radii;          ///< Base radii by slot; null if all are `radius`.
  double radius;                ///< [L]
  const std::uint32_t* first;   ///< A slot of each pair, padded to a whole vector with any slots.
  const std::uint32_t* second;  ///< The other slot of each pair, padded to a whole vector with any slots.
  std::size_t count;            ///< Number of the pairs.
  const Vec3* period;           ///< Periods of the box [L]; zero along axes that are not periodic.
  const Vec3* inverse_period;   ///< Zero along axes that are not periodic.
  double now_high;              ///< When images are the nearest.
  double now_low;
  const Vec3* gravity;          ///< Acceleration of all spheres [L/T^2]; null if paths are straight.
  const Growth* growth;         ///< Growth of all spheres; null if radii are base radii.
  const SlidingImages* images;  ///< Images of a sheared box; null if images rest.
};

/// One sphere and those that are inside of a step of a potential with it, as plain arrays.
struct StepQuery {
  const Path* paths;            ///< By slot.
  std::uint32_t self;           ///< The slot of the sphere.
  const std::uint32_t* others;  ///< Slots of the others, padded with the sphere itself.
  const double* inner;          ///< The next step or the core inwards, zero if there is none [L]; padded.
  const double* outer;          ///< The next step outwards [L]; padded.
  std::size_t count;            ///< Number of the others.
  const Vec3* period;           ///< Periods of the box [L]; zero along axes that are not periodic.
  const Vec3* inverse_period;   ///< Zero along axes that are not periodic.
  double now_high;              ///< When images are the nearest.
  double now_low;
};

/// Computes the contact time of each pair, as contact_time (geometry/contact_time.hpp) does, in two
/// parts, the first infinite if there is no contact; arrays are padded like those of the query.
using PairKernel = void (*)(const PairQuery& query, double* high, double* low);

/// Finds the earliest event of a sphere at steps, as time_between (geometry/exit_time.hpp) does.
using StepKernel = EarliestContact (*)(const StepQuery& query);

/// Finds the earliest contact of a sphere with its candidates.
using ContactKernel = EarliestContact (*)(const ContactQuery& query);

}  // namespace hardball
