// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/errors/export.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/tuning/unit_costs.hpp"

namespace hardball {

/// Measures what the steps of the event loop cost on this machine, by running small gases of several
/// densities with cells of several sizes. `seconds` reads a monotonic clock [s]. Cost: less than
/// 0.5 s.
HARDBALL_EXPORT UnitCosts measure_unit_costs(const Function<double()>& seconds);

}  // namespace hardball
