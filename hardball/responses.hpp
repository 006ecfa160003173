// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// What happens when spheres touch: restitution, roughness, merging, passing, by pairs of species, or a
/// function of the caller; and potentials of steps, which act before they touch.
#include "hardball/errors/compilation.hpp"
#include "hardball/interaction/interactions.hpp"
