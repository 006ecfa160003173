// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "hardball/errors/export.hpp"
#include "hardball/statistics/measurement.hpp"

namespace hardball {

/// All of the measurements as a JSON array of objects, whose keys are the names of the members of
/// Measurement, Quantity and Column, without "is_". Numbers read back to the same bits; null stands for a
/// missing number, and for the tolerance of a theory that is given for comparison only.
HARDBALL_EXPORT std::string measurements_json(std::span<const Measurement> measurements);

}  // namespace hardball
