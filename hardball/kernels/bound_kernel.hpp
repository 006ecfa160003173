// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "hardball/kernels/compact_path.hpp"
#include "hardball/standard/bit_cast.hpp"

namespace hardball {

/// What the numbers of compact paths mean, and what bounds allow for their errors, in units of these paths.
/// Source: docs/bounds.md, where the names are those of the proof.
struct BoundScale {
  bool are_radii_alike = true;                     ///< Whether all radii are equal.
  float common_reach = 0;                          ///< If so, the sum of two radii, with the allowance [L].
  std::array<float, CompactPath::kRadii> radii{};  ///< Rounded up, if there are no more different ones [L].
  std::array<float, 3> grid{};                     ///< The step of the grid along each axis [L].
  float tick = 0;                                  ///< [T]
  bool has_gravity = false;                        ///< Whether paths are parabolas.
  bool has_growth = false;                         ///< Whether sizes change.
  float growth = 0;       ///< kappa_s: of radii, relative to the largest of the epoch; not negative [1/T].
  float speed_error = 0;  ///< g: of a relative velocity [L/T].
  std::array<float, 3> gravity{};  ///< [L/T^2]
  bool has_shear = false;          ///< Whether images above and below slide along x.
  float slide_speed = 0;           ///< The velocity along x of the image above [L/T].
  float reach_allowance = 0;       ///< Added to the sum of two radii: error of a separation [L].
  float square_allowance = 0;      ///< Subtracted from a squared distance [L^2].
  float approach_allowance = 0;    ///< k_b: subtracted from separation times velocity [L^2/T].
  float speed_allowance = 0;       ///< G: subtracted from a squared relative velocity [L^2/T^2].
  float excess_allowance = 0;      ///< kappa, of the discriminant [L^2].
  float least_discriminant = 0;    ///< D_0 [L^4/T^2].
};

/// The least two of the lower bounds of the waits until a sphere touches its candidates, of different ones,
/// each in one integer with the index of its candidate: numbers that are not negative are ordered as their
/// bits are, and the last bits, which say least, are the index.
struct BoundKeys {
  /// The most candidates.
  static constexpr std::size_t kMax = 64;
  static constexpr std::uint32_t kIndex = kMax - 1;
  /// The key of a candidate that will not touch; any greater number means that, too.
  static constexpr std::uint32_t kForever = bit_cast<std::uint32_t>(std::numeric_limits<float>::infinity());

  static bool touches(std::uint32_t key) { return key < kForever; }
  /// [T], in units; infinite if the candidate will not touch.
  static float wait(std::uint32_t key) { return bit_cast<float>(key & ~kIndex); }
  static std::size_t index(std::uint32_t key) { return key & kIndex; }
  /// A key above those of all waits up to this one.
  static std::uint32_t above(float wait) {
    const std::uint32_t above = (bit_cast<std::uint32_t>(wait) | kIndex) + 1;
    return above < kForever ? above : kForever;
  }

  std::uint32_t first;
  std::uint32_t second;
};

/// A sphere, and slots of those that it may touch, padded to a whole vector with its own.
struct BoundQuery {
  std::uint32_t self;
  const std::uint32_t* others;
  std::size_t count;       ///< At most BoundKeys::kMax.
  float size = 1;          ///< Size of the radii, relative to the largest of the epoch, rounded up [1].
  std::int32_t slide = 0;  ///< Displacement of the image above along x, modulo 2^32 steps of the grid.
};

/// Bounds the waits of a sphere, from the moment at which its path was copied, until it touches others. Paths
/// are by slot, and so are radii [L], the largest of the epoch, rounded up; null if `scale` has them. A bound
/// may differ in its last bits between instruction sets: contact times are never computed from it.
using BoundKernel = BoundKeys (*)(const BoundScale& scale, const CompactPath* paths, const float* radii,
                                  const BoundQuery& query);

/// Bounds the waits as a BoundKernel does, and writes the keys of all candidates, to whole vectors; that of
/// the sphere itself says that it is not touched.
using EachBoundKernel = BoundKeys (*)(const BoundScale& scale, const CompactPath* paths, const float* radii,
                                      const BoundQuery& query,
                                      std::array<std::uint32_t, BoundKeys::kMax>& keys);

/// Writes to `kept` those of the `count` slots at `slots` whose keys are at least `first` and less than
/// `end`, and returns how many there are. Precondition: arrays are padded to whole vectors, the keys with no
/// less than `end`, and `kept` has room for one more; `end` is at most BoundKeys::kForever.
using KeepBetweenKernel = std::size_t (*)(const std::uint32_t* slots, const std::uint32_t* keys,
                                          std::size_t count, std::uint32_t first, std::uint32_t end,
                                          std::uint32_t* kept);

/// A sphere, and those that are inside of a step of a potential with it, padded to a whole vector with
/// itself, on straight paths.
struct StepBoundQuery {
  std::uint32_t self;
  const std::uint32_t* others;
  const float* inner;  ///< The next step or the core inwards, rounded up; zero if there is none [L].
  const float* outer;  ///< The next step outwards, rounded down [L].
  std::size_t count;   ///< At most BoundKeys::kMax.
};

/// Bounds the waits until a sphere and those come to a step.
using StepBoundKernel = BoundKeys (*)(const BoundScale& scale, const CompactPath* paths,
                                      const StepBoundQuery& query);

/// A BoundKernel for two spheres: the processor works on both at a time.
using BoundPairKernel = std::array<BoundKeys, 2> (*)(const BoundScale& scale, const CompactPath* paths,
                                                     const float* radii, const BoundQuery& one,
                                                     const BoundQuery& other);

}  // namespace hardball
