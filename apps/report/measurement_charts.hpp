// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "apps/chart/chart.hpp"
#include "apps/report/species_names.hpp"
#include "hardball/statistics/measurement.hpp"

namespace hardball::report {

/// Charts of a measured table: one for each argument and unit of values, with their errors and theories. Many
/// points are drawn as a line, and their errors as a band. Charts without points are omitted. Curves are
/// named by `species`, those of the measured spheres.
std::vector<chart::Chart> charts_of(const Measurement& measurement,
                                    const SpeciesNames& species = SpeciesNames());

}  // namespace hardball::report
