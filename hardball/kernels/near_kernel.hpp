// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hardball {

/// Where a point lies in its cell: three numbers of ten bits, in units of about a thousandth of the edge.
class PackedPosition {
 public:
  static constexpr std::uint32_t kBits = 10;
  static constexpr std::uint32_t kMax = (1U << kBits) - 1;

  PackedPosition() = default;
  /// Precondition: all are from 0 to kMax.
  explicit PackedPosition(const std::array<std::int32_t, 3>& units)
      : bits_(static_cast<std::uint32_t>(units[0] | units[1] << kBits | units[2] << 2 * kBits)) {}

  std::uint32_t bits() const { return bits_; }

 private:
  std::uint32_t bits_ = 0;
};

/// Points in one cell and the slots of their owners, as kernels load them: a cache line.
struct alignas(64) PointBlock {
  static constexpr std::size_t kRoom = 8;
  /// The slot of a gap.
  static constexpr std::uint32_t kNoSlot = UINT32_MAX;
  /// The number of no block.
  static constexpr std::uint32_t kNone = UINT32_MAX;

  constexpr PointBlock() { slots.fill(kNoSlot); }

  std::array<std::uint32_t, kRoom> positions{};  ///< The bits of a PackedPosition each.
  std::array<std::uint32_t, kRoom> slots;
};

/// A cell whose points may be near a position.
struct CellNearby {
  std::uint32_t block;                 ///< The number of its first block.
  std::array<std::int32_t, 3> offset;  ///< From the position to the cell's corner, in units.
};

/// A position, and cells around it.
struct NearQuery {
  const PointBlock* blocks;
  const std::uint32_t*
      next;  ///< By block, the next of the same cell, which exists only if the first is full.
  const CellNearby* cells;
  std::size_t count;          ///< Number of cells.
  std::array<float, 3> unit;  ///< Unit of packed positions, along each axis [L].
  float reach;                ///< The distance within which points are near [L].
  const float* radii;         ///< By slot: added to `reach` for each point [L]; null for none.
  float margin;               ///< Added to each of these radii [L].
  std::size_t room;           ///< In the result, kWidestVector not counted.
};

/// Writes to `near` the slots of the points nearer to the position than `reach`, as many as there is room
/// for, and returns how many there are. Distances are those of single precision, but the same in both
/// directions.
using NearKernel = std::size_t (*)(const NearQuery& query, std::uint32_t* near);

/// How two sets of slots differ.
struct Differences {
  std::size_t gained;  ///< How many are in the new one alone.
  std::size_t lost;    ///< How many are in the old one alone.
};

/// Writes to `gained` and `lost` how the `new_count` slots at `now` differ from `before`: `lanes` of them, a
/// multiple of kWidestVector and at most kMaxCompared, in which `self` stands for none. Precondition: there
/// is room for all, and kWidestVector more. Cost: O(new_count * lanes / width).
using DifferenceKernel = Differences (*)(const std::uint32_t* before, std::size_t lanes, std::uint32_t self,
                                         const std::uint32_t* now, std::size_t new_count,
                                         std::uint32_t* gained, std::uint32_t* lost);
inline constexpr std::size_t kMaxCompared = 64;

/// Writes to `kept` those of the `count` slots at `slots` that are not among the `excluded_count` ones at
/// `excluded`, in their order, and returns how many there are. `kept` may be `slots`. Precondition: there is
/// room for kWidestVector more in both. Cost: O(count * excluded_count / width).
using ExcludeKernel = std::size_t (*)(const std::uint32_t* slots, std::size_t count,
                                      const std::uint32_t* excluded, std::size_t excluded_count,
                                      std::uint32_t* kept);

}  // namespace hardball
