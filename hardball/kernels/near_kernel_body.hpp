// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

// Compiled once for each instruction set: see contact_kernel_body.hpp for what this file may contain.

#include <bit>
#include <cstddef>
#include <cstdint>

#include "hardball/kernels/near_kernel.hpp"
#include "hardball/kernels/vector_of_lanes.hpp"

namespace hardball {

/// The kernel for all kinds of query.
template <class Lanes>
std::size_t pick_near(const NearQuery& query, std::uint32_t* near) {
  const auto from_place = [](const Lanes& point, double place, double period, double inverse_period) {
    const Lanes apart = point - Lanes(place);
    return apart - round_to_integer(apart * Lanes(inverse_period)) * Lanes(period);
  };
  std::uint32_t* end = near;
  for (std::size_t i = 0; i < query.count; i += Lanes::kWidth) {
    const std::uint32_t* const slots = query.slots + i;
    VectorOfLanes<Lanes> point;
    Lanes::load(query.points, slots, point);
    const Lanes x = from_place(point.x, query.place.x, query.period.x, query.inverse_period.x);
    const Lanes y = from_place(point.y, query.place.y, query.period.y, query.inverse_period.y);
    const Lanes z = from_place(point.z, query.place.z, query.period.z, query.inverse_period.z);
    Lanes reach(query.reach);
    if (query.radii != nullptr) reach = reach + Lanes::gather(query.radii, slots);
    const std::size_t left = query.count - i;
    const unsigned meant = left < Lanes::kWidth ? (1U << left) - 1 : ~0U;
    const unsigned is_near = bits(x * x + y * y + z * z < reach * reach) & meant;
    // Branchless: which points are near is unpredictable.
    Lanes::keep(slots, is_near, end);
    end += std::popcount(is_near);
  }
  return static_cast<std::size_t>(end - near);
}

}  // namespace hardball
