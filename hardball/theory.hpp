// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Kinetic theory of gases and dense fluids, the averages over spheres that it needs, and their temperature.
#include "hardball/errors/compilation.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/theory/fluid_theory.hpp"
#include "hardball/theory/gas_statistics.hpp"
#include "hardball/theory/kinetic_theory.hpp"
#include "hardball/theory/species_list.hpp"
#include "hardball/theory/thermal_motion.hpp"
