// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Everything needed by programs that use the library.
#include "hardball/errors/error.hpp"
#include "hardball/interaction/interactions.hpp"
#include "hardball/measure/csv.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/simulation/measure_unit_costs.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/thermostats/thermostat.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/world.hpp"
