// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// The box, the spheres in it, and whether they overlap.
#include "hardball/world/audit.hpp"
#include "hardball/world/walls.hpp"
#include "hardball/world/world.hpp"
