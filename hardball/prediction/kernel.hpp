// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hardball/geometry/path.hpp"

namespace hardball {

/// One sphere and its candidates, as plain arrays for a kernel.
struct KernelQuery {
  const Path* paths;            ///< By slot.
  const double* radii;          ///< By slot; null if all are `radius`.
  double radius;                ///< Of the sphere [L].
  std::uint32_t self;           ///< Its slot.
  const std::uint32_t* others;  ///< Slots of the candidates, and the sphere itself behind them.
  std::size_t count;            ///< Of the candidates.
  const double* shifts[3];   ///< Displacement of each candidate's copy along each axis [L]; null if nearest.
  double period[3];          ///< Of the box [L]; zero along axes that are not periodic.
  double inverse_period[3];  ///< Zero along axes that are not periodic.
  double now_high;           ///< At this moment copies are the nearest; any moment if they are given.
  double now_low;
  double limit;  ///< Contacts after this time do not matter.
};

/// What a kernel finds.
struct KernelResult {
  double high;  ///< Time of the earliest contact; infinite, or after the limit, if there is none before.
  double low;
  std::uint32_t index;  ///< The candidate.
  bool is_tied;         ///< Perhaps another candidate has a contact at the very same moment.
};

/// Finds the earliest contact of a sphere with its candidates. `bounds` is room for its own use, for as many
/// numbers as there are candidates and a vector more.
using Kernel = KernelResult (*)(const KernelQuery& query, double* bounds);

KernelResult portable_kernel(const KernelQuery& query, double* bounds);
#if defined(__x86_64__) && defined(__GNUC__)
KernelResult avx2_kernel(const KernelQuery& query, double* bounds);
KernelResult avx512_kernel(const KernelQuery& query, double* bounds);
#endif

}  // namespace hardball
