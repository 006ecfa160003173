// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Spheres in motion: runs, listeners, edits, and questions about what comes next.
#include "hardball/queries/queries.hpp"
#include "hardball/simulation/measure_unit_costs.hpp"
#include "hardball/simulation/simulation.hpp"
