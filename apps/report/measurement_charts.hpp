// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/chart/chart.hpp"
#include "hardball/measure/measurement.hpp"

namespace hardball::report {

/// A name of a column or quantity for people: "mean_free_time" without the underscores.
std::string readable(std::string name);

/// Charts of a measured table: one for each argument and unit of values, with their errors and theories.
/// Where points are many they make a line, and their errors a band. Charts without a point are left out.
std::vector<chart::Chart> charts_of(const Measurement& measurement);

}  // namespace hardball::report
