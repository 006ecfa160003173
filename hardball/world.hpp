// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// The box, the spheres in it, and whether they overlap.
#include "hardball/world/audit.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/pair_event.hpp"
#include "hardball/world/step_levels.hpp"
#include "hardball/world/totals.hpp"
#include "hardball/world/walls.hpp"
#include "hardball/world/world.hpp"
