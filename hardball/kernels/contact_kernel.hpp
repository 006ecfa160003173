// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hardball/geometry/path.hpp"

namespace hardball {

/// One sphere and its candidates, as plain arrays.
struct ContactQuery {
  const Path* paths;            ///< By slot.
  const double* radii;          ///< By slot; null if all are `radius`.
  double radius;                ///< Of the sphere [L].
  std::uint32_t self;           ///< Its slot.
  const std::uint32_t* others;  ///< Slots of the candidates, padded with the sphere itself.
  std::size_t count;            ///< Of the candidates.
  const double* const*
      shifts;          ///< Displacement of each candidate's image along each axis [L]; null for the nearest.
  const Vec3* period;  ///< Of the box [L]; zero along axes that are not periodic.
  const Vec3* inverse_period;  ///< Zero along axes that are not periodic.
  double now_high;             ///< When images are the nearest; any time if they are given.
  double now_low;
  double limit;  ///< Contacts after this time do not matter.
};

/// The earliest contact of a sphere with its candidates.
struct EarliestContact {
  double high;  ///< Time of the earliest contact; infinite, or after the limit, if there is none before.
  double low;
  std::uint32_t index;  ///< The candidate.
  bool is_tied;         ///< Another contact may be as early: `high` does not decide.
};

/// Finds the earliest contact of a sphere with its candidates.
using ContactKernel = EarliestContact (*)(const ContactQuery& query);

}  // namespace hardball
