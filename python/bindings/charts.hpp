// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "apps/chart/chart.hpp"

namespace hardball::python {

/// Charts as dicts, for the part of the package that draws them.
pybind11::list list_of(const std::vector<chart::Chart>& charts);

}  // namespace hardball::python
