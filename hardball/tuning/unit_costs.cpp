// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/unit_costs.hpp"

#include <cmath>

namespace hardball {

bool are_meaningful(const UnitCosts& costs) {
  for (const double cost : {costs.contact, costs.enter, costs.cell, costs.prediction}) {
    if (!(cost >= 0) || !std::isfinite(cost)) return false;
  }
  return costs.prediction > 0 && costs.enter + costs.cell > 0;
}

UnitCosts costs_with_memory(const GasStatistics& statistics, UnitCosts costs) {
  // Measured, docs/theory.md.
  constexpr double kFar = 2;
  if (statistics.spheres > kVeryManySpheres) {
    costs.cell *= kFar;
    costs.prediction *= kFar;
  }
  return costs;
}

}  // namespace hardball
