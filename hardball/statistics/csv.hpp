// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "hardball/errors/export.hpp"
#include "hardball/statistics/measurement.hpp"

namespace hardball {

/// The columns of a measurement as comma-separated values. The first line names them, each with its unit, as
/// in "radius [L]"; numbers read back to the same bits, and "nan" stands for a missing number.
HARDBALL_EXPORT std::string columns_csv(const Measurement& measurement);

/// The quantities of all measurements, a line for each: measure, name, value, error, theory, unit, the
/// length of the transient left out, which is that of the whole run if the transient is not over, the
/// tolerance of the theory, and why there is no value.
HARDBALL_EXPORT std::string quantities_csv(std::span<const Measurement> measurements);

}  // namespace hardball
