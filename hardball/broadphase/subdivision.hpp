// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "hardball/events/event.hpp"
#include "hardball/geometry/extent.hpp"
#include "hardball/geometry/path.hpp"
#include "hardball/world/box.hpp"

namespace hardball {

/// The indices of a cell along the axes. Cells are counted along the path of a sphere, unwrapped: in a
/// periodic box the index modulo the cells of the box gives the cell, and the quotient the number of boxes
/// crossed.
using CellIndex = std::array<std::int32_t, kAxes>;

/// Whether two cells are the same. Comparing arrays calls a function of the C library.
inline bool is_same(const CellIndex& a, const CellIndex& b) {
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/// The cells from `low` to `high`, both included, along each axis.
struct CellRange {
  CellIndex low{};
  CellIndex high{};

  friend bool operator==(const CellRange& a, const CellRange& b) {
    return is_same(a.low, b.low) && is_same(a.high, b.high);
  }
  bool contains(const CellIndex& cell) const {
    return low[0] <= cell[0] && cell[0] <= high[0] && low[1] <= cell[1] && cell[1] <= high[1] &&
           low[2] <= cell[2] && cell[2] <= high[2];
  }

  /// Calls visit(cell) for every cell.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::int32_t x = low[0]; x <= high[0]; ++x) {
      for (std::int32_t y = low[1]; y <= high[1]; ++y) {
        for (std::int32_t z = low[2]; z <= high[2]; ++z) visit(CellIndex{x, y, z});
      }
    }
  }
};

/// Consecutive cells along an axis, from the first on. In a periodic box they may begin before the first one
/// of the box, or pass the last one; their middle is inside.
struct CellSpan {
  std::int32_t first = 0;
  std::int32_t count = 0;
};
using CellSpans = std::array<CellSpan, kAxes>;

/// When a sphere's surface crosses a face of a cell, and which.
struct CellCrossing {
  double wait =
      std::numeric_limits<double>::infinity();  ///< From the start of the path [T]; infinite if never.
  std::uint8_t axis = 0;
  bool up = false;  ///< Toward the cells with higher indices.
};

/// Space divided into uniform cells: which cells a sphere touches, and when it touches others.
///
/// Cells admit a sphere slightly before it touches them and release it slightly after, by far more than
/// rounding can displace a sphere, so that two spheres share a cell before they can touch. Source: Kim,
/// Guibas and Shin (1997), equation 1.
class Subdivision {
 public:
  /// The most cells along an axis, unless fewer are wanted.
  static constexpr std::int32_t kMaxCells = 1 << 28;

  Subdivision() = default;
  /// `edge` [L] is the wanted edge; along bounded axes it is adjusted so that a whole number of cells fills
  /// the box. There are at most `most_cells` along an axis: spheres beyond the outermost cells belong to
  /// these. Error: not positive and finite.
  Subdivision(const Box& box, double edge, std::int32_t most_cells = kMaxCells);

  /// Edge of a cell along an axis [L].
  double edge(std::size_t axis) const { return axes_[axis].edge; }
  Vec3 edges() const { return {edge(0), edge(1), edge(2)}; }
  /// The lowest and highest index along an axis; along periodic axes no sphere reaches them.
  std::int32_t first(std::size_t axis) const { return axes_[axis].first; }
  std::int32_t last(std::size_t axis) const { return axes_[axis].last; }
  /// The number of cells of the box along a periodic axis; zero along the others.
  std::int32_t period(std::size_t axis) const { return axes_[axis].period; }

  /// The number of cells of the box along each axis, zero where it is open.
  CellIndex shape() const { return {axes_[0].count, axes_[1].count, axes_[2].count}; }
  /// The cells of the box that an extent meets, at least one; zero along an axis where the box is open.
  CellSpans spans_of(const Extent& extent) const;

  /// The cells that a sphere at `position` touches. Error (RunFailure): it has crossed the box too many
  /// times.
  CellRange range_at(const Vec3& position, double radius) const;
  /// The first and the last cell along an axis that a sphere touches. Error (RunFailure): it has crossed the
  /// box too many times.
  std::pair<std::int32_t, std::int32_t> range_along(std::size_t axis, double coordinate, double radius) const;
  /// The distance from its center within which a sphere touches cells, along an axis [L].
  double reach(std::size_t axis, double radius) const { return radius + axes_[axis].margin; }
  /// The most cells that a sphere of this radius touches along an axis.
  double most_touched(std::size_t axis, double radius) const {
    return std::floor(2 * reach(axis, radius) / edge(axis) * (1 + 1e-6)) + 2;
  }
  /// Whether spheres of up to this radius that share a cell are always nearest images of each other along an
  /// axis: a center lies in one of the cells that the sphere touches, so that two are less than 2 *
  /// most_touched - 1 cells apart, nearer than half the box.
  bool has_nearest_images(std::size_t axis, double radius) const {
    return period(axis) == 0 || period(axis) >= 2 * (2 * most_touched(axis, radius) - 1) + 1;
  }
  /// How far a coordinate lies above the lower face of cell `index` along an axis [L].
  double beyond_face(std::size_t axis, std::int32_t index, double coordinate) const {
    return coordinate - axes_[axis].edge * index;
  }
  /// The cell, folded into the box, in which a point inside the box lies.
  CellIndex cell_of(const Vec3& point) const;
  /// The index of a point's cell along an axis; along a periodic one the point may be some boxes away. Error
  /// (RunFailure): as for range_at.
  std::int32_t cell_along(std::size_t axis, double coordinate) const {
    return folded(axis, index_of(axes_[axis], coordinate));
  }
  /// When a sphere touches the next cell beyond `range`, from where it is; its path may be straight, without
  /// gravity, or a parabola.
  CellCrossing next_enter(const Vec3& position, const Vec3& velocity, const Vec3& gravity, double radius,
                          const CellRange& range) const;
  /// When a sphere on a straight path last touches the rearmost cells of `range`.
  CellCrossing next_leave(const Path& path, double radius, const CellRange& range) const;

  /// An index along an axis, folded into the box. Error: as for range_at.
  std::int32_t folded(std::size_t axis, std::int32_t index) const {
    const std::int32_t period = axes_[axis].period;
    // For most indices one comparison shows that they lie inside.
    const bool is_inside = static_cast<std::uint32_t>(index) < static_cast<std::uint32_t>(period);
    if (is_inside || period == 0) [[likely]]
      return index;
    return folded_from_beyond(axes_[axis], index);
  }
  CellIndex folded(const CellIndex& cell) const {
    return {folded(0, cell[0]), folded(1, cell[1]), folded(2, cell[2])};
  }
  /// Folds a cell into the box; returns how many boxes beyond it was.
  Image fold(CellIndex& cell) const {
    Image boxes;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const std::int32_t index = folded(axis, cell[axis]);
      if (index == cell[axis]) continue;
      boxes[axis] = (cell[axis] - index) / axes_[axis].period;
      cell[axis] = index;
    }
    return boxes;
  }
  /// Calls visit(cell, folded) for every cell of a range, and the same cell folded into the box.
  template <class Visit>
  void for_each_folded(const CellRange& range, Visit&& visit) const {
    const CellIndex begin = folded(range.low);
    const auto step = [this](std::size_t axis, std::int32_t& index) {
      if (++index == axes_[axis].period) index = 0;
    };
    CellIndex cell;
    CellIndex folded = begin;
    for (cell[0] = range.low[0]; cell[0] <= range.high[0]; ++cell[0], step(0, folded[0])) {
      folded[1] = begin[1];
      for (cell[1] = range.low[1]; cell[1] <= range.high[1]; ++cell[1], step(1, folded[1])) {
        folded[2] = begin[2];
        for (cell[2] = range.low[2]; cell[2] <= range.high[2]; ++cell[2], step(2, folded[2])) {
          visit(std::as_const(cell), std::as_const(folded));
        }
      }
    }
  }
  /// A range without the cells that do not exist, at least one along each axis, and with each cell of a
  /// periodic box once.
  CellRange clipped(const CellRange& range) const;
  /// By how many cells `image` is displaced along an axis.
  std::int32_t cells_beyond(std::size_t axis, const Image& image) const {
    return image[axis] * axes_[axis].period;
  }

 private:
  struct Axis {
    double edge = 0;
    double inverse_edge = 0;
    double margin = 0;  // by how much cells admit early and release late
    std::int32_t first = 0;
    std::int32_t last = 0;
    std::int32_t period = 0;
    std::int32_t count = 0;  // of the cells of the box; zero if it is open
  };

  static CellSpan span_of(const Axis& cells, double low, double high);
  static std::int32_t index_of(const Axis& cells, double coordinate);
  static std::int32_t folded_from_beyond(const Axis& cells, std::int32_t index);

  std::array<Axis, kAxes> axes_;
};

}  // namespace hardball
