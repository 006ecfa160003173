// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hardball/kernels/compact_path.hpp"

namespace hardball {

/// The lengths and speeds from which bounds follow, in the units of the compact paths, and what the bounds
/// allow for errors. Source: docs/bounds.md, where the names are those of the proof.
struct BoundScale {
  std::array<float, 3> grid{};  ///< The step of the grid along each axis [L].
  float tick = 0;               ///< [T]
  float reach_allowance = 0;    ///< Added to the sum of two radii: error of a separation [L].
  float square_allowance = 0;   ///< Subtracted from a squared distance [L^2].
  float approach_allowance = 0;  ///< k_b: subtracted from separation times velocity [L^2/T].
  float speed_allowance = 0;     ///< G: subtracted from a squared relative velocity [L^2/T^2].
  float excess_allowance = 0;    ///< kappa, of the discriminant [L^2].
  float least_discriminant = 0;  ///< D_0 [L^4/T^2].
};

/// One sphere at one moment, and its candidates.
struct BoundQuery {
  const BoundScale* scale;
  const CompactPath* paths;     ///< By slot.
  const float* radii;           ///< By slot [L], rounded up; null if all are `radius`.
  float radius;                 ///< Of the sphere [L], rounded up.
  std::uint32_t self;           ///< Its slot.
  const CompactPath* own;       ///< Its path, with the place and the tick of the moment.
  const std::uint32_t* others;  ///< Slots of the candidates, padded with the sphere itself.
  std::size_t count;            ///< Of the candidates.
};

/// Lower bounds of the waits until a sphere touches its candidates.
struct ContactBounds {
  float least;            ///< Before it, there is no contact [T]; infinite if there is none at all.
  float second;           ///< Before it, there is none with any candidate but `partner` [T].
  std::uint32_t partner;  ///< The slot of the candidate with the least bound.
};

/// Bounds the waits of a sphere until it touches its candidates. A bound may differ in its last bits between
/// instruction sets: contact times are never computed from it.
using BoundKernel = ContactBounds (*)(const BoundQuery& query);

}  // namespace hardball
