// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hardball/simulation/simulation.hpp"

namespace hardball {

/// So many steps that a run of them takes about a hundredth of a second: for runs between which somebody
/// looks at signals or shows the progress. See RunLimits::steps.
std::uint64_t steps_per_slice(const Simulation& simulation);

}  // namespace hardball
