// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/simulation/slice.hpp"

#include <algorithm>
#include <cstddef>

namespace hardball {

std::uint64_t steps_per_slice(const Simulation& simulation) {
  constexpr std::uint64_t kSteps = 1 << 14;
  constexpr std::uint64_t kPairs = 1 << 23;
  if (simulation.engine() != EngineKind::all_pairs) return kSteps;
  return std::clamp<std::uint64_t>(kPairs / std::max<std::size_t>(simulation.size(), 1), 1, kSteps);
}

}  // namespace hardball
