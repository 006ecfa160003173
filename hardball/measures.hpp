// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// What is measured during a run: pressure, rates, distributions, diffusion, each with its error and its
/// theory; and these results as text.
#include "hardball/errors/compilation.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/statistics/measurement.hpp"
#include "hardball/statistics/measurement_json.hpp"
