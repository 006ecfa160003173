// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

// Compiled once for each instruction set: see contact_kernel_body.hpp for what this file may contain.

#include <bit>
#include <cstddef>
#include <cstdint>

#include "hardball/kernels/near_kernel.hpp"

namespace hardball {

/// The kernel for all kinds of query.
template <class Floats>
std::size_t pick_near(const NearQuery& query, std::uint32_t* near) {
  using Integers = typename Floats::Integers;
  std::uint32_t* end = near;
  for (std::size_t i = 0; i < query.count; i += Floats::kWidth) {
    const std::uint32_t* const slots = query.slots + i;
    Integers places[3];
    Floats::load(query.points, slots, places);
    const auto apart = [&](std::size_t axis) {
      return to_floats(places[axis] - Integers(query.place[axis])) * Floats(query.grid[axis]);
    };
    const Floats x = apart(0);
    const Floats y = apart(1);
    const Floats z = apart(2);
    Floats reach(query.reach);
    if (query.radii != nullptr) reach = reach + (Floats(query.margin) + Floats::gather(query.radii, slots));
    const std::size_t left = query.count - i;
    const unsigned meant = left < Floats::kWidth ? (1U << left) - 1 : ~0U;
    const unsigned is_near = bits(x * x + y * y + z * z < reach * reach) & meant;
    // Branchless: which points are near is unpredictable.
    Floats::keep(slots, is_near, end);
    end += std::popcount(is_near);
  }
  return static_cast<std::size_t>(end - near);
}

}  // namespace hardball
