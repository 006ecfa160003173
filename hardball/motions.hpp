// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Motions that are prescribed to kinematic spheres and to walls: rotations, oscillations and timetables.
#include "hardball/errors/compilation.hpp"
#include "hardball/motions/driven_motion.hpp"
#include "hardball/motions/prescribed_motion.hpp"
