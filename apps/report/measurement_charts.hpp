// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/chart/chart.hpp"
#include "hardball/measure/measurement.hpp"

namespace hardball::report {

/// A readable name of a column or quantity: "mean free time" for "mean_free_time".
std::string readable(std::string name);

/// Charts of a measured table: one for each argument and unit of values, with their errors and theories. Many
/// points are drawn as a line, and their errors as a band. Charts without points are omitted.
std::vector<chart::Chart> charts_of(const Measurement& measurement);

}  // namespace hardball::report
