// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/cell_table.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "hardball/errors/error.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

// With more cells per sphere than this, a list for each would take more memory than the spheres.
constexpr double kMaxPerSphere = 2;
constexpr std::size_t kAlways = 4096;
// Cells elsewhere share lists only if that leaves no more than this fraction of them.
constexpr double kMostOfAll = 0.8;

CellSpans all_of(const Subdivision& cells) {
  const CellIndex shape = cells.shape();
  return {CellSpan{0, shape[0]}, {0, shape[1]}, {0, shape[2]}};
}

// How many lists there are, if along each axis all cells elsewhere count as one.
double lists_of(const CellSpans& spans, const CellIndex& shape) {
  double lists = 1;
  for (std::size_t axis = 0; axis < kAxes; ++axis)
    lists *= spans[axis].count + (spans[axis].count < shape[axis] ? 1 : 0);
  return lists;
}

}  // namespace

CellTable::CellTable(const Subdivision& cells, std::size_t spheres)
    : CellTable(cells, spheres, all_of(cells)) {}

CellTable::CellTable(const Subdivision& cells, std::size_t spheres, const CellSpans& expected)
    : cells_(cells) {
  const CellSpans everywhere = all_of(cells);
  const double all = lists_of(everywhere, cells.shape());
  const double needed = lists_of(expected, cells.shape());
  const double most = kMaxPerSphere * static_cast<double>(spheres) + kAlways;
  if (all > 0 && needed <= most && needed <= kMostOfAll * all) {
    give_lists(expected);
  } else if (all > 0 && all <= most) {
    give_lists(everywhere);
  } else {
    spread(spheres);
  }
}

void CellTable::give_lists(const CellSpans& spans) {
  size_ = 1;
  for (std::size_t axis = kAxes; axis-- > 0;) {
    const auto [first, count] = spans[axis];
    const auto last = static_cast<std::uint32_t>(count) - 1;
    const bool is_part = count < cells_.shape()[axis];
    const std::int32_t around = first < 0 ? -cells_.period(axis) : cells_.period(axis);
    axes_[axis] = {first, last, is_part ? kEndless : last, static_cast<std::uint32_t>(size_),
                   is_part ? static_cast<std::uint32_t>(around) : 0};
    has_elsewhere_ |= is_part;
    size_ *= static_cast<std::size_t>(count) + (is_part ? 1 : 0);
  }
}

// Multiples of powers of a generalized golden ratio, one for each number of dimensions, are spread evenly
// modulo one: spheres in a plane, in a row or in a lump occupy about as many lists as cells. Source: M.
// Roberts, The unreasonable effectiveness of quasirandom sequences (2018).
void CellTable::spread(std::size_t spheres) {
  constexpr std::array<double, kAxes + 1> kRatios{1, 1.618033988749895, 1.324717957244746,
                                                  1.2207440846057596};
  const CellIndex shape = cells_.shape();
  const auto is_divided = [](std::int32_t count) { return count != 1; };
  const auto dimensions = static_cast<std::size_t>(ranges::count_if(shape, is_divided));
  size_ = std::bit_floor(spheres + kAlways);
  HARDBALL_CHECK(size_ <= std::size_t{1} << 31);
  shift_ = static_cast<std::uint32_t>(std::countl_zero(static_cast<std::uint32_t>(size_ - 1)));
  double share = 1;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const bool is_open = shape[axis] == 0;
    const std::int32_t first = is_open ? cells_.first(axis) : 0;
    const std::int32_t last = is_open ? cells_.last(axis) : shape[axis] - 1;
    axes_[axis].first = first;
    axes_[axis].last = static_cast<std::uint32_t>(last) - static_cast<std::uint32_t>(first);
    if (!is_open) axes_[axis].last_of_box = axes_[axis].last;
    if (!is_divided(shape[axis])) continue;
    share /= kRatios[dimensions];
    axes_[axis].stride = static_cast<std::uint32_t>(share * 0x1p32);
  }
}

std::uint32_t CellTable::place_in_box(std::size_t axis, std::int32_t index) const {
  const Axis& along = axes_[axis];
  const std::uint32_t place = along.place_of(cells_.folded(axis, index));
  return place <= along.last ? place : place + along.around;
}

std::uint32_t CellTable::part_beyond(std::size_t axis, std::int32_t index) const {
  return std::min(place_in_box(axis, index), axes_[axis].last + 1) * axes_[axis].stride;
}

}  // namespace hardball
