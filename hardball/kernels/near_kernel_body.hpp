// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

// Compiled once for each instruction set: see contact_kernel_body.hpp for what this file may contain.

#include <bit>
#include <cstddef>
#include <cstdint>

#include "hardball/errors/language.hpp"
#include "hardball/geometry/inlining.hpp"
#include "hardball/kernels/near_kernel.hpp"

namespace hardball {

/// A vector takes one block, a part of one, or two blocks, of which one may be empty.
template <class Floats>
class NearPoints {
 public:
  using Integers = typename Floats::Integers;

  HARDBALL_ALWAYS_INLINE NearPoints(const NearQuery& query, std::uint32_t* near)
      : query_(query),
        near_(near),
        unit_{Floats(query.unit[0]), Floats(query.unit[1]), Floats(query.unit[2])} {}

  /// Looks at one block of each of two cells; returns which of the blocks are full, a bit each.
  HARDBALL_ALWAYS_INLINE unsigned look(const PointBlock& one, const CellNearby& cell_of_one,
                                       const PointBlock& other, const CellNearby& cell_of_other) {
    constexpr unsigned kLanes = (1U << PointBlock::kRoom) - 1;
    unsigned gaps = 0;
    for (std::size_t lane = 0; lane < PointBlock::kRoom; lane += Floats::kWidth) {
      const Integers slots = Integers::load_halves(one.slots.data() + lane, other.slots.data() + lane);
      const Integers positions =
          Integers::load_halves(one.positions.data() + lane, other.positions.data() + lane);
      const auto apart = [&](std::size_t axis, const Integers& in_cell) {
        const auto offset = Integers::of_halves(cell_of_one.offset[axis], cell_of_other.offset[axis]);
        return to_floats(in_cell + offset) * unit_[axis];
      };
      const Integers most(PackedPosition::kMax);
      const Floats x = apart(0, positions & most);
      const Floats y = apart(1, shifted_right<PackedPosition::kBits>(positions) & most);
      const Floats z = apart(2, shifted_right<2 * PackedPosition::kBits>(positions));
      const auto is_gap = slots == Integers(PointBlock::kNoSlot);
      Floats reach(query_.reach);
      if (query_.radii != nullptr) {
        alignas(64) std::uint32_t owners[Floats::kWidth];
        select(is_gap, Integers(0U), slots).store(owners);
        reach = reach + (Floats(query_.margin) + Floats::gather(query_.radii, owners));
      }
      const unsigned is_near = bits(x * x + y * y + z * z < reach * reach && !is_gap);
      gaps |= bits(is_gap) << lane;
      // Branchless: which points are near is unpredictable.
      slots.keep(is_near, near_ + (found_ < query_.room ? found_ : query_.room));
      found_ += static_cast<std::size_t>(std::popcount(is_near));
    }
    const unsigned is_full = (gaps & kLanes) == 0 ? 1 : 0;
    return kIsPair ? is_full | (gaps >> PointBlock::kRoom == 0 ? 2U : 0U) : is_full;
  }

  /// Looks at all blocks of a cell after its first.
  void look_at_rest(const CellNearby& cell) {
    static constexpr PointBlock kEmpty;
    for (std::uint32_t next = query_.next[cell.block]; next != PointBlock::kNone; next = query_.next[next]) {
      look(query_.blocks[next], cell, kEmpty, cell);
    }
  }

  std::size_t found() const { return found_; }

  static constexpr bool kIsPair = Floats::kWidth > PointBlock::kRoom;

 private:
  const NearQuery& query_;
  std::uint32_t* near_;
  Floats unit_[3];
  std::size_t found_ = 0;
};

template <class Floats>
std::size_t pick_near(const NearQuery& query, std::uint32_t* near) {
  static constexpr PointBlock kEmpty;
  NearPoints<Floats> points(query, near);
  constexpr std::size_t kStep = NearPoints<Floats>::kIsPair ? 2 : 1;
  for (std::size_t i = 0; i < query.count; i += kStep) {
    const CellNearby& one = query.cells[i];
    const bool is_alone = kStep == 1 || i + 1 == query.count;
    const CellNearby& other = is_alone ? one : query.cells[i + 1];
    const PointBlock& block_of_other = is_alone ? kEmpty : query.blocks[other.block];
    const unsigned full = points.look(query.blocks[one.block], one, block_of_other, other);
    if (full == 0) [[likely]]
      continue;
    if ((full & 1) != 0) points.look_at_rest(one);
    if ((full & 2) != 0) points.look_at_rest(other);
  }
  return points.found();
}

template <class Floats>
Differences find_differences(const std::uint32_t* before, std::size_t lanes, std::uint32_t self,
                             const std::uint32_t* now, std::size_t new_count, std::uint32_t* gained,
                             std::uint32_t* lost) {
  using Integers = typename Floats::Integers;
  constexpr std::size_t kMaxVectors = kMaxCompared / Floats::kWidth;
  Integers old[kMaxVectors];
  unsigned gone[kMaxVectors];
  const std::size_t vectors = lanes / Floats::kWidth;
  for (std::size_t i = 0; i < vectors; ++i) {
    old[i] = Integers::load(before + i * Floats::kWidth);
    gone[i] = bits(!(old[i] == Integers(self)));
  }
  // Branchless: which are in both is unpredictable.
  std::uint32_t* end_of_gained = gained;
  for (std::size_t k = 0; k < new_count; ++k) {
    const Integers slot(now[k]);
    unsigned matches = 0;
    for (std::size_t i = 0; i < vectors; ++i) {
      const unsigned found = bits(old[i] == slot);
      matches |= found;
      gone[i] &= ~found;
    }
    *end_of_gained = now[k];
    end_of_gained += matches == 0 ? 1 : 0;
  }
  std::uint32_t* end_of_lost = lost;
  for (std::size_t i = 0; i < vectors; ++i) {
    old[i].keep(gone[i], end_of_lost);
    end_of_lost += std::popcount(gone[i]);
  }
  return {static_cast<std::size_t>(end_of_gained - gained), static_cast<std::size_t>(end_of_lost - lost)};
}

template <class Floats>
std::size_t exclude(const std::uint32_t* slots, std::size_t count, const std::uint32_t* excluded,
                    std::size_t excluded_count, std::uint32_t* kept) {
  using Integers = typename Floats::Integers;
  constexpr unsigned kAll = (1U << Floats::kWidth) - 1;
  std::uint32_t* end = kept;
  for (std::size_t i = 0; i < count; i += Floats::kWidth) {
    const Integers some = Integers::load(slots + i);
    const std::size_t left = count - i;
    unsigned stay = left < Floats::kWidth ? (1U << left) - 1 : kAll;
    for (std::size_t k = 0; k < excluded_count; ++k) stay &= ~bits(some == Integers(excluded[k]));
    some.keep(stay, end);
    end += std::popcount(stay);
  }
  return static_cast<std::size_t>(end - kept);
}

}  // namespace hardball
