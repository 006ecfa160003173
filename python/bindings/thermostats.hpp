// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include "hardball/thermostats/thermostat.hpp"

namespace hardball::python {

/// Error: the object is not a thermostat.
ThermostatKind thermostat_of(const pybind11::handle& object);

}  // namespace hardball::python
