// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

// Compiled once for each instruction set: see contact_kernel_body.hpp for what this file may contain.

#include <bit>
#include <cstddef>
#include <cstdint>

#include "hardball/errors/language.hpp"
#include "hardball/kernels/near_kernel.hpp"

namespace hardball {

/// The kernel for all kinds of query.
template <class Floats>
std::size_t pick_near(const NearQuery& query, std::uint32_t* near) {
  using Integers = typename Floats::Integers;
  static_assert(PointBlock::kRoom % Floats::kWidth == 0);
  const Integers place[3] = {Integers(query.place[0]), Integers(query.place[1]), Integers(query.place[2])};
  const Floats grid[3] = {Floats(query.grid[0]), Floats(query.grid[1]), Floats(query.grid[2])};
  const Integers no_slot(PointBlock::kNoSlot);
  std::uint32_t* end = near;
  for (std::size_t i = 0; i < query.count; ++i) {
    const PointBlock& block = query.blocks[query.numbers[i]];
    for (std::size_t lane = 0; lane < PointBlock::kRoom; lane += Floats::kWidth) {
      const std::uint32_t* const slots = block.slots.data() + lane;
      const auto apart = [&](std::size_t axis) {
        return to_floats(Integers::load(block.places[axis].data() + lane) - place[axis]) * grid[axis];
      };
      const Floats x = apart(0);
      const Floats y = apart(1);
      const Floats z = apart(2);
      const auto is_gap = Integers::load(slots) == no_slot;
      Floats reach(query.reach);
      if (query.radii != nullptr) {
        std::uint32_t owners[Floats::kWidth];
        select(is_gap, Integers(0U), Integers::load(slots)).store(owners);
        reach = reach + (Floats(query.margin) + Floats::gather(query.radii, owners));
      }
      const unsigned is_near = bits((x * x + y * y + z * z < reach * reach) & not_(is_gap));
      // Branchless: which points are near is unpredictable.
      Floats::keep(slots, is_near, end);
      end += std::popcount(is_near);
    }
  }
  return static_cast<std::size_t>(end - near);
}

}  // namespace hardball
