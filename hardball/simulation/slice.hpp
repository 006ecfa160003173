// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hardball/simulation/simulation.hpp"

namespace hardball {

/// Steps that take about 10 ms: for runs between which somebody
/// looks at signals or shows the progress. See RunLimits::steps.
std::uint64_t steps_per_slice(const Simulation& simulation);

}  // namespace hardball
