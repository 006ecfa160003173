// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "hardball/broadphase/subdivision.hpp"
#include "hardball/geometry/inlining.hpp"

namespace hardball {

/// Computes which list holds the spheres of a cell: the paper's subspace tree, with a formula in place of the
/// tree.
///
/// - If there are few cells per sphere, each has a list.
/// - If spheres are expected in a part of the box, only the cells there have lists of their own. Along each
///   axis, all indices elsewhere count as one.
/// - If there are too many cells even so, or space is unbounded, any cells may share a list.
///
/// A search of a cell that shares its list also finds the spheres of the other cells. Memory is O(spheres).
/// The number of a list is a sum over the axes, modulo 2^32, or the first bits of it. Cost: O(1).
class CellTable {
 public:
  CellTable() = default;
  /// The cells of `cells`; `expected` is where spheres are expected.
  CellTable(const Subdivision& cells, std::size_t spheres, const CellSpans& expected);
  /// A table for spheres that may be anywhere.
  CellTable(const Subdivision& cells, std::size_t spheres);

  /// The number of lists.
  std::size_t size() const { return size_; }
  /// Whether some cells share a list.
  bool is_shared() const { return has_elsewhere_ || is_spread(); }
  /// Whether any cells may share one. Otherwise the number of a list is the sum itself.
  bool is_spread() const { return shift_ > 0; }
  /// Whether a cell, or one at most `rows` rows away along each axis, may share a list.
  bool is_shared_within(std::uint32_t rows, const CellIndex& cell) const {
    if (!has_elsewhere_) return is_shared();
    bool is_near = false;
    for (std::size_t axis = 0; axis < kAxes; ++axis) is_near |= is_elsewhere_within(rows, axis, cell[axis]);
    return is_near;
  }

  /// The list of a cell, which need not be folded into the box.
  HARDBALL_ALWAYS_INLINE std::uint32_t list(const CellIndex& cell) const {
    return list_at(part(0, cell[0]) + part(1, cell[1]) + part(2, cell[2]));
  }
  /// What an index along an axis contributes to the sum; it need not be folded into the box.
  HARDBALL_ALWAYS_INLINE std::uint32_t part(std::size_t axis, std::int32_t index) const {
    const Axis& along = axes_[axis];
    std::uint32_t place = along.place_of(index);
    if (place > along.last) [[unlikely]] {
      place += along.around;
      if (place > along.last) return part_beyond(axis, index);
    }
    return place * along.stride;
  }
  /// The parts of an index and of the next one.
  using Pair = std::array<std::uint32_t, 2>;
  HARDBALL_ALWAYS_INLINE Pair parts_from(std::size_t axis, std::int32_t index) const {
    const Axis& along = axes_[axis];
    std::uint32_t place = along.place_of(index);
    if (place > along.last) [[unlikely]] {
      place += along.around;
      if (place > along.last) return {part_beyond(axis, index), part(axis, index + 1)};
    }
    const std::uint32_t lower = place * along.stride;
    return {lower, place == along.last_of_box ? 0 : lower + along.stride};
  }
  /// Whether the parts of these indices, the first and the last included, grow by a stride from one to the
  /// next, and none of them is beyond the cells.
  bool is_run(std::size_t axis, std::int32_t first, std::int32_t last) const {
    const Axis& along = axes_[axis];
    return along.place_of(first) <= along.place_of(last) && along.place_of(last) <= along.last;
  }
  std::uint32_t stride(std::size_t axis) const { return axes_[axis].stride; }
  /// The list, given the sum.
  std::uint32_t list_at(std::uint32_t sum) const { return sum >> shift_; }

 private:
  static constexpr std::uint32_t kEndless = std::numeric_limits<std::uint32_t>::max();

  // The places of indices: 0 to `last` from the index `first` on. All others are elsewhere, at the next one.
  struct Axis {
    std::uint32_t place_of(std::int32_t index) const {
      return static_cast<std::uint32_t>(index) - static_cast<std::uint32_t>(first);
    }

    std::int32_t first = 0;
    std::uint32_t last = kEndless;
    std::uint32_t last_of_box = kEndless;  // the place that the first one follows; endless if it follows none
    std::uint32_t stride = 0;
    std::uint32_t around = 0;  // to the places of indices at the other end of the box
  };

  bool is_elsewhere_within(std::uint32_t rows, std::size_t axis, std::int32_t index) const {
    const Axis& along = axes_[axis];
    std::uint32_t place = along.place_of(index);
    if (place > along.last) [[unlikely]]
      place = place_in_box(axis, index);
    const bool is_part = along.last_of_box == kEndless;  // of the cells of a box
    return is_part && (along.last < 2 * rows || place - rows > along.last - 2 * rows);
  }
  HARDBALL_NEVER_INLINE std::uint32_t part_beyond(std::size_t axis, std::int32_t index) const;
  std::uint32_t place_in_box(std::size_t axis, std::int32_t index) const;
  void give_lists(const CellSpans& spans);
  void spread(std::size_t spheres);

  Subdivision cells_;
  std::size_t size_ = 0;
  bool has_elsewhere_ = false;  // whether only the cells elsewhere share lists
  std::uint32_t shift_ = 0;
  std::array<Axis, kAxes> axes_;
};

}  // namespace hardball
