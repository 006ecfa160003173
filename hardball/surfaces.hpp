// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Walls and obstacles: planes, tubes, hollow spheres, fixed spheres, and what they are made of.
#include "hardball/errors/compilation.hpp"
#include "hardball/surfaces/surface.hpp"
