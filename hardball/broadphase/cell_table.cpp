// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/cell_table.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// With more cells per sphere than this, a list for each would take more memory than the spheres.
constexpr double kMaxPerSphere = 2;
constexpr std::size_t kAlways = 4096;

}  // namespace

CellTable::CellTable(const CellIndex& shape, std::size_t spheres) {
  const double cells = static_cast<double>(shape[0]) * shape[1] * shape[2];
  if (cells > 0 && cells <= kMaxPerSphere * static_cast<double>(spheres) + kAlways) {
    size_ = static_cast<std::size_t>(cells);
    strides_ = {static_cast<std::uint32_t>(shape[1] * shape[2]), static_cast<std::uint32_t>(shape[2]), 1};
    return;
  }
  // Multiples of powers of a generalized golden ratio, one for each number of dimensions, are spread evenly
  // modulo one: spheres in a plane, in a row or in a lump occupy about as many lists as cells. Source: M.
  // Roberts, The unreasonable effectiveness of quasirandom sequences (2018).
  constexpr std::array<double, kAxes + 1> kRatios{1, 1.618033988749895, 1.324717957244746,
                                                  1.2207440846057596};
  const auto is_divided = [](std::int32_t count) { return count != 1; };
  const auto dimensions = static_cast<std::size_t>(std::ranges::count_if(shape, is_divided));
  size_ = std::bit_floor(spheres + kAlways);
  HARDBALL_CHECK(size_ <= std::size_t{1} << 31);
  shift_ = static_cast<std::uint32_t>(std::countl_zero(static_cast<std::uint32_t>(size_ - 1)));
  double share = 1;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!is_divided(shape[axis])) continue;
    share /= kRatios[dimensions];
    strides_[axis] = static_cast<std::uint32_t>(share * 0x1p32);
  }
}

}  // namespace hardball
