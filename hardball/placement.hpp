// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Initial positions, on a lattice or at random where there is room, and random sizes.
#include "hardball/errors/compilation.hpp"
#include "hardball/placement/placement.hpp"
#include "hardball/placement/radii.hpp"
