// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Robots on trajectories: what they would touch first, and how near they come.
#include "hardball/errors/compilation.hpp"
#include "hardball/robots/joint_trajectory.hpp"
#include "hardball/robots/obstacles.hpp"
#include "hardball/robots/robot.hpp"
#include "hardball/robots/robot_queries.hpp"
#include "hardball/robots/sphere_file.hpp"
