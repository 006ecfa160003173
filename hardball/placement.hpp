// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Initial positions: on a lattice, or at random where there is room.
#include "hardball/placement/placement.hpp"
